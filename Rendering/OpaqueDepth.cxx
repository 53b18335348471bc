// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "OpaqueDepth.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtk_glew.h"

#include <algorithm>

namespace
{
// Depths in perspective crowd near the eye: this near 24 bits are a ten thousandth of the way.
const double NearestPart = 1.0e-3;

// Finer than the froxels, which take the depth at their middle.
const int TexelsPerFroxel = 2;

// Along the view's z; bounds as vtkProp has them.
double LeastDepth(const double bounds[6], const double worldToView[16])
{
  double least = VTK_DOUBLE_MAX;
  for (int corner = 0; corner < 8; ++corner)
  {
    double point[4] = { bounds[corner & 1], bounds[2 + ((corner >> 1) & 1)], bounds[4 + ((corner >> 2) & 1)],
      1.0 };
    vtkMatrix4x4::MultiplyPoint(worldToView, point, point);
    least = std::min(least, point[2]);
  }
  return least;
}

// From OpenGL's eye space, which looks along -z.
vtkSmartPointer<vtkMatrix4x4> ProjectionOf(const SweepGrid& grid, const double range[2])
{
  auto projection = vtkSmartPointer<vtkMatrix4x4>::New();
  const double* window = grid.GetWindow();
  const bool isPerspective = grid.GetIsPerspective();
  for (int axis = 0; axis < 2; ++axis)
  {
    const double side = window[2 * axis + 1] - window[2 * axis];
    const double middle = (window[2 * axis] + window[2 * axis + 1]) / side;
    projection->SetElement(axis, axis, 2.0 / side);
    projection->SetElement(axis, isPerspective ? 2 : 3, isPerspective ? middle : -middle);
  }
  const double length = range[1] - range[0];
  const double sum = (range[0] + range[1]) / length;
  projection->SetElement(2, 2, isPerspective ? -sum : -2.0 / length);
  projection->SetElement(2, 3, isPerspective ? -2.0 * range[0] * range[1] / length : -sum);
  projection->SetElement(3, 2, isPerspective ? -1.0 : 0.0);
  projection->SetElement(3, 3, isPerspective ? 0.0 : 1.0);
  return projection;
}

// At the view's origin, with the view as its model transform.
vtkSmartPointer<vtkCamera> CameraOf(const SweepGrid& grid, const double range[2])
{
  auto camera = vtkSmartPointer<vtkCamera>::New();
  camera->SetPosition(0.0, 0.0, 0.0);
  camera->SetFocalPoint(0.0, 0.0, -1.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  double worldToEye[16];
  std::copy(grid.GetWorldToView(), grid.GetWorldToView() + 16, worldToEye);
  std::transform(worldToEye + 8, worldToEye + 12, worldToEye + 8, [](double x) { return -x; });
  camera->SetModelTransformMatrix(worldToEye);
  camera->SetParallelProjection(grid.GetIsPerspective() ? 0 : 1);
  camera->SetExplicitProjectionTransformMatrix(ProjectionOf(grid, range));
  camera->UseExplicitProjectionTransformMatrixOn();
  return camera;
}

// While it lives, the renderer has another camera.
class CameraChange
{
public:
  CameraChange(vtkRenderer* renderer, vtkCamera* camera)
    : Renderer(renderer)
    , Former(renderer->GetActiveCamera())
  {
    renderer->SetActiveCamera(camera);
  }
  ~CameraChange() { this->Renderer->SetActiveCamera(this->Former); }
  CameraChange(const CameraChange&) = delete;
  CameraChange& operator=(const CameraChange&) = delete;

private:
  vtkRenderer* Renderer;
  vtkSmartPointer<vtkCamera> Former;
};
}

//------------------------------------------------------------------------------
// A volume has none, whatever VTK says; and asking it for its time of change gives its property a gradient opacity.
OpaqueDepth::Props OpaqueDepth::OpaqueProps(vtkRenderer* renderer)
{
  Props props;
  vtkPropCollection* all = renderer->GetViewProps();
  vtkCollectionSimpleIterator iterator;
  all->InitTraversal(iterator);
  while (vtkProp* prop = all->GetNextProp(iterator))
  {
    // a volume says that it has opaque geometry, and draws none
    const bool isVolume = vtkVolume::SafeDownCast(prop) != nullptr;
    if (prop->GetVisibility() && !isVolume && prop->GetBounds() && prop->HasOpaqueGeometry())
    {
      props.push_back(prop);
    }
  }
  return props;
}

//------------------------------------------------------------------------------
bool OpaqueDepth::Draw(vtkRenderer* renderer, const Props& props, const SweepGrid& grid)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  const Stamp stamp = StampOf(props, grid);
  if (this->Texture.IsAlive(window) && stamp == this->Drawn)
  {
    return true;
  }
  this->FindRange(props, grid);
  if (!this->Allocate(window, grid))
  {
    return false;
  }
  this->DrawProps(renderer, props, grid);
  this->Drawn = stamp;
  this->Time.Modified();
  return true;
}

//------------------------------------------------------------------------------
OpaqueDepth::Stamp OpaqueDepth::StampOf(const Props& props, const SweepGrid& grid)
{
  Stamp stamp;
  stamp.first.assign(grid.GetWorldToView(), grid.GetWorldToView() + 16);
  stamp.first.insert(stamp.first.end(), grid.GetWindow(), grid.GetWindow() + 4);
  stamp.first.insert(stamp.first.end(), grid.GetSize(), grid.GetSize() + 3);
  stamp.first.push_back(grid.GetDepth(0));
  stamp.first.push_back(grid.GetSliceDistance());
  for (vtkProp* prop : props)
  {
    stamp.second.emplace_back(prop, std::max(prop->GetMTime(), prop->GetRedrawMTime()));
  }
  return stamp;
}

//------------------------------------------------------------------------------
// From the nearest thing that casts into the grid to where the grid ends.
void OpaqueDepth::FindRange(const Props& props, const SweepGrid& grid)
{
  double nearest = grid.GetDepth(0);
  for (vtkProp* prop : props)
  {
    nearest = std::min(nearest, LeastDepth(prop->GetBounds(), grid.GetWorldToView()));
  }
  this->Range[1] = grid.GetDepth(grid.GetSize()[2]);
  this->Range[0] = grid.GetIsPerspective() ? NearestPart * this->Range[1] : nearest - grid.GetSliceDistance();
}

//------------------------------------------------------------------------------
bool OpaqueDepth::Allocate(vtkOpenGLRenderWindow* window, const SweepGrid& grid)
{
  const int largest = vtkTextureObject::GetMaximumTextureSize(window);
  int size[2];
  for (int axis = 0; axis < 2; ++axis)
  {
    size[axis] = std::min(TexelsPerFroxel * grid.GetSize()[axis], largest);
  }
  if (this->Texture.IsAlive(window) && std::equal(size, size + 2, this->Size))
  {
    return true;
  }
  std::copy(size, size + 2, this->Size);
  vtkTextureObject* texture = this->Texture.Renew(window);
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  return texture->AllocateDepth(size[0], size[1], vtkTextureObject::Fixed24);
}

//------------------------------------------------------------------------------
void OpaqueDepth::DrawProps(vtkRenderer* renderer, const Props& props, const SweepGrid& grid)
{
  vtkOpenGLState* state = this->Texture->GetContext()->GetState();
  const CameraChange change(renderer, CameraOf(grid, this->Range));
  state->Push();
  unsigned int framebuffer = 0;
  glGenFramebuffers(1, &framebuffer);
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, this->Texture->GetHandle(), 0);
  state->vtkglDrawBuffer(GL_NONE);
  state->vtkglReadBuffer(GL_NONE);
  state->vtkglViewport(0, 0, this->Size[0], this->Size[1]);
  state->SetEnumState(GL_SCISSOR_TEST, false);
  state->SetEnumState(GL_BLEND, false);
  state->SetEnumState(GL_DEPTH_TEST, true);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglDepthMask(GL_TRUE);
  const float farthest = 1.0F;
  glClearBufferfv(GL_DEPTH, 0, &farthest);
  for (vtkProp* prop : props)
  {
    prop->RenderOpaqueGeometry(renderer);
  }
  state->Pop();
  glDeleteFramebuffers(1, &framebuffer);
}

//------------------------------------------------------------------------------
std::size_t OpaqueDepth::GetMemorySize() const
{
  return this->Texture ? std::size_t(4) * this->Size[0] * this->Size[1] : 0;
}

//------------------------------------------------------------------------------
void OpaqueDepth::Release(vtkWindow* window)
{
  this->Texture.Release(window);
  this->Drawn = {};
}
