// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// vtkOpticsVolumeMapper: its knobs, their presets, and the sample distance.

#include "vtkOpticsVolumeMapper.h"

#include "InteractionQuality.h"
#include "ParameterRange.h"
#include "QualityPresets.h"
#include "vtkAmbientCovarianceFilter.h"
#include "vtkOpticsVolumeProperty.h"
#include "vtkPrincipalCurvatureFilter.h"
#include "vtkSobelNormalFilter.h"

#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolume.h"

#include <algorithm>
#include <cmath>

namespace
{
const char* const GradientTypeNames[] = { "Stored", "CentralDifferences", "Automatic" };
const char* const LightingSamplesNames[] = { "Fetched", "Extrapolated" };
const char* const VisibilityAlgorithmNames[] = { "DirectionSweep", "Disk", "DiskSolidAngle" };
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::SetFrameResolutionFactor(double factor)
{
  volumeoptics::SetWithinRange(
    this, "FrameResolutionFactor", factor, 0.0625, 1.0, this->FrameResolutionFactor);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::SetFramePrecision(int bits)
{
  volumeoptics::SetPrecision(this, "FramePrecision", bits, this->FramePrecision);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::SetPreIntegrationTableSize(int size)
{
  volumeoptics::SetWithinRange(this, "PreIntegrationTableSize", size, 2, 4096, this->PreIntegrationTableSize);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::SetMacrocellSize(int voxels)
{
  const int least = voxels == 0 ? 0 : 2;
  volumeoptics::SetWithinRange(this, "MacrocellSize", voxels, least, 64, this->MacrocellSize);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::SetTablePrecision(int bits)
{
  if (bits != 16 && bits != 32)
  {
    vtkWarningMacro(<< "TablePrecision " << bits << " is not set: choose 16 or 32.");
    return;
  }
  if (this->TablePrecision != bits)
  {
    this->TablePrecision = bits;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::SetLineRadiusScale(int type, double scale)
{
  double& place = this->LineRadiusScales.emplace(type, 1.0).first->second;
  volumeoptics::SetWithinRange(this, "LineRadiusScale", scale, 0.0, 1.0e6, place);
}

//------------------------------------------------------------------------------
double vtkOpticsVolumeMapper::GetLineRadiusScale(int type) const
{
  const auto found = this->LineRadiusScales.find(type);
  return found == this->LineRadiusScales.end() ? 1.0 : found->second;
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::SetLineOpacityScale(int type, double scale)
{
  double& place = this->LineOpacityScales.emplace(type, 1.0).first->second;
  volumeoptics::SetWithinRange(this, "LineOpacityScale", scale, 0.0, 1.0, place);
}

//------------------------------------------------------------------------------
double vtkOpticsVolumeMapper::GetLineOpacityScale(int type) const
{
  const auto found = this->LineOpacityScales.find(type);
  return found == this->LineOpacityScales.end() ? 1.0 : found->second;
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::SetLineOpacityFunction(vtkPiecewiseFunction* function)
{
  if (this->LineOpacityFunction != function)
  {
    this->LineOpacityFunction = function;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkPiecewiseFunction* vtkOpticsVolumeMapper::GetLineOpacityFunction() const
{
  return this->LineOpacityFunction;
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::SetLinePrecision(int bits)
{
  if (bits != 8 && bits != 16 && bits != 32)
  {
    vtkWarningMacro(<< "LinePrecision " << bits << " is not set: choose 8, 16 or 32.");
    return;
  }
  if (this->LinePrecision != bits)
  {
    this->LinePrecision = bits;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
const char* vtkOpticsVolumeMapper::GetExtinctionGradientAsString()
{
  return GradientTypeNames[this->ExtinctionGradient];
}

//------------------------------------------------------------------------------
const char* vtkOpticsVolumeMapper::GetScalarGradientAsString()
{
  return GradientTypeNames[this->ScalarGradient];
}

//------------------------------------------------------------------------------
const char* vtkOpticsVolumeMapper::GetLightingSamplesAsString()
{
  return LightingSamplesNames[this->LightingSamples];
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::SetVisibilityGridSize(int froxels)
{
  volumeoptics::SetWithinRange(this, "VisibilityGridSize", froxels, 1, 2048, this->VisibilityGridSize);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::SetVisibilitySliceDistance(double froxels)
{
  volumeoptics::SetWithinRange(
    this, "VisibilitySliceDistance", froxels, 0.1, 10.0, this->VisibilitySliceDistance);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::SetVisibilitySamples(int directions)
{
  if (directions != 4 && directions != 8 && directions != 16)
  {
    vtkWarningMacro(<< "VisibilitySamples " << directions << " is not set: choose 4, 8 or 16.");
    return;
  }
  if (this->VisibilitySamples != directions)
  {
    this->VisibilitySamples = directions;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
const char* vtkOpticsVolumeMapper::GetVisibilityAlgorithmAsString()
{
  return VisibilityAlgorithmNames[this->VisibilityAlgorithm];
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::SetVisibilityDiskSize(int size)
{
  volumeoptics::SetWithinRange(this, "VisibilityDiskSize", size, 1, 32, this->VisibilityDiskSize);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::SetVisibilityGatherSamples(int samples)
{
  volumeoptics::SetWithinRange(
    this, "VisibilityGatherSamples", samples, 0, 16, this->VisibilityGatherSamples);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::SetVisibilityPrecision(int bits)
{
  volumeoptics::SetPrecision(this, "VisibilityPrecision", bits, this->VisibilityPrecision);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::SetQuality(int quality)
{
  this->Quality = std::clamp(quality, static_cast<int>(Custom), static_cast<int>(Reference));
  this->Modified();
  if (this->Quality == Custom)
  {
    this->StepInVoxels = 0.0;
    return;
  }
  const QualityPreset& preset = QualityPresets[this->Quality];
  this->StepInVoxels = preset.StepInVoxels;
  this->SetFrameResolutionFactor(preset.ResolutionFactor);
  this->SetFramePrecision(preset.Bits);
  this->SetVisibilityGridSize(preset.VisibilityGridSize);
  this->SetVisibilitySamples(preset.VisibilitySamples);
  this->SetVisibilityGatherSamples(preset.VisibilityGatherSamples);
  this->SetVisibilityPrecision(preset.VisibilityPrecision);
  this->GetAmbientCovarianceFilter()->SetNumberOfSamples(preset.Samples);
  this->GetAmbientCovarianceFilter()->SetFilterStandardDeviation(preset.FilterStandardDeviation);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::SetSampleDistance(float distance)
{
  this->StepInVoxels = 0.0;
  this->Superclass::SetSampleDistance(distance);
}

//------------------------------------------------------------------------------
// The time of a frame goes with the number of steps. VTK measures it: SmallTimeToDraw is that of the last frame of an
// interaction, BigTimeToDraw of the last still one.
void vtkOpticsVolumeMapper::UpdateCoarseness(vtkRenderer* renderer, vtkVolume* volume)
{
  if (this->Quality == Custom || !this->IsInteractive(renderer))
  {
    this->Coarseness = 1;
    return;
  }
  const double full =
    this->SmallTimeToDraw > 0.0 ? this->SmallTimeToDraw * this->LastCoarseness : this->BigTimeToDraw;
  this->Coarseness =
    volumeoptics::CoarsenessFor(full, volume->GetAllocatedRenderTime(), this->LastCoarseness);
  this->LastCoarseness = this->Coarseness;
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::UpdateSampleDistance()
{
  auto* image = vtkImageData::SafeDownCast(this->GetDataSetInput());
  if (this->StepInVoxels <= 0.0 || !image)
  {
    return;
  }
  double spacing[3];
  this->GetVoxelSpacing(spacing);
  const double smallest = std::min({ std::abs(spacing[0]), std::abs(spacing[1]), std::abs(spacing[2]) });
  this->SetAutoAdjustSampleDistances(0);
  this->Superclass::SetSampleDistance(static_cast<float>(this->StepInVoxels * this->Coarseness * smallest));
}

//------------------------------------------------------------------------------
const char* vtkOpticsVolumeMapper::GetQualityAsString()
{
  const char* const names[] = { "Custom", "Draft", "Balanced", "Reference" };
  return names[this->Quality];
}

//------------------------------------------------------------------------------
// VTK keeps it to itself; the same rules. For images.
double vtkOpticsVolumeMapper::GetFrameSampleDistance(vtkVolume* volume)
{
  auto* image = vtkImageData::SafeDownCast(this->GetDataSetInput());
  double spacing[3];
  this->GetVoxelSpacing(spacing);
  if (this->AutoAdjustSampleDistances)
  {
    double least = VTK_DOUBLE_MAX;
    for (int axis = 0; axis < 3; ++axis)
    {
      double column[3];
      for (int row = 0; row < 3; ++row)
      {
        column[row] = volume->GetMatrix()->GetElement(row, axis);
      }
      least = std::min(least, std::abs(spacing[axis]) * vtkMath::Norm(column));
    }
    return this->ReductionFactor > 0.0 && this->ReductionFactor < 1.0 ? least / this->ReductionFactor : least;
  }
  return this->LockSampleDistanceToInputSpacing
    ? this->SpacingAdjustedSampleDistance(spacing, image->GetExtent())
    : this->SampleDistance;
}

//------------------------------------------------------------------------------
int vtkOpticsVolumeMapper::GetGhostLayers(vtkVolumeProperty* property)
{
  auto* own = vtkOpticsVolumeProperty::SafeDownCast(property);
  vtkOpticsVolumeProperty* optics = own ? own : this->GetOptics();
  int layers = 1; // differences of VTK's gradients
  if (!optics)
  {
    return layers;
  }
  if (optics->GetLightingTransferFunction() || optics->GetMultiSampleClassification())
  {
    layers += static_cast<int>(std::ceil(optics->GetGradientStepLength()));
  }
  const int model = property->GetShade() ? optics->GetReflectanceModel() : vtkOpticsVolumeProperty::VTK;
  if (model == vtkOpticsVolumeProperty::Ward || model == vtkOpticsVolumeProperty::Lafortune)
  {
    const bool isCurvature = optics->GetFrameSource() == vtkOpticsVolumeProperty::Curvature;
    vtkOpticsImageFilter* frames = isCurvature
      ? static_cast<vtkOpticsImageFilter*>(this->GetPrincipalCurvatureFilter())
      : this->GetAmbientCovarianceFilter();
    layers = std::max(layers, frames->GetGhostLayers(this->FrameResolutionFactor));
  }
  layers = std::max(layers, this->GetSobelNormalFilter()->GetGhostLayers(this->FrameResolutionFactor));
  const bool hasSegments = optics->GetIntegrationSpace() == vtkOpticsVolumeProperty::Data ||
    optics->GetClassification() == vtkOpticsVolumeProperty::PreIntegrated;
  return hasSegments ? layers + 1 : layers; // a segment may begin a step before the piece
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Optics: " << this->GetOptics() << "\n";
  os << indent << "FrameResolutionFactor: " << this->FrameResolutionFactor << "\n";
  os << indent << "FramePrecision: " << this->FramePrecision << "\n";
  os << indent << "ExtinctionGradient: " << this->GetExtinctionGradientAsString() << "\n";
  os << indent << "ScalarGradient: " << this->GetScalarGradientAsString() << "\n";
  os << indent << "LightingTableSize: " << this->LightingTableSize << "\n";
  os << indent << "LightingSamples: " << this->GetLightingSamplesAsString() << "\n";
  os << indent << "PreIntegrationTableSize: " << this->PreIntegrationTableSize << "\n";
  os << indent << "VisibilityGridSize: " << this->VisibilityGridSize << "\n";
  os << indent << "VisibilitySliceDistance: " << this->VisibilitySliceDistance << "\n";
  os << indent << "VisibilitySamples: " << this->VisibilitySamples << "\n";
  os << indent << "VisibilityAlgorithm: " << this->GetVisibilityAlgorithmAsString() << "\n";
  os << indent << "VisibilityDiskSize: " << this->VisibilityDiskSize << "\n";
  os << indent << "VisibilityTrueDistances: " << (this->VisibilityTrueDistances ? "on" : "off") << "\n";
  os << indent << "VisibilityGatherSamples: " << this->VisibilityGatherSamples << "\n";
  os << indent << "VisibilityPrecision: " << this->VisibilityPrecision << "\n";
  os << indent << "TablePrecision: " << this->TablePrecision << "\n";
  os << indent << "SkipEmptySpace: " << (this->SkipEmptySpace ? "on" : "off") << "\n";
  os << indent << "MacrocellSize: " << this->MacrocellSize << "\n";
  os << indent << "DrawnExtent: " << this->DrawnExtent[0] << " " << this->DrawnExtent[1] << " "
     << this->DrawnExtent[2] << " " << this->DrawnExtent[3] << " " << this->DrawnExtent[4] << " "
     << this->DrawnExtent[5] << "\n";
  os << indent << "WholeExtent: " << this->WholeExtent[0] << " " << this->WholeExtent[1] << " "
     << this->WholeExtent[2] << " " << this->WholeExtent[3] << " " << this->WholeExtent[4] << " "
     << this->WholeExtent[5] << "\n";
  os << indent << "LinePrecision: " << this->LinePrecision << "\n";
  os << indent << "LineOpacityFunction: " << this->LineOpacityFunction.Get() << "\n";
  for (const auto& [type, scale] : this->LineRadiusScales)
  {
    os << indent << "LineRadiusScale of type " << type << ": " << scale << "\n";
  }
  for (const auto& [type, scale] : this->LineOpacityScales)
  {
    os << indent << "LineOpacityScale of type " << type << ": " << scale << "\n";
  }
  os << indent << "Quality: " << this->GetQualityAsString() << "\n";
  os << indent << "ActiveTerms: " << this->GetActiveTerms() << "\n";
  os << indent << "TermMemorySize: " << this->GetTermMemorySize() << " KiB\n";
  os << indent << "ProgramLinkCount: " << this->GetProgramLinkCount() << "\n";
}
