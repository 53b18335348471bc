// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ReflectanceTerm.h"

#include "LightUniforms.h"
#include "LightingTransferFunctionTerm.h"
#include "vtkOpticsVolumeMapper.h"
#include "vtkOpticsVolumeProperty.h"

#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkVolume.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace
{
using Property = vtkOpticsVolumeProperty;

bool HasSurface(const OpticsScene& scene)
{
  return scene.Optics->GetReflectanceModel() != Property::None;
}

// Normals are those of the classified extinction, but VTK's model takes the scalar's.
bool HasExtinctionSurface(const OpticsScene& scene)
{
  return HasSurface(scene) && scene.Optics->GetReflectanceModel() != Property::VTK;
}

bool StoresScalarGradient(const OpticsScene& scene)
{
  return scene.Mapper->GetScalarGradient() == vtkOpticsVolumeMapper::Stored;
}

bool NeedsScalarGradient(const OpticsScene& scene)
{
  return scene.Optics->GetReflectanceModel() == Property::VTK ||
    scene.Optics->GetLightingTransferFunction() != nullptr;
}

bool IsAnisotropic(const OpticsScene& scene)
{
  const int model = scene.Optics->GetReflectanceModel();
  return model == Property::Ward || model == Property::Lafortune;
}

bool HasGradientOpacity(const OpticsScene& scene)
{
  vtkVolumeProperty* property = scene.Volume->GetProperty();
  return property->HasGradientOpacity() && !property->GetDisableGradientOpacity();
}

bool Is2D(const OpticsScene& scene)
{
  return scene.Volume->GetProperty()->GetTransferFunctionMode() == vtkVolumeProperty::TF_2D;
}

bool HasLabels(const OpticsScene& scene)
{
  return scene.Mapper->GetMaskInput() &&
    scene.Mapper->GetMaskType() == vtkGPUVolumeRayCastMapper::LabelMapMaskType;
}

// Where opacity depends on more than the scalar, its gradient is not along the stored normal.
bool NeedsCentralDifferences(const OpticsScene& scene)
{
  return HasGradientOpacity(scene) || Is2D(scene) ||
    scene.Mapper->GetExtinctionGradient() == vtkOpticsVolumeMapper::CentralDifferences;
}

// Normals are stored for the tangent frame, for the gradient along them, and for the magnitude that
// a gradient-dependent opacity needs at the neighbours.
bool NeedsFrames(const OpticsScene& scene)
{
  const bool isAtHand = NeedsScalarGradient(scene) && StoresScalarGradient(scene);
  return isAtHand ||
    (HasExtinctionSurface(scene) &&
      (IsAnisotropic(scene) || !NeedsCentralDifferences(scene) || HasGradientOpacity(scene) || Is2D(scene)));
}

// Whether the scene asks for light other than VTK's own.
bool ReplacesLighting(const OpticsScene& scene)
{
  return scene.Optics->GetReflectanceModel() != Property::VTK ||
    scene.Optics->GetLightingTransferFunction() != nullptr;
}

// VTK's rays have no length in a volume whose points lie in a plane, and its pictures no meaning.
bool IsFlat(const OpticsScene& scene)
{
  const int* size = vtkImageData::SafeDownCast(scene.Mapper->GetDataSetInput())->GetDimensions();
  return !scene.CellScalars && *std::min_element(size, size + 3) == 1;
}

bool IsTwoSided(const OpticsScene& scene)
{
  return scene.Renderer->GetTwoSidedLighting() && !LightingTransferFunctionTerm::HasHybridNormals(scene);
}

// What the term cannot shade, in words; empty where it can.
std::string Unsupported(const OpticsScene& scene)
{
  vtkVolumeProperty* property = scene.Volume->GetProperty();
  if (scene.Mapper->GetInputCount() > 1)
  {
    return "several volumes in one mapper (vtkMultiVolume)";
  }
  if (!vtkImageData::SafeDownCast(scene.Mapper->GetDataSetInput()))
  {
    return "data other than vtkImageData";
  }
  if (IsFlat(scene))
  {
    return "a volume of a single point on an axis";
  }
  if (scene.Mapper->GetBlendMode() != vtkVolumeMapper::COMPOSITE_BLEND)
  {
    return "a blend mode other than composite";
  }
  if (scene.Scalars->GetNumberOfComponents() > 1 && property->GetIndependentComponents())
  {
    return "several independent components";
  }
  if (property->HasLabelGradientOpacity())
  {
    return "a gradient opacity of labels";
  }
  return std::string();
}

void SayUnsupported(const OpticsScene& scene, const std::string& reason)
{
  const bool hasModel = scene.Optics->GetReflectanceModel() != Property::VTK;
  const std::string who = hasModel
    ? std::string("Reflectance model ") + scene.Optics->GetReflectanceModelAsString()
    : std::string("The lighting transfer function");
  const std::string remedy = hasModel ? "SetReflectanceModelToVTK()" : "SetLightingTransferFunction(nullptr)";
  scene.Mapper->Say(
    who + " does not support " + reason + ": the picture is VTK's own. " + remedy + " silences this.");
}

double UnitDistance(const OpticsScene& scene)
{
  return scene.Volume->GetProperty()->GetScalarOpacityUnitDistance(scene.OpacityComponent);
}

// OpenGL reads columns, VTK's matrices are rows.
void SetMatrix(vtkShaderProgram* program, const char* name, vtkMatrix3x3* matrix)
{
  vtkNew<vtkMatrix3x3> columns;
  vtkMatrix3x3::Transpose(matrix, columns);
  program->SetUniformMatrix(name, columns);
}

void SetSpaces(const OpticsScene& scene, vtkShaderProgram* program)
{
  vtkNew<vtkMatrix4x4> dataToEye;
  vtkMatrix4x4::Multiply4x4(
    scene.Renderer->GetActiveCamera()->GetModelViewTransformMatrix(), scene.Volume->GetMatrix(), dataToEye);
  vtkNew<vtkMatrix3x3> tangents;
  for (int i = 0; i < 9; ++i)
  {
    tangents->SetElement(i / 3, i % 3, dataToEye->GetElement(i / 3, i % 3));
  }
  SetMatrix(program, "in_opticsTangentToEye", tangents);
  vtkNew<vtkMatrix3x3> normals;
  vtkMatrix3x3::Invert(tangents, normals);
  program->SetUniformMatrix("in_opticsNormalToEye", normals); // transposed by not transposing
}

// Differences over two voxels on each index axis, to the gradient times a length.
void SetDifferences(const OpticsScene& scene, double length, const char* name, vtkShaderProgram* program)
{
  auto* image = vtkImageData::SafeDownCast(scene.Mapper->GetDataSetInput());
  vtkNew<vtkMatrix3x3> matrix;
  for (int i = 0; i < 9; ++i)
  {
    const double step = 2.0 * image->GetSpacing()[i % 3];
    matrix->SetElement(i / 3, i % 3, image->GetDirectionMatrix()->GetElement(i / 3, i % 3) * length / step);
  }
  SetMatrix(program, name, matrix);
}

OpticsFeature ModelFeature(int model)
{
  const OpticsFeature features[] = { OpticsFeature::ReflectanceVTK, OpticsFeature::ReflectanceNone,
    OpticsFeature::ReflectanceBlinnPhong, OpticsFeature::ReflectanceWard,
    OpticsFeature::ReflectanceLafortune };
  return features[model];
}

// Map and Components both have three numbers: the first one's name tells.
OpticsFeature StorageFeature(vtkDataArray* anisotropy)
{
  if (anisotropy->GetNumberOfComponents() == 5)
  {
    return OpticsFeature::AnisotropyWorld;
  }
  const char* name = anisotropy->GetComponentName(0);
  const bool isComponents = name && std::string(name) == "C11";
  return isComponents ? OpticsFeature::AnisotropyComponents : OpticsFeature::AnisotropyMap;
}

void AddExtinctionFeatures(const OpticsScene& scene, OpticsFeatures& features)
{
  if (NeedsCentralDifferences(scene))
  {
    features.Add(OpticsFeature::GradientCentral);
    features.Add(NeedsFrames(scene) ? OpticsFeature::GradientCentralWithNormal
                                    : OpticsFeature::GradientCentralWithoutNormal);
  }
  else
  {
    features.Add(OpticsFeature::GradientStored);
  }
  features.Add(Is2D(scene)        ? OpticsFeature::OpacityAt2D
      : HasLabels(scene)          ? OpticsFeature::OpacityAtLabel
      : HasGradientOpacity(scene) ? OpticsFeature::OpacityAtScalarAndGradient
                                  : OpticsFeature::OpacityAtScalar);
}
}

//------------------------------------------------------------------------------
bool ReflectanceTerm::IsActive(const OpticsScene& scene)
{
  this->IsLit = false;
  if (!ReplacesLighting(scene) || !scene.Volume->GetProperty()->GetShade())
  {
    return false;
  }
  const std::string reason = Unsupported(scene);
  if (!reason.empty())
  {
    SayUnsupported(scene, reason);
  }
  return reason.empty();
}

//------------------------------------------------------------------------------
bool ReflectanceTerm::Prepare(const OpticsScene& scene)
{
  this->IsLit = this->PrepareFrames(scene);
  return this->IsLit;
}

//------------------------------------------------------------------------------
bool ReflectanceTerm::PrepareFrames(const OpticsScene& scene)
{
  if (!NeedsFrames(scene))
  {
    this->Textures.Release(scene.Window);
    return true;
  }
  FrameProvider::Request request;
  request.Anisotropy = IsAnisotropic(scene);
  request.Curvature = request.Anisotropy && scene.Optics->GetFrameSource() == Property::Curvature;
  request.ResolutionFactor = scene.Mapper->GetFrameResolutionFactor();
  request.Bits = scene.Mapper->GetFramePrecision();
  request.Coarse = scene.Mapper->IsInteractive(scene.Renderer);
  const FrameGrid grid = this->Frames.Update(scene, request);
  if (!grid.Normals)
  {
    return false;
  }
  if (grid.Anisotropy)
  {
    this->Storage = StorageFeature(grid.Anisotropy);
  }
  if (!this->Textures.Update(grid, request.Bits, scene.Window))
  {
    scene.Mapper->Say("The normals have more voxels on an axis than the OpenGL of this machine has texels (" +
      std::to_string(vtkTextureObject::GetMaximumTextureSize3D(scene.Window)) +
      "): the picture is VTK's own. Lower SetFrameResolutionFactor().");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
void ReflectanceTerm::AddFeatures(const OpticsScene& scene, OpticsFeatures& features)
{
  features.Add(OpticsFeature::Reflectance);
  features.Add(ModelFeature(scene.Optics->GetReflectanceModel()));
  if (!scene.Optics->GetLightingTransferFunction())
  {
    features.Add(OpticsFeature::CoefficientsOfProperty);
  }
  features.NumberOfLights = CountLights(scene.Renderer);
  features.Add(
    HasPositionalLight(scene.Renderer) ? OpticsFeature::LightsPositional : OpticsFeature::LightsDirectional);
  const bool hasVTKGradientOpacity = HasGradientOpacity(scene) && !Is2D(scene);
  features.Add(
    hasVTKGradientOpacity ? OpticsFeature::GradientOpacityScalar : OpticsFeature::GradientOpacityNone);
  if (scene.Optics->GetReflectanceModel() != Property::VTK)
  {
    features.Add(OpticsFeature::Scattering);
  }
  this->AddSurfaceFeatures(scene, features);
}

//------------------------------------------------------------------------------
void ReflectanceTerm::AddSurfaceFeatures(const OpticsScene& scene, OpticsFeatures& features) const
{
  if (HasSurface(scene))
  {
    features.Add(OpticsFeature::Surface);
  }
  if (NeedsFrames(scene))
  {
    features.Add(OpticsFeature::FrameLookup);
  }
  if (NeedsScalarGradient(scene))
  {
    features.Add(StoresScalarGradient(scene) ? OpticsFeature::ScalarGradientStored
                                             : OpticsFeature::ScalarGradientCentral);
  }
  if (NeedsScalarGradient(scene) && !StoresScalarGradient(scene))
  {
    features.Add(OpticsFeature::ScalarLookup);
  }
  if (HasExtinctionSurface(scene))
  {
    features.Add(OpticsFeature::ExtinctionSurface);
    AddExtinctionFeatures(scene, features);
  }
  if (IsAnisotropic(scene))
  {
    features.Add(OpticsFeature::Anisotropic);
    features.Add(this->Storage);
  }
}

//------------------------------------------------------------------------------
void ReflectanceTerm::SetUniforms(const OpticsScene& scene, vtkShaderProgram* program)
{
  SetSpaces(scene, program);
  SetLightUniforms(scene.Renderer, program);
  program->SetUniformf("in_opticsScatteringAnisotropy", scene.Optics->GetScatteringAnisotropy());
  program->SetUniformf("in_opticsTwoSided", IsTwoSided(scene) ? 1.0F : 0.0F);
  float channel[4] = {};
  channel[scene.OpacityComponent] = 1.0F;
  program->SetUniform4f("in_opticsOpacityChannel", channel);
  this->SetGradientUniforms(scene, program);
  if (HasExtinctionSurface(scene))
  {
    this->SetSurfaceUniforms(scene, program);
    this->SetExtinctionUniforms(scene, program);
  }
}

//------------------------------------------------------------------------------
void ReflectanceTerm::SetSurfaceUniforms(const OpticsScene& scene, vtkShaderProgram* program)
{
  Property* optics = scene.Optics;
  program->SetUniformf("in_opticsSpecularFromExtinction", optics->GetSpecularFromExtinction() ? 1.0F : 0.0F);
  program->SetUniformf("in_opticsGlossiness", static_cast<float>(optics->GetGlossiness()));
  program->SetUniformf("in_opticsAnisotropyScale", static_cast<float>(optics->GetAnisotropyScale()));
}

//------------------------------------------------------------------------------
void ReflectanceTerm::SetGradientUniforms(const OpticsScene& scene, vtkShaderProgram* program)
{
  const double step = SmallestSpacing(scene);
  if (NeedsFrames(scene))
  {
    double range[2];
    scene.Mapper->GetLoadedScalarRange(scene.OpacityComponent, range);
    this->Textures.SetUniforms(program, step / (range[1] > range[0] ? range[1] - range[0] : 1.0));
  }
  if (NeedsScalarGradient(scene) && !StoresScalarGradient(scene))
  {
    SetDifferences(scene, step, "in_opticsDifferenceToStep", program);
  }
}

//------------------------------------------------------------------------------
void ReflectanceTerm::SetExtinctionUniforms(const OpticsScene& scene, vtkShaderProgram* program)
{
  double range[2];
  scene.Mapper->GetLoadedScalarRange(scene.OpacityComponent, range);
  const double step = SmallestSpacing(scene);
  vtkPiecewiseFunction* opacity = scene.Volume->GetProperty()->GetScalarOpacity();
  const bool isNative = scene.Mapper->GetScalarOpacityRangeType() == vtkGPUVolumeRayCastMapper::NATIVE;
  this->Opacity.Update(opacity, isNative ? opacity->GetRange() : range, scene.Window);
  this->Opacity.SetUniforms(program);
  if (NeedsCentralDifferences(scene))
  {
    SetDifferences(scene, UnitDistance(scene), "in_opticsDifferenceToData", program);
  }
  program->SetUniformf("in_opticsUnitStep", static_cast<float>(UnitDistance(scene) / step));
  const double* spacing = vtkImageData::SafeDownCast(scene.Mapper->GetDataSetInput())->GetSpacing();
  const double meanSpacing = (spacing[0] + spacing[1] + spacing[2]) / 3.0;
  program->SetUniformf("in_opticsChangeToVTK", static_cast<float>(4.0 * meanSpacing / step));
}

//------------------------------------------------------------------------------
void ReflectanceTerm::UnbindTextures()
{
  this->Textures.Unbind();
  this->Opacity.Unbind();
}

//------------------------------------------------------------------------------
void ReflectanceTerm::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Textures.Release(window);
  this->Opacity.Release(window);
}

//------------------------------------------------------------------------------
std::size_t ReflectanceTerm::GetMemorySize() const
{
  return this->Textures.GetMemorySize() + this->Opacity.GetMemorySize();
}
