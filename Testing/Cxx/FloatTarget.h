// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// A renderer's picture on a target of float, which shows what 8 bits hide.

#ifndef FloatTarget_h
#define FloatTarget_h

#include "vtkFramebufferPass.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderer.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderWindow.h"
#include "vtkTextureObject.h"
#include "vtk_glew.h"

#include <cstddef>
#include <vector>

namespace
{
// RGBA of the only renderer of a window.
inline std::vector<float> RenderFloat(vtkRenderWindow* window, vtkRenderer* plainRenderer)
{
  window->Render(); // vtkFramebufferPass draws no volume in a window's first frame
  vtkNew<vtkRenderStepsPass> steps;
  vtkNew<vtkFramebufferPass> target;
  target->SetDelegatePass(steps);
  target->SetColorFormat(vtkTextureObject::Float32);
  auto* renderer = vtkOpenGLRenderer::SafeDownCast(plainRenderer);
  renderer->SetPass(target);
  window->Render();
  vtkTextureObject* texture = target->GetColorTexture();
  std::vector<float> pixels(std::size_t(4) * texture->GetWidth() * texture->GetHeight());
  texture->Activate();
  glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, pixels.data());
  texture->Deactivate();
  renderer->SetPass(nullptr);
  target->ReleaseGraphicsResources(window);
  return pixels;
}
}

#endif
