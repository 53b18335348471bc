// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "IsosurfaceTexture.h"

#include "RayUniforms.h"
#include "SceneNeeds.h"
#include "TransferFunctionTerm.h"
#include "vtkOpticsVolumeMapper.h"
#include "vtkOpticsVolumeProperty.h"

#include "vtkColorTransferFunction.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkVolume.h"

#include <algorithm>
#include <numeric>

namespace
{
std::vector<int> SortedByValue(vtkOpticsVolumeProperty* optics)
{
  std::vector<int> order(optics->GetNumberOfIsosurfaces());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
    [optics](int a, int b) { return optics->GetIsosurfaceValue(a) < optics->GetIsosurfaceValue(b); });
  return order;
}

// Its own colour, or that of the colour function at normalised scalar; red is -1 where the data has it.
void SurfaceColor(const OpticsScene& scene, int index, double scalar, double rgb[3])
{
  if (scene.Optics->GetIsosurfaceHasColor(index))
  {
    scene.Optics->GetIsosurfaceColor(index, rgb);
  }
  else if (HasOwnColor(scene))
  {
    std::fill(rgb, rgb + 3, -1.0);
  }
  else
  {
    double range[2];
    TransferFunctionTerm::GetColorRange(scene, range);
    scene.Volume->GetProperty()->GetRGBTransferFunction()->GetColor(
      range[0] + scalar * (range[1] - range[0]), rgb);
  }
}
}

//------------------------------------------------------------------------------
void IsosurfaceTexture::Update(const OpticsScene& scene)
{
  double range[2];
  ScalarRange(scene, scene.OpacityComponent, range);
  const std::vector<int> order = SortedByValue(scene.Optics);
  std::vector<float> texels(8 * order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const double scalar = (scene.Optics->GetIsosurfaceValue(order[i]) - range[0]) / (range[1] - range[0]);
    double rgb[3];
    SurfaceColor(scene, order[i], scalar, rgb);
    float* surface = &texels[4 * (order.size() + i)];
    texels[4 * i] = static_cast<float>(std::clamp(scalar, -1.0e30, 1.0e30));
    std::copy(rgb, rgb + 3, surface);
    surface[3] = static_cast<float>(scene.Optics->GetIsosurfaceOpacity(order[i]));
  }
  if (this->Texture.IsAlive(scene.Window) && texels == this->Texels)
  {
    return;
  }
  this->Texels = texels;
  this->Texture.Renew(scene.Window);
  this->Texture->Create2DFromRaw(static_cast<unsigned int>(order.size()), 2, 4, VTK_FLOAT, texels.data());
  this->Texture->SetMinificationFilter(vtkTextureObject::Nearest);
  this->Texture->SetMagnificationFilter(vtkTextureObject::Nearest);
}

//------------------------------------------------------------------------------
void IsosurfaceTexture::SetUniforms(vtkShaderProgram* program)
{
  this->Texture.Bind("in_opticsIsosurfaces", program);
  program->SetUniformi("in_opticsNumberOfIsosurfaces", static_cast<int>(this->Texture->GetWidth()));
}

//------------------------------------------------------------------------------
std::size_t IsosurfaceTexture::GetMemorySize() const
{
  return this->Texture ? sizeof(float) * this->Texels.size() : 0;
}
