// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FrameAbort.h"

#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtk_glew.h"

#include <algorithm>
#include <cmath>

namespace
{
using Rectangle = ScissorScope::Rectangle;

// On each side: sixteen parts, of which the fullest has far less than a quarter of the work.
constexpr int Parts = 4;

// The bounds of what is drawn in the viewport's pixels; all of it where the camera is in the volume.
Rectangle ProjectedBounds(vtkRenderer* renderer, vtkVolume* volume, const Rectangle& viewport)
{
  vtkMatrix4x4* projection = renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(
    renderer->GetTiledAspectRatio(), -1.0, 1.0);
  const double* bounds = volume->GetBounds();
  double least[2] = { 1.0, 1.0 }, largest[2] = { -1.0, -1.0 };
  for (int corner = 0; corner < 8; ++corner)
  {
    double point[4] = { bounds[corner & 1], bounds[2 + ((corner >> 1) & 1)], bounds[4 + ((corner >> 2) & 1)],
      1.0 };
    projection->MultiplyPoint(point, point);
    if (!(point[3] > 0.0) || point[2] < -point[3])
    {
      return viewport;
    }
    for (int axis = 0; axis < 2; ++axis)
    {
      const double place = std::clamp(point[axis] / point[3], -1.0, 1.0);
      least[axis] = std::min(least[axis], place);
      largest[axis] = std::max(largest[axis], place);
    }
  }
  Rectangle inPixels = viewport;
  for (int axis = 0; axis < 2; ++axis)
  {
    const double half = 0.5 * viewport[2 + axis];
    const int first = static_cast<int>(std::floor((least[axis] + 1.0) * half)) - 1; // a pixel for rounding
    const int last = static_cast<int>(std::ceil((largest[axis] + 1.0) * half)) + 1;
    inPixels[axis] = viewport[axis] + first;
    inPixels[2 + axis] = last - first;
  }
  return inPixels;
}

Rectangle Overlap(const Rectangle& a, const Rectangle& b)
{
  Rectangle overlap{};
  for (int axis = 0; axis < 2; ++axis)
  {
    overlap[axis] = std::max(a[axis], b[axis]);
    const int end = std::min(a[axis] + a[2 + axis], b[axis] + b[2 + axis]);
    overlap[2 + axis] = std::max(end - overlap[axis], 0);
  }
  return overlap;
}
}

//------------------------------------------------------------------------------
bool CanFrameBeAborted(vtkRenderWindow* window)
{
  return window && window->HasObserver(vtkCommand::AbortCheckEvent);
}

//------------------------------------------------------------------------------
bool IsFrameAborted(vtkRenderWindow* window)
{
  if (!CanFrameBeAborted(window))
  {
    return false;
  }
  if (!window->GetAbortRender() && !window->GetInAbortCheck())
  {
    glFinish();
    window->SetInAbortCheck(1);
    window->InvokeEvent(vtkCommand::AbortCheckEvent);
    window->SetInAbortCheck(0);
    window->MakeCurrent();
  }
  return window->GetAbortRender() != 0;
}

//------------------------------------------------------------------------------
ScissorScope::ScissorScope(vtkOpenGLRenderWindow* window)
  : Window(window)
  , WasOn(glIsEnabled(GL_SCISSOR_TEST) == GL_TRUE)
{
  glGetIntegerv(GL_SCISSOR_BOX, this->Before.data());
}

//------------------------------------------------------------------------------
ScissorScope::~ScissorScope()
{
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglScissor(this->Before[0], this->Before[1], this->Before[2], this->Before[3]);
  this->WasOn ? state->vtkglEnable(GL_SCISSOR_TEST) : state->vtkglDisable(GL_SCISSOR_TEST);
}

//------------------------------------------------------------------------------
void ScissorScope::Restrict(const Rectangle& rectangle)
{
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(rectangle[0], rectangle[1], rectangle[2], rectangle[3]);
}

//------------------------------------------------------------------------------
std::vector<Rectangle> ScissorScope::Tiles(vtkRenderer* renderer, vtkVolume* volume) const
{
  Rectangle viewport{};
  glGetIntegerv(GL_VIEWPORT, viewport.data());
  const Rectangle drawn = ProjectedBounds(renderer, volume, viewport);
  const Rectangle whole = Overlap(drawn, this->WasOn ? Overlap(viewport, this->Before) : viewport);
  std::vector<Rectangle> tiles;
  for (int tile = 0; tile < Parts * Parts; ++tile)
  {
    const int place[2] = { tile % Parts, tile / Parts };
    Rectangle part{};
    for (int axis = 0; axis < 2; ++axis)
    {
      const int first = whole[2 + axis] * place[axis] / Parts;
      part[axis] = whole[axis] + first;
      part[2 + axis] = whole[2 + axis] * (place[axis] + 1) / Parts - first;
    }
    if (part[2] > 0 && part[3] > 0)
    {
      tiles.push_back(part);
    }
  }
  return tiles;
}
