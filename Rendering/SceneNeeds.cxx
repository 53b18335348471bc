// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SceneNeeds.h"

#include "IsosurfaceTexture.h"
#include "LightUniforms.h"
#include "LineVoxels.h"
#include "vtkOpticsVolumeMapper.h"
#include "vtkOpticsVolumeProperty.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkVolume.h"

#include <algorithm>

namespace
{
using Property = vtkOpticsVolumeProperty;

// VTK's rays have no length in a volume whose points lie in a plane, and its pictures no meaning.
bool IsFlat(const OpticsScene& scene)
{
  const int* size = vtkImageData::SafeDownCast(scene.Mapper->GetDataSetInput())->GetDimensions();
  return !scene.CellScalars && *std::min_element(size, size + 3) == 1;
}
}

//------------------------------------------------------------------------------
std::string FindUnsupported(const OpticsScene& scene)
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

//------------------------------------------------------------------------------
std::string FindUnsupportedBySamples(const OpticsScene& scene)
{
  return HasLineVoxels(scene) ? "lines as anisotropic voxels, which have opacity and light of their own"
                              : FindUnsupported(scene);
}

//------------------------------------------------------------------------------
bool HasLineVoxels(const OpticsScene& scene)
{
  auto* image = vtkImageData::SafeDownCast(scene.Mapper->GetDataSetInput());
  const char* name = scene.Scalars->GetName();
  return image && scene.CellScalars && name && std::string(name) == "BrickIndex" &&
    volumeoptics::HoldsLineVoxels(image);
}

//------------------------------------------------------------------------------
std::string FindUnsupportedByLines(const OpticsScene& scene)
{
  if (scene.Mapper->GetInputCount() > 1)
  {
    return "several volumes in one mapper (vtkMultiVolume)";
  }
  if (scene.Mapper->GetBlendMode() != vtkVolumeMapper::COMPOSITE_BLEND)
  {
    return "a blend mode other than composite";
  }
  return HasLabels(scene) ? "label maps" : "";
}

//------------------------------------------------------------------------------
std::string FindUnsupportedByIntegral(const OpticsScene& scene)
{
  std::string reason = FindUnsupportedBySamples(scene);
  if (!reason.empty())
  {
    return reason;
  }
  if (Is2D(scene))
  {
    return "2D transfer functions";
  }
  const int surfaces = scene.Optics->GetNumberOfIsosurfaces();
  const int most = IsosurfaceTexture::LargestNumber;
  if (scene.Optics->GetIntegrationSpace() == Property::Data && surfaces > most)
  {
    return std::to_string(surfaces) + " isosurfaces, which are more than the " + std::to_string(most) +
      " that can be drawn (RemoveIsosurface() takes some away)";
  }
  return HasLabels(scene) ? "label maps" : std::string();
}

//------------------------------------------------------------------------------
bool WantsIntegral(const OpticsScene& scene)
{
  return scene.Optics->GetIntegrationSpace() == Property::Data || IsPreIntegrated(scene);
}

//------------------------------------------------------------------------------
bool ReplacesIntegral(const OpticsScene& scene)
{
  return WantsIntegral(scene) && FindUnsupportedByIntegral(scene).empty();
}

//------------------------------------------------------------------------------
bool IntegratesInData(const OpticsScene& scene)
{
  return scene.Optics->GetIntegrationSpace() == Property::Data && ReplacesIntegral(scene);
}

//------------------------------------------------------------------------------
bool WantsLighting(const OpticsScene& scene)
{
  return scene.Volume->GetProperty()->GetShade() &&
    (scene.Optics->GetReflectanceModel() != Property::VTK || scene.Optics->GetLightingTransferFunction() ||
      TransmitsLight(scene) || (!HasLineVoxels(scene) && (WantsAmbientLight(scene) || WantsShadows(scene))));
}

//------------------------------------------------------------------------------
bool ReplacesLighting(const OpticsScene& scene)
{
  return WantsLighting(scene) && FindUnsupportedBySamples(scene).empty();
}

//------------------------------------------------------------------------------
bool HasLightingTable(const OpticsScene& scene)
{
  return ReplacesLighting(scene) && scene.Optics->GetLightingTransferFunction();
}

//------------------------------------------------------------------------------
bool HasHybridNormals(const OpticsScene& scene)
{
  return HasLightingTable(scene) && HasSurface(scene) && scene.Optics->GetHybridNormals() && !Is2D(scene);
}

//------------------------------------------------------------------------------
bool WantsClassification(const OpticsScene& scene)
{
  return scene.Optics->GetMultiSampleClassification() != nullptr;
}

//------------------------------------------------------------------------------
std::string FindUnsupportedByClassification(const OpticsScene& scene)
{
  std::string reason = FindUnsupportedBySamples(scene);
  if (!reason.empty())
  {
    return reason;
  }
  if (Is2D(scene))
  {
    return "2D transfer functions";
  }
  if (WantsIntegral(scene))
  {
    return "IntegrationSpace Data or Classification PreIntegrated";
  }
  return HasExtinctionSurface(scene)
    ? "reflectance models whose normals are of the opacity function's extinction (take VTK or None)"
    : "";
}

//------------------------------------------------------------------------------
bool ReplacesClassification(const OpticsScene& scene)
{
  return WantsClassification(scene) && FindUnsupportedByClassification(scene).empty();
}

//------------------------------------------------------------------------------
bool IsPreIntegrated(const OpticsScene& scene)
{
  return scene.Optics->GetClassification() == Property::PreIntegrated;
}

//------------------------------------------------------------------------------
bool HasIsosurfaces(const OpticsScene& scene)
{
  return IntegratesInData(scene) && scene.Optics->GetNumberOfIsosurfaces() > 0;
}

//------------------------------------------------------------------------------
bool HasSilhouettes(const OpticsScene& scene)
{
  return IntegratesInData(scene) && scene.Optics->GetSilhouette() != Property::SilhouetteOff;
}

//------------------------------------------------------------------------------
bool TransmitsLight(const OpticsScene& scene)
{
  return scene.Optics->GetTransmittedLight() != Property::TransmittedLightOff &&
    scene.Volume->GetProperty()->GetShade() && IntegratesInData(scene);
}

//------------------------------------------------------------------------------
bool WantsAmbientLight(const OpticsScene& scene)
{
  const double* color = scene.Optics->GetAmbientColor();
  return scene.Optics->GetOcclusion() || color[0] != 1.0 || color[1] != 1.0 || color[2] != 1.0;
}

//------------------------------------------------------------------------------
bool HasAmbientLight(const OpticsScene& scene)
{
  return WantsAmbientLight(scene) && FindUnsupported(scene).empty();
}

//------------------------------------------------------------------------------
bool WantsShadows(const OpticsScene& scene)
{
  // Shade is not asked for lines: they are always lit
  return scene.Optics->GetShadows() && (scene.Volume->GetProperty()->GetShade() || HasLineVoxels(scene)) &&
    CountLights(scene.Renderer) > 0;
}

//------------------------------------------------------------------------------
bool HasOcclusion(const OpticsScene& scene)
{
  return scene.Optics->GetOcclusion() && HasAmbientLight(scene);
}

//------------------------------------------------------------------------------
bool GathersOcclusion(const OpticsScene& scene)
{
  const bool isWanted = scene.Mapper->GetVisibilityGatherSamples() > 0 &&
    scene.Mapper->GetVisibilityAlgorithm() == vtkOpticsVolumeMapper::DirectionSweep;
  auto* image = vtkImageData::SafeDownCast(scene.Mapper->GetDataSetInput());
  const bool isCut = scene.Mapper->GetCropping() || scene.Mapper->GetMaskInput() ||
    (image && (image->HasAnyBlankPoints() || image->HasAnyBlankCells()));
  return isWanted && HasOcclusion(scene) && !isCut && !scene.Mapper->HasPartitions() && !Is2D(scene) &&
    !HasGradientOpacity(scene) && !ReplacesIntegral(scene) && !ReplacesClassification(scene) &&
    !HasLineVoxels(scene);
}

//------------------------------------------------------------------------------
bool HasGradientOpacity(const OpticsScene& scene)
{
  vtkVolumeProperty* property = scene.Volume->GetProperty();
  return property->HasGradientOpacity() && !property->GetDisableGradientOpacity();
}

//------------------------------------------------------------------------------
bool Is2D(const OpticsScene& scene)
{
  return scene.Volume->GetProperty()->GetTransferFunctionMode() == vtkVolumeProperty::TF_2D;
}

//------------------------------------------------------------------------------
bool HasLabels(const OpticsScene& scene)
{
  return scene.Mapper->GetMaskInput() &&
    scene.Mapper->GetMaskType() == vtkGPUVolumeRayCastMapper::LabelMapMaskType;
}

//------------------------------------------------------------------------------
bool HasOwnColor(const OpticsScene& scene)
{
  return scene.Scalars->GetNumberOfComponents() > 1;
}

//------------------------------------------------------------------------------
bool HasSurface(const OpticsScene& scene)
{
  return ReplacesLighting(scene) && scene.Optics->GetReflectanceModel() != Property::None;
}

//------------------------------------------------------------------------------
bool HasExtinctionSurface(const OpticsScene& scene)
{
  return HasSurface(scene) && scene.Optics->GetReflectanceModel() != Property::VTK;
}

//------------------------------------------------------------------------------
bool IsAnisotropic(const OpticsScene& scene)
{
  const int model = scene.Optics->GetReflectanceModel();
  return ReplacesLighting(scene) && (model == Property::Ward || model == Property::Lafortune);
}

//------------------------------------------------------------------------------
bool NeedsCentralDifferences(const OpticsScene& scene)
{
  return HasGradientOpacity(scene) || Is2D(scene) ||
    scene.Mapper->GetExtinctionGradient() == vtkOpticsVolumeMapper::CentralDifferences;
}

//------------------------------------------------------------------------------
bool NeedsScalarGradient(const OpticsScene& scene)
{
  const bool forLight = ReplacesLighting(scene) &&
    (scene.Optics->GetReflectanceModel() == Property::VTK || HasLightingTable(scene) ||
      TransmitsLight(scene));
  return forLight || HasSilhouettes(scene) || ReplacesClassification(scene);
}

//------------------------------------------------------------------------------
bool StoresScalarGradient(const OpticsScene& scene)
{
  const int gradient = scene.Mapper->GetScalarGradient();
  const bool isAlongGradient = HasLightingTable(scene) || ReplacesClassification(scene);
  return gradient == vtkOpticsVolumeMapper::Stored ||
    (gradient == vtkOpticsVolumeMapper::Automatic && isAlongGradient);
}

//------------------------------------------------------------------------------
// For the tangent frame, for the gradient along the normal, for the magnitude that a gradient-dependent
// opacity needs at the neighbours, and for the normals of isosurfaces.
bool NeedsFrames(const OpticsScene& scene)
{
  const bool isAtHand = NeedsScalarGradient(scene) && StoresScalarGradient(scene);
  return isAtHand ||
    (HasExtinctionSurface(scene) &&
      (IsAnisotropic(scene) || !NeedsCentralDifferences(scene) || HasGradientOpacity(scene) || Is2D(scene) ||
        HasIsosurfaces(scene)));
}

//------------------------------------------------------------------------------
bool NeedsOpacityTable(const OpticsScene& scene)
{
  return HasExtinctionSurface(scene) || GathersOcclusion(scene) ||
    (ReplacesIntegral(scene) && !IsPreIntegrated(scene));
}

//------------------------------------------------------------------------------
// Four components are a colour themselves, of two the first one is looked up.
bool NeedsColorTable(const OpticsScene& scene)
{
  return ReplacesIntegral(scene) && scene.Scalars->GetNumberOfComponents() < 3 &&
    (!IsPreIntegrated(scene) || HasOwnColor(scene));
}
