// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// vtkOpticsVolumeRepresentation: the settings that it hands on.

#include "vtkOpticsVolumeRepresentation.h"

#include "vtkAmbientCovarianceFilter.h"
#include "vtkOpticsMultiBlockVolumeMapper.h"
#include "vtkOpticsVolumeMapper.h"
#include "vtkOpticsVolumeProperty.h"

namespace
{
using Mapper = vtkOpticsVolumeMapper;
using Property = vtkOpticsVolumeProperty;

const int NumberOfLineTypes = 256;
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetReflectanceModel(int model)
{
  this->GetOptics()->SetReflectanceModel(model);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetBlinnPhongExponent(double exponent)
{
  this->GetOptics()->SetGlossiness(Property::BlinnPhong, exponent);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetWardRoughness(double roughness)
{
  this->GetOptics()->SetGlossiness(Property::Ward, roughness);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetLafortuneExponent(double exponent)
{
  this->GetOptics()->SetGlossiness(Property::Lafortune, exponent);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetWardAnisotropyScale(double scale)
{
  this->GetOptics()->SetAnisotropyScale(Property::Ward, scale);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetLafortuneAnisotropyScale(double scale)
{
  this->GetOptics()->SetAnisotropyScale(Property::Lafortune, scale);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetSpecularFromExtinction(bool on)
{
  this->GetOptics()->SetSpecularFromExtinction(on);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetFrameSource(int source)
{
  this->GetOptics()->SetFrameSource(source);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetPhaseAnisotropy(double anisotropy)
{
  this->GetOptics()->SetScatteringAnisotropy(static_cast<float>(anisotropy));
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetIntegrationSpace(int space)
{
  this->GetOptics()->SetIntegrationSpace(space);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetClassification(int classification)
{
  this->GetOptics()->SetClassification(classification);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetScalarOpacityUnitInterval(double interval)
{
  this->GetOptics()->SetScalarOpacityUnitInterval(interval);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetSilhouette(int silhouette)
{
  this->GetOptics()->SetSilhouette(silhouette);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetTransmittedLight(int light)
{
  this->GetOptics()->SetTransmittedLight(light);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::RemoveAllOpticsIsosurfaces()
{
  this->GetOptics()->RemoveAllIsosurfaces();
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::AddOpticsIsosurface(double value, double opacity)
{
  this->GetOptics()->AddIsosurface(value, opacity);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetGradientStepLength(double length)
{
  this->GetOptics()->SetGradientStepLength(length);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetLightScale(double scale)
{
  this->GetOptics()->SetLightScale(scale);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetHybridNormals(bool on)
{
  this->GetOptics()->SetHybridNormals(on);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetQuality(int quality)
{
  this->GetBlocks()->SetQuality(quality);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetFrameResolutionFactor(double factor)
{
  this->GetBlocks()->SetPresetKnob(
    "FrameResolutionFactor", [=](Mapper* mapper) { mapper->SetFrameResolutionFactor(factor); });
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetFramePrecision(int bits)
{
  this->GetBlocks()->SetPresetKnob(
    "FramePrecision", [=](Mapper* mapper) { mapper->SetFramePrecision(bits); });
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetCovarianceSamples(int samples)
{
  this->GetBlocks()->SetPresetKnob("CovarianceSamples",
    [=](Mapper* mapper) { mapper->GetAmbientCovarianceFilter()->SetNumberOfSamples(samples); });
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetCovarianceSmoothing(double standardDeviation)
{
  this->GetBlocks()->SetPresetKnob("CovarianceSmoothing", [=](Mapper* mapper) {
    mapper->GetAmbientCovarianceFilter()->SetFilterStandardDeviation(standardDeviation);
  });
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetCovarianceRadius(double radius)
{
  this->GetBlocks()->SetKnob(
    "CovarianceRadius", [=](Mapper* mapper) { mapper->GetAmbientCovarianceFilter()->SetRadius(radius); });
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetCovarianceTolerance(double tolerance)
{
  this->GetBlocks()->SetKnob("CovarianceTolerance",
    [=](Mapper* mapper) { mapper->GetAmbientCovarianceFilter()->SetScalarTolerance(tolerance); });
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetExtinctionGradient(int gradient)
{
  this->GetBlocks()->SetKnob(
    "ExtinctionGradient", [=](Mapper* mapper) { mapper->SetExtinctionGradient(gradient); });
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetScalarGradient(int gradient)
{
  this->GetBlocks()->SetKnob("ScalarGradient", [=](Mapper* mapper) { mapper->SetScalarGradient(gradient); });
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetLightingSamples(int samples)
{
  this->GetBlocks()->SetKnob("LightingSamples", [=](Mapper* mapper) { mapper->SetLightingSamples(samples); });
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetLightingTableSize(int size)
{
  this->GetBlocks()->SetKnob(
    "LightingTableSize", [=](Mapper* mapper) { mapper->SetLightingTableSize(size); });
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetPreIntegrationTableSize(int size)
{
  this->GetBlocks()->SetKnob(
    "PreIntegrationTableSize", [=](Mapper* mapper) { mapper->SetPreIntegrationTableSize(size); });
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetTablePrecision(int bits)
{
  this->GetBlocks()->SetKnob("TablePrecision", [=](Mapper* mapper) { mapper->SetTablePrecision(bits); });
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetOcclusion(bool on)
{
  this->GetOptics()->SetOcclusion(on);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetOcclusionAngle(double degrees)
{
  this->GetOptics()->SetOcclusionAngle(degrees);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetAmbientColor(double red, double green, double blue)
{
  this->GetOptics()->SetAmbientColor(red, green, blue);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetShadows(bool on)
{
  this->GetOptics()->SetShadows(on);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetShadowAngle(double degrees)
{
  this->GetOptics()->SetShadowAngle(degrees);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetVisibilityGridSize(int froxels)
{
  this->GetBlocks()->SetKnob(
    "VisibilityGridSize", [=](Mapper* mapper) { mapper->SetVisibilityGridSize(froxels); });
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetVisibilitySamples(int directions)
{
  this->GetBlocks()->SetKnob(
    "VisibilitySamples", [=](Mapper* mapper) { mapper->SetVisibilitySamples(directions); });
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetVisibilityGatherSamples(int samples)
{
  this->GetBlocks()->SetKnob(
    "VisibilityGatherSamples", [=](Mapper* mapper) { mapper->SetVisibilityGatherSamples(samples); });
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetVisibilityPrecision(int bits)
{
  this->GetBlocks()->SetKnob(
    "VisibilityPrecision", [=](Mapper* mapper) { mapper->SetVisibilityPrecision(bits); });
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetVisibilityAlgorithm(int algorithm)
{
  this->GetBlocks()->SetKnob(
    "VisibilityAlgorithm", [=](Mapper* mapper) { mapper->SetVisibilityAlgorithm(algorithm); });
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetVisibilityDiskSize(int size)
{
  this->GetBlocks()->SetKnob(
    "VisibilityDiskSize", [=](Mapper* mapper) { mapper->SetVisibilityDiskSize(size); });
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetVisibilityTrueDistances(bool on)
{
  this->GetBlocks()->SetKnob(
    "VisibilityTrueDistances", [=](Mapper* mapper) { mapper->SetVisibilityTrueDistances(on); });
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetVisibilitySliceDistance(double froxels)
{
  this->GetBlocks()->SetKnob(
    "VisibilitySliceDistance", [=](Mapper* mapper) { mapper->SetVisibilitySliceDistance(froxels); });
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetSkipEmptySpace(bool on)
{
  this->GetBlocks()->SetKnob("SkipEmptySpace", [=](Mapper* mapper) { mapper->SetSkipEmptySpace(on); });
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetMacrocellSize(int voxels)
{
  this->GetBlocks()->SetKnob("MacrocellSize", [=](Mapper* mapper) { mapper->SetMacrocellSize(voxels); });
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetLinePrecision(int bits)
{
  this->GetBlocks()->SetKnob("LinePrecision", [=](Mapper* mapper) { mapper->SetLinePrecision(bits); });
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetLineRadiusScale(double scale)
{
  this->GetBlocks()->SetKnob("LineRadiusScale", [=](Mapper* mapper) {
    for (int type = 0; type < NumberOfLineTypes; ++type)
    {
      mapper->SetLineRadiusScale(type, scale);
    }
  });
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeRepresentation::SetLineOpacityScale(double scale)
{
  this->GetBlocks()->SetKnob("LineOpacityScale", [=](Mapper* mapper) {
    for (int type = 0; type < NumberOfLineTypes; ++type)
    {
      mapper->SetLineOpacityScale(type, scale);
    }
  });
}
