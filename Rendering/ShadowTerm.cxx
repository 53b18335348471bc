// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShadowTerm.h"

#include "LightUniforms.h"
#include "LightViews.h"
#include "SceneNeeds.h"
#include "SweepViews.h"
#include "vtkOpticsVolumeMapper.h"
#include "vtkOpticsVolumeProperty.h"

#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtk_glew.h"

#include <algorithm>
#include <string>

namespace
{
using F = OpticsFeature;
using Triple = ShadowAtlas::Triple;

// What VTK's own text and the other terms may need, and what a view does (a matrix and two vectors, each vector
// as large as one of four numbers).
const int UniformsOfOthers = 512;
const int UniformsOfView = 24;

std::size_t MostViews()
{
  int uniforms = 0;
  glGetIntegerv(GL_MAX_FRAGMENT_UNIFORM_COMPONENTS, &uniforms);
  return std::max(uniforms - UniformsOfOthers, 0) / UniformsOfView;
}

double DistanceFromMiddle(vtkLight* light, const double corners[24])
{
  double offset[3] = { 0.0, 0.0, 0.0 };
  for (int i = 0; i < 24; ++i)
  {
    offset[i % 3] += 0.125 * corners[i];
  }
  vtkMath::Subtract(offset, light->GetTransformedPosition(), offset);
  return vtkMath::Norm(offset);
}

// A texture has at least one texel.
Triple SizeOf(const SweepGrid& grid)
{
  const int* size = grid.GetSize();
  return { std::max(size[0], 1), std::max(size[1], 1), std::max(size[2], 1) };
}

void AppendVector(std::vector<float>& vectors, const Triple& vector)
{
  for (const int number : vector)
  {
    vectors.push_back(static_cast<float>(number));
  }
}

void SetVectors(vtkShaderProgram* program, const char* name, const float* vectors, std::size_t count)
{
  program->SetUniform3fv(name, static_cast<int>(count), reinterpret_cast<const float(*)[3]>(vectors));
}
}

//------------------------------------------------------------------------------
ShadowTerm::ShadowTerm() = default;

//------------------------------------------------------------------------------
ShadowTerm::~ShadowTerm() = default;

//------------------------------------------------------------------------------
bool ShadowTerm::IsActive(const OpticsScene& scene)
{
  if (!WantsShadows(scene))
  {
    return false;
  }
  const std::string reason = FindUnsupported(scene);
  if (!reason.empty())
  {
    scene.Mapper->Say(
      "Shadows do not support " + reason + ": light is VTK's own. ShadowsOff() silences this.");
  }
  return reason.empty();
}

//------------------------------------------------------------------------------
bool ShadowTerm::Prepare(const OpticsScene& scene)
{
  this->FindViews(scene);
  if (this->Views.empty() || !this->Allocate(scene))
  {
    return false;
  }
  this->DrawGeometry(scene);
  return true;
}

//------------------------------------------------------------------------------
void ShadowTerm::FindViews(const OpticsScene& scene)
{
  this->Views.clear();
  this->ViewsOfLights.clear();
  double corners[24];
  VolumeCorners(scene, corners);
  for (vtkLight* light : LightsThatAreOn(scene.Renderer))
  {
    const std::size_t first = this->Views.size();
    if (light->GetShadowAttenuation() > 0.0F)
    {
      this->AddLight(scene, light, corners);
    }
    this->ViewsOfLights.push_back({ static_cast<float>(first), static_cast<float>(this->Views.size()),
      std::min(light->GetShadowAttenuation(), 1.0F) });
  }
}

//------------------------------------------------------------------------------
void ShadowTerm::AddLight(const OpticsScene& scene, vtkLight* light, const double corners[24])
{
  const std::vector<SweepGrid::View> views = ViewsOfLight(light, corners);
  const std::size_t most = MostViews();
  if (this->Views.size() + views.size() > most)
  {
    scene.Mapper->Say("Shadows are left out of some lights: this OpenGL has uniforms for " +
      std::to_string(most) + " views of the volume, and a light takes one, or " +
      std::to_string(LargestNumberOfViews) +
      " where it is in the volume or near it. Switch lights off, move them away, narrow their cone angle, or "
      "set their shadow attenuation to 0.");
    return;
  }
  for (const SweepGrid::View& view : views)
  {
    this->Views.push_back(
      { SweepGrid(view, corners, SweepResolution(scene)), DistanceFromMiddle(light, corners) });
  }
}

//------------------------------------------------------------------------------
bool ShadowTerm::Allocate(const OpticsScene& scene)
{
  std::vector<Triple> sizes;
  for (const LightView& view : this->Views)
  {
    sizes.push_back(SizeOf(view.Grid));
  }
  const bool isAllocated = this->Atlas.Allocate(scene.Window, sizes, scene.Mapper->GetVisibilityPrecision());
  if (!isAllocated)
  {
    scene.Mapper->Say(
      "Shadows are left out: the grids of all lights do not fit into a 3D texture of this OpenGL. "
      "Lower VisibilityGridSize of the mapper, or switch lights off.");
  }
  this->Sweeps.resize(this->Views.size());
  for (auto& sweep : this->Sweeps)
  {
    sweep = sweep ? sweep : vtkSmartPointer<vtkVisibilitySweep>::New();
  }
  return isAllocated;
}

//------------------------------------------------------------------------------
void ShadowTerm::DrawGeometry(const OpticsScene& scene)
{
  const OpaqueDepth::Props props = OpaqueDepth::OpaqueProps(scene.Renderer);
  if (props.empty())
  {
    this->ReleaseGeometry(scene.Window);
    return;
  }
  this->Geometry.resize(this->Views.size());
  for (std::size_t view = 0; view < this->Views.size(); ++view)
  {
    const SweepGrid& grid = this->Views[view].Grid;
    if (!grid.IsEmpty() && !this->Geometry[view].Draw(scene.Renderer, props, grid))
    {
      scene.Mapper->Say(
        "Opaque geometry casts no shadow into the volume: this OpenGL does not draw it from a "
        "light's point of view.");
      this->ReleaseGeometry(scene.Window);
      return;
    }
  }
}

//------------------------------------------------------------------------------
void ShadowTerm::AddFeatures(const OpticsScene& scene, OpticsFeatures& features)
{
  features.Add(F::Shadows);
  features.Add(IntegratesInData(scene) ? F::OwnOpacityInData : F::OwnOpacity);
  AddSweepFeatures(scene, features);
  features.NumberOfShadowViews = static_cast<int>(this->Views.size());
  if (HasLineVoxels(scene))
  {
    features.Add(F::LineShadows);
    features.NumberOfLights = CountLights(scene.Renderer);
  }
}

//------------------------------------------------------------------------------
void ShadowTerm::SetUniforms(const OpticsScene& scene, vtkShaderProgram* program)
{
  if (HasLineVoxels(scene))
  {
    const std::vector<float> shares = SharesOfLights(scene.Renderer);
    program->SetUniform1fv("in_opticsLineLightShares", static_cast<int>(shares.size()), shares.data());
  }
  SetVectors(program, "in_opticsShadowOfLight", this->ViewsOfLights[0].data(), this->ViewsOfLights.size());
}

//------------------------------------------------------------------------------
void ShadowTerm::BeforeDraw(const OpticsScene& scene, vtkShaderProgram* program)
{
  const vtkVisibilitySweep::Volume volume = SweptVolume(scene, program);
  if (!this->SweepAll(scene, volume))
  {
    const std::vector<float> noViews(3 * this->ViewsOfLights.size(), 0.0F);
    SetVectors(program, "in_opticsShadowOfLight", noViews.data(), this->ViewsOfLights.size());
  }
  this->Atlas.GetTexture().Bind("in_opticsShadows", program);
  this->SetViewUniforms(volume.TextureToWorld, program);
}

//------------------------------------------------------------------------------
bool ShadowTerm::SweepAll(const OpticsScene& scene, const vtkVisibilitySweep::Volume& volume)
{
  if (IsSelection(scene))
  {
    return false;
  }
  const std::string reason = FindUnsweepable(scene);
  if (!reason.empty())
  {
    scene.Mapper->Say("Shadows are left out: " + reason + " ShadowsOff() silences this.");
    return false;
  }
  for (std::size_t view = 0; view < this->Views.size(); ++view)
  {
    if (!this->Views[view].Grid.IsEmpty() && !this->Sweep(scene, volume, view))
    {
      scene.Mapper->Say("Shadows are left out: this OpenGL does not draw on the " +
        std::to_string(scene.Mapper->GetVisibilityPrecision()) +
        "-bit textures that they are found in, or does not link their shader program. Try another "
        "SetVisibilityPrecision(); ShadowsOff() silences this.");
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool ShadowTerm::Sweep(const OpticsScene& scene, vtkVisibilitySweep::Volume volume, std::size_t view)
{
  if (!this->Geometry.empty())
  {
    OpaqueDepth& geometry = this->Geometry[view];
    volume.Geometry = geometry.GetTexture();
    std::copy(geometry.GetRange(), geometry.GetRange() + 2, volume.GeometryRange);
    volume.Times.emplace_back(volume.Geometry, geometry.GetTime());
  }
  vtkVisibilitySweep* sweep = this->Sweeps[view];
  const double angle = scene.Optics->GetShadowAngle();
  // always the sweep of directions: a disk's weights are about the slices' normal
  sweep->SetPrecision(scene.Mapper->GetVisibilityPrecision());
  sweep->SetConeAngle(angle);
  sweep->SetNumberOfDirections(angle > 0.0 ? scene.Mapper->GetVisibilitySamples() : 1);
  sweep->SetViewerDistance(this->Views[view].LightDistance);
  const int before = sweep->GetSweepCount();
  const bool isSwept = sweep->Sweep(volume, this->Views[view].Grid);
  if (isSwept && (this->Atlas.IsNew() || sweep->GetSweepCount() > before))
  {
    this->Atlas.Copy(static_cast<int>(view), sweep->GetTexture());
  }
  return isSwept;
}

//------------------------------------------------------------------------------
void ShadowTerm::SetViewUniforms(const double textureToWorld[16], vtkShaderProgram* program)
{
  std::vector<float> matrices, firsts, sizes;
  for (std::size_t view = 0; view < this->Views.size(); ++view)
  {
    double matrix[16] = {};
    if (!this->Views[view].Grid.IsEmpty())
    {
      this->Views[view].Grid.GetWorldToTexture(matrix);
      vtkMatrix4x4::Multiply4x4(matrix, textureToWorld, matrix);
    }
    for (int i = 0; i < 16; ++i) // OpenGL reads columns
    {
      matrices.push_back(static_cast<float>(matrix[4 * (i % 4) + i / 4]));
    }
    AppendVector(firsts, this->Atlas.GetFirst(static_cast<int>(view)));
    AppendVector(sizes, this->Atlas.GetSize(static_cast<int>(view)));
  }
  this->SetSlices(textureToWorld, program);
  program->SetUniformMatrix4x4v("in_opticsShadowView", static_cast<int>(this->Views.size()), matrices.data());
  SetVectors(program, "in_opticsShadowFirst", firsts.data(), this->Views.size());
  SetVectors(program, "in_opticsShadowSize", sizes.data(), this->Views.size());
}

//------------------------------------------------------------------------------
// Of the mean distance of all lights' slices.
void ShadowTerm::SetSlices(const double textureToWorld[16], vtkShaderProgram* program)
{
  double sum = 0.0;
  for (const LightView& view : this->Views)
  {
    sum += view.Grid.GetSliceDistance();
  }
  const double mean = sum / static_cast<double>(this->Views.size());
  float columns[9];
  for (int i = 0; i < 9; ++i)
  {
    columns[i] = static_cast<float>(textureToWorld[4 * (i % 3) + i / 3] / mean);
  }
  program->SetUniformMatrix3x3("in_opticsShadowToSlices", columns);
}

//------------------------------------------------------------------------------
void ShadowTerm::UnbindTextures()
{
  this->Atlas.GetTexture().Unbind();
}

//------------------------------------------------------------------------------
void ShadowTerm::ReleaseGraphicsResources(vtkWindow* window)
{
  for (const auto& sweep : this->Sweeps)
  {
    sweep->ReleaseGraphicsResources(window);
  }
  this->Sweeps.clear();
  this->ReleaseGeometry(window);
  this->Atlas.Release(window);
}

//------------------------------------------------------------------------------
void ShadowTerm::ReleaseGeometry(vtkWindow* window)
{
  for (OpaqueDepth& geometry : this->Geometry)
  {
    geometry.Release(window);
  }
  this->Geometry.clear();
}

//------------------------------------------------------------------------------
std::size_t ShadowTerm::GetMemorySize() const
{
  std::size_t size = this->Atlas.GetMemorySize();
  for (const OpaqueDepth& geometry : this->Geometry)
  {
    size += geometry.GetMemorySize();
  }
  for (const auto& sweep : this->Sweeps)
  {
    size += sweep->GetMemorySize();
  }
  return size;
}

//------------------------------------------------------------------------------
int ShadowTerm::GetSweepCount() const
{
  int count = 0;
  for (const auto& sweep : this->Sweeps)
  {
    count += sweep->GetSweepCount();
  }
  return count;
}
