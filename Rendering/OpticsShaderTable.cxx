// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "OpticsShaderTable.h"

#include "vtkShaderProgram.h"

#include "AmbientAlone.h"
#include "AmbientColor.h"
#include "AmbientSurface.h"
#include "AnisotropyComponents.h"
#include "AnisotropyFrame.h"
#include "AnisotropyMap.h"
#include "AnisotropyWorld.h"
#include "ClassifiedSample.h"
#include "CoefficientsDec.h"
#include "CoefficientsOfProperty.h"
#include "CoefficientsOfTable.h"
#include "ColorOfFirst.h"
#include "ColorOfSample.h"
#include "ColorOfSegment.h"
#include "ColorTable.h"
#include "CylinderLighting.h"
#include "DataSpace.h"
#include "DataSpaceInterior.h"
#include "DataSpaceSegment.h"
#include "EmptySpaceDec.h"
#include "EmptySpaceInit.h"
#include "EmptySpaceOfSamples.h"
#include "EmptySpaceOfSegments.h"
#include "EmptySpaceSegmentsInit.h"
#include "ExtinctionGradientCentral.h"
#include "ExtinctionGradientStored.h"
#include "FrameDec.h"
#include "FrameInit.h"
#include "GradientOpacityNone.h"
#include "GradientOpacityScalar.h"
#include "HiddenByCropping.h"
#include "HiddenHalf.h"
#include "HybridDec.h"
#include "HybridDiffuse.h"
#include "HybridNormal.h"
#include "HybridSurface.h"
#include "IntegralDec.h"
#include "IntegralImpl.h"
#include "IntegralInit.h"
#include "IntegralPath.h"
#include "IntegralRay.h"
#include "IntegralTerminate.h"
#include "Isosurfaces.h"
#include "IsosurfacesNone.h"
#include "Lighting.h"
#include "LightsDirectional.h"
#include "LightsPositional.h"
#include "LineAmbient.h"
#include "LineAmbientNone.h"
#include "LineBlock.h"
#include "LineBlockNone.h"
#include "LineEvaluationFragment.h"
#include "LineEvaluationVertex.h"
#include "LineLookup.h"
#include "LineRay.h"
#include "LineShadingImpl.h"
#include "LineShadingInit.h"
#include "LineShadowed.h"
#include "LineShadows.h"
#include "LineTerminate.h"
#include "LineVoxel.h"
#include "LinesDec.h"
#include "MajorParameterLafortune.h"
#include "MajorParameterWard.h"
#include "MultiSampleRule.h"
#include "NoColorTable.h"
#include "NoNormalForCentral.h"
#include "NormalForCentral.h"
#include "NormalLookup.h"
#include "Occlusion.h"
#include "OcclusionGathered.h"
#include "OcclusionNone.h"
#include "Opacity.h"
#include "OpacityAt2D.h"
#include "OpacityAtLabel.h"
#include "OpacityAtScalar.h"
#include "OpacityAtScalarAndGradient.h"
#include "OpacityTable.h"
#include "PhaseFunction.h"
#include "OwnDepth.h"
#include "OwnOpacity.h"
#include "OwnOpacityInData.h"
#include "ProjectedTetrahedraDec.h"
#include "ProjectedTetrahedraInterior.h"
#include "ProjectedTetrahedraIsosurfaces.h"
#include "ProjectedTetrahedraMain.h"
#include "ProjectedTetrahedraSegment.h"
#include "ProjectedTetrahedraVertex.h"
#include "RayDec.h"
#include "RayInit.h"
#include "Reflectance.h"
#include "ReflectanceBlinnPhong.h"
#include "ReflectanceLafortune.h"
#include "ReflectanceNone.h"
#include "ReflectanceVTK.h"
#include "ReflectanceWard.h"
#include "SampleScalar.h"
#include "ScalarGradientCentral.h"
#include "ScalarGradientOfSample.h"
#include "ScalarGradientStored.h"
#include "ScalarLookup.h"
#include "ScalarPairExtrapolated.h"
#include "ScalarPairFetched.h"
#include "ScatteringPhase.h"
#include "SeenSamples.h"
#include "SegmentInData.h"
#include "SegmentInSpace.h"
#include "SegmentOpacity.h"
#include "SegmentPost.h"
#include "SegmentPreIntegrated.h"
#include "SegmentSmooth.h"
#include "ShadowLookup.h"
#include "ShadowOfLight.h"
#include "ShadowSurface.h"
#include "SilhouetteClamped.h"
#include "SilhouetteExact.h"
#include "SilhouetteGeometry.h"
#include "SilhouetteOff.h"
#include "SoftRange.h"
#include "SphericalHarmonics.h"
#include "SurfaceAnisotropic.h"
#include "SurfaceCoefficient.h"
#include "SurfaceDec.h"
#include "SurfaceFlag.h"
#include "SurfaceInData.h"
#include "SurfaceOfExtinction.h"
#include "SweepClipping.h"
#include "SweepClippingNone.h"
#include "SweepDec.h"
#include "SweepFrame.h"
#include "SweepInData.h"
#include "SweepInSpace.h"
#include "SweepIsosurfaces.h"
#include "SweepIsosurfacesNone.h"
#include "SweepOfSample.h"
#include "SweepOfSegment.h"
#include "SweepRayBegin.h"
#include "SweepRayEnd.h"
#include "SweepTerminate.h"
#include "Transmitted.h"
#include "TransmittedDec.h"
#include "TransmittedNone.h"
#include "TransmittedShare.h"
#include "TransmittedSide.h"
#include "TransmittedSurface.h"
#include "Visibility.h"

#include <algorithm>
#include <vector>

namespace
{
using F = OpticsFeature;

struct Place
{
  const char* Tag;
  bool KeepsVTKText;        // ours is added to VTK's, or stands in its place
  bool IsBeforeVTK = false; // added before VTK's, or behind it
};

const Place BaseDec = { "//VTK::Base::Dec", true };
const Place BaseInit = { "//VTK::Base::Init", true };
const Place ComputeLightingDec = { "//VTK::ComputeLighting::Dec", true };
const Place ComputeRayDirectionDec = { "//VTK::ComputeRayDirection::Dec", true };
const Place ClippingImpl = { "//VTK::Clipping::Impl", true };
const Place BaseImpl = { "//VTK::Base::Impl", true, true };
const Place ShadingInit = { "//VTK::Shading::Init", true };
const Place ShadingImpl = { "//VTK::Shading::Impl", false };
const Place DepthPassImpl = { "//VTK::DepthPass::Impl", true };
const Place TerminateImpl = { "//VTK::Terminate::Impl", false };
const Place AfterTerminateImpl = { "//VTK::Terminate::Impl", true };
// Places of our own, in Lighting.glsl and LineShadingImpl.glsl.
const Place GradientPlace = { "//Optics::Gradient", false };
const Place SurfacePlace = { "//Optics::Surface", false };
const Place LightPlace = { "//Optics::Light", false };
const Place TransmissionPlace = { "//Optics::Transmission", false };
const Place LinesPlace = { "//Optics::Lines", false };

struct Row
{
  OpticsFeature Feature;
  const Place* Where;
  const char* Text;
};

// The order of the rows is the order of the text at each place.
const Row Table[] = {
  { F::SampleScalar, &BaseDec, SampleScalar },
  { F::IntegralInData, &BaseDec, SurfaceFlag },
  { F::Transmitted, &BaseDec, TransmittedDec },
  { F::Ray, &BaseDec, RayDec },
  { F::FrameLookup, &BaseDec, FrameDec },
  { F::VisibilitySweep, &BaseDec, SweepDec },
  { F::Lines, &BaseDec, LinesDec },

  { F::Ray, &BaseInit, RayInit },
  { F::FrameLookup, &BaseInit, FrameInit },

  { F::Scattering, &ComputeLightingDec, PhaseFunction },
  { F::OpacityFormulas, &ComputeLightingDec, Opacity },
  { F::DataSpaceFormulas, &ComputeLightingDec, DataSpace },
  { F::VisibilityFormulas, &ComputeLightingDec, Visibility },
  { F::ExtinctionSurface, &ComputeLightingDec, Reflectance },
  { F::Anisotropic, &ComputeLightingDec, AnisotropyFrame },
  { F::FrameLookup, &ComputeLightingDec, NormalLookup },
  { F::AnisotropyMap, &ComputeLightingDec, AnisotropyMap },
  { F::AnisotropyComponents, &ComputeLightingDec, AnisotropyComponents },
  { F::AnisotropyWorld, &ComputeLightingDec, AnisotropyWorld },
  { F::OpacityTable, &ComputeLightingDec, OpacityTable },
  { F::OpacityAtScalar, &ComputeLightingDec, OpacityAtScalar },
  { F::OpacityAtScalarAndGradient, &ComputeLightingDec, OpacityAtScalarAndGradient },
  { F::OpacityAt2D, &ComputeLightingDec, OpacityAt2D },
  { F::OpacityAtLabel, &ComputeLightingDec, OpacityAtLabel },
  { F::GradientStored, &ComputeLightingDec, ExtinctionGradientStored },
  { F::GradientCentralWithNormal, &ComputeLightingDec, NormalForCentral },
  { F::GradientCentralWithoutNormal, &ComputeLightingDec, NoNormalForCentral },
  { F::GradientCentral, &ComputeLightingDec, ExtinctionGradientCentral },
  { F::ScalarLookup, &ComputeLightingDec, ScalarLookup },
  { F::ScalarGradientStored, &ComputeLightingDec, ScalarGradientStored },
  { F::ScalarGradientCentral, &ComputeLightingDec, ScalarGradientCentral },
  { F::ScalarPairFetched, &ComputeLightingDec, ScalarPairFetched },
  { F::ScalarPairExtrapolated, &ComputeLightingDec, ScalarPairExtrapolated },
  { F::Surface, &ComputeLightingDec, SurfaceDec },
  { F::SurfaceOfExtinction, &ComputeLightingDec, SurfaceOfExtinction },
  { F::SurfaceInData, &ComputeLightingDec, SurfaceInData },
  { F::ExtinctionSurface, &ComputeLightingDec, SurfaceCoefficient },
  { F::ReflectanceWard, &ComputeLightingDec, MajorParameterWard },
  { F::ReflectanceLafortune, &ComputeLightingDec, MajorParameterLafortune },
  { F::Anisotropic, &ComputeLightingDec, SurfaceAnisotropic },
  { F::ReflectanceVTK, &ComputeLightingDec, ReflectanceVTK },
  { F::ReflectanceNone, &ComputeLightingDec, ReflectanceNone },
  { F::ReflectanceBlinnPhong, &ComputeLightingDec, ReflectanceBlinnPhong },
  { F::ReflectanceWard, &ComputeLightingDec, ReflectanceWard },
  { F::ReflectanceLafortune, &ComputeLightingDec, ReflectanceLafortune },
  { F::Scattering, &ComputeLightingDec, ScatteringPhase },
  { F::LightsDirectional, &ComputeLightingDec, LightsDirectional },
  { F::LightsPositional, &ComputeLightingDec, LightsPositional },
  { F::GradientOpacityNone, &ComputeLightingDec, GradientOpacityNone },
  { F::GradientOpacityScalar, &ComputeLightingDec, GradientOpacityScalar },
  { F::Reflectance, &ComputeLightingDec, CoefficientsDec },
  { F::CoefficientsOfProperty, &ComputeLightingDec, CoefficientsOfProperty },
  { F::CoefficientsOfTable, &ComputeLightingDec, CoefficientsOfTable },
  { F::HybridNormals, &ComputeLightingDec, HybridNormal },
  { F::HybridNormals, &ComputeLightingDec, HybridDec },
  { F::OwnOpacity, &ComputeLightingDec, OwnOpacity },
  { F::OwnOpacityInData, &ComputeLightingDec, OwnOpacityInData },
  { F::VisibilitySweep, &ComputeLightingDec, OwnDepth },
  { F::OcclusionNone, &ComputeLightingDec, OcclusionNone },
  { F::Occlusion, &ComputeLightingDec, Occlusion },
  { F::OcclusionGathered, &ComputeLightingDec, OcclusionGathered },
  { F::AmbientLight, &ComputeLightingDec, AmbientColor },
  { F::AmbientAlone, &ComputeLightingDec, AmbientAlone },
  { F::Shadows, &ComputeLightingDec, ShadowLookup },
  { F::Reflectance, &ComputeLightingDec, Lighting },
  { F::MultiSample, &ComputeLightingDec, SoftRange },
  { F::MultiSample, &ComputeLightingDec, MultiSampleRule },
  { F::MultiSample, &ComputeLightingDec, ClassifiedSample },

  { F::ScalarGradientStored, &GradientPlace, ScalarGradientOfSample },
  { F::ScalarGradientCentral, &GradientPlace, ScalarGradientOfSample },
  { F::HybridNormals, &SurfacePlace, HybridSurface },
  { F::HybridDiffuse, &SurfacePlace, HybridDiffuse },
  { F::AmbientLight, &SurfacePlace, AmbientSurface },
  { F::Shadows, &SurfacePlace, ShadowSurface },
  { F::Transmitted, &SurfacePlace, TransmittedSurface },
  { F::Shadows, &LightPlace, ShadowOfLight },
  { F::Transmitted, &LightPlace, TransmittedSide },
  { F::Transmitted, &TransmissionPlace, Transmitted },

  { F::Integral, &ComputeRayDirectionDec, IntegralDec },
  { F::ColorTable, &ComputeRayDirectionDec, ColorTable },
  { F::NoColorTable, &ComputeRayDirectionDec, NoColorTable },
  { F::IntegralPost, &ComputeRayDirectionDec, SegmentPost },
  { F::IntegralPreIntegrated, &ComputeRayDirectionDec, SegmentPreIntegrated },
  { F::IntegralInData, &ComputeRayDirectionDec, SegmentInData },
  { F::IntegralInSpace, &ComputeRayDirectionDec, SegmentInSpace },
  { F::Integral, &ComputeRayDirectionDec, SegmentOpacity },
  { F::ColorOfSegment, &ComputeRayDirectionDec, ColorOfSegment },
  { F::ColorOfFirst, &ComputeRayDirectionDec, ColorOfFirst },
  { F::ColorOfSample, &ComputeRayDirectionDec, ColorOfSample },
  { F::SilhouetteOff, &ComputeRayDirectionDec, SilhouetteOff },
  { F::SilhouetteOn, &ComputeRayDirectionDec, SilhouetteGeometry },
  { F::SilhouetteExact, &ComputeRayDirectionDec, SilhouetteExact },
  { F::SilhouetteClamped, &ComputeRayDirectionDec, SilhouetteClamped },
  { F::TransmittedNone, &ComputeRayDirectionDec, TransmittedNone },
  { F::Transmitted, &ComputeRayDirectionDec, TransmittedShare },
  { F::Integral, &ComputeRayDirectionDec, SegmentSmooth },
  { F::IsosurfacesNone, &ComputeRayDirectionDec, IsosurfacesNone },
  { F::Isosurfaces, &ComputeRayDirectionDec, Isosurfaces },
  { F::HiddenHalf, &ComputeRayDirectionDec, HiddenHalf },
  { F::HiddenByCropping, &ComputeRayDirectionDec, HiddenByCropping },
  { F::Integral, &ComputeRayDirectionDec, IntegralRay },
  { F::SweepClipping, &ComputeRayDirectionDec, SweepClipping },
  { F::SweepClippingNone, &ComputeRayDirectionDec, SweepClippingNone },
  { F::SweepOfSample, &ComputeRayDirectionDec, SweepOfSample },
  { F::SweepInSpace, &ComputeRayDirectionDec, SweepInSpace },
  { F::SweepInData, &ComputeRayDirectionDec, SweepInData },
  { F::SweepIsosurfaces, &ComputeRayDirectionDec, SweepIsosurfaces },
  { F::SweepIsosurfacesNone, &ComputeRayDirectionDec, SweepIsosurfacesNone },
  { F::SweepOfSegment, &ComputeRayDirectionDec, SweepOfSegment },
  { F::VisibilitySweep, &ClippingImpl, SweepRayBegin },
  { F::Integral, &ClippingImpl, IntegralPath },
  { F::Integral, &ShadingInit, IntegralInit },
  { F::Lines, &ShadingInit, LineShadingInit },
  { F::EmptySpace, &ShadingInit, EmptySpaceInit },
  { F::EmptySpaceOfSegments, &ShadingInit, EmptySpaceSegmentsInit },
  { F::VisibilitySweep, &ShadingInit, SweepRayEnd },
  { F::SweepFrame, &ShadingInit, SweepFrame },
  { F::VisibilitySweep, &DepthPassImpl, SweepTerminate },
  { F::Integral, &ShadingImpl, IntegralImpl },
  { F::Integral, &TerminateImpl, IntegralTerminate },

  { F::EmptySpace, &BaseDec, EmptySpaceDec },
  { F::EmptySpaceOfSamples, &BaseImpl, EmptySpaceOfSamples },
  { F::EmptySpaceOfSegments, &BaseImpl, EmptySpaceOfSegments },
  { F::SeenSamples, &BaseImpl, SeenSamples },
  { F::Lines, &ComputeRayDirectionDec, LineLookup },
  { F::LineBlockNone, &ComputeRayDirectionDec, LineBlockNone },
  { F::LineBlock, &ComputeRayDirectionDec, LineBlock },
  { F::LineAmbientNone, &ComputeRayDirectionDec, LineAmbientNone },
  { F::LineAmbient, &ComputeRayDirectionDec, LineAmbient },
  { F::LineShadows, &ComputeRayDirectionDec, LineShadows },
  { F::Lines, &ComputeRayDirectionDec, LineRay },
  { F::Lines, &ShadingImpl, LineShadingImpl },
  { F::LineShadows, &LinesPlace, LineShadowed },
  { F::Lines, &AfterTerminateImpl, LineTerminate },
};

// Where VTK hands a sample to computeLighting(), the sample's scalar is handed on with it.
struct Statement
{
  const char* Text;
  const char* Replacement;
};
const Statement LightingCalls[] = {
  { "return clamp(computeLighting(", "g_opticsScalar = scalar;\n  return opticsUnclamped(computeLighting(" },
  { "return computeLighting(", "g_opticsScalar = scalar;\n  return computeLighting(" },
  { "g_srcColor = computeLighting(", "g_opticsScalar = scalar;\n      g_srcColor = computeLighting(" },
};

// Where VTK classifies a sample by its scalar alone; after the calls above.
const Statement ClassificationCalls[] = {
  { "g_srcColor.a = computeOpacity(scalar);",
    "g_srcColor.a = opticsClassifiedOpacity(scalar, computeOpacity(scalar));" },
  { "float opacity = computeOpacity(scalar);",
    "float opacity = opticsClassifiedOpacity(scalar, computeOpacity(scalar));" },
  { "return clamp(computeLighting(", "return clamp(opticsLightClassified(" },
  { "return opticsUnclamped(computeLighting(", "return opticsUnclamped(opticsLightClassified(" },
};

template <std::size_t Count>
bool ReplaceAny(std::string& fragment, const Statement (&statements)[Count])
{
  bool found = false;
  for (const Statement& statement : statements)
  {
    found |= vtkShaderProgram::Substitute(fragment, statement.Text, statement.Replacement, true);
  }
  return found;
}

std::string TextFor(const Place& place, const OpticsFeatures& features)
{
  std::string text;
  for (const Row& row : Table)
  {
    if (row.Where == &place && features.Has(row.Feature))
    {
      text += row.Text;
    }
  }
  return text;
}

// GLSL arrays are sized by constants, and have at least one element.
std::string NumbersText(const OpticsFeatures& features)
{
  const int slots = std::max(features.NumberOfLights, 1);
  const std::string text = "#define OPTICS_NUMBER_OF_LIGHTS " + std::to_string(features.NumberOfLights) +
    "\n#define OPTICS_LIGHT_SLOTS " + std::to_string(slots) + "\n";
  return features.NumberOfShadowViews == 0
    ? text
    : text + "#define OPTICS_SHADOW_VIEWS " + std::to_string(features.NumberOfShadowViews) + "\n";
}

// Our own places are in our text; those that no term fills leave nothing behind.
void FillOwnPlaces(std::string& fragment, const OpticsFeatures& features)
{
  for (const Place* place : { &GradientPlace, &SurfacePlace, &LightPlace, &TransmissionPlace, &LinesPlace })
  {
    vtkShaderProgram::Substitute(fragment, place->Tag, TextFor(*place, features), false);
  }
}

bool Insert(std::string& fragment, const Place& place, const std::string& text)
{
  if (text.empty())
  {
    return true;
  }
  const std::string kept = place.KeepsVTKText ? std::string(place.Tag) + "\n" : std::string();
  return vtkShaderProgram::Substitute(
    fragment, place.Tag, place.IsBeforeVTK ? text + kept : kept + text, false);
}

// Our own lighting stands in the place of VTK's; without it what is needed there is added.
bool InsertLighting(std::string& fragment, const OpticsFeatures& features)
{
  Place place = ComputeLightingDec;
  std::string text = TextFor(ComputeLightingDec, features);
  const bool replaces = features.Has(OpticsFeature::Reflectance) || features.Has(OpticsFeature::AmbientAlone);
  place.KeepsVTKText = !replaces;
  if (features.Has(OpticsFeature::OcclusionGathered))
  {
    text.insert(0, "#define OPTICS_GATHER_SAMPLES " + std::to_string(features.NumberOfGatherSamples) + "\n");
  }
  if (replaces || features.Has(OpticsFeature::Shadows))
  {
    text.insert(0, NumbersText(features));
  }
  return Insert(fragment, place, text);
}
}

//------------------------------------------------------------------------------
bool InsertOpticsBeforeVTK(std::string& fragment, const OpticsFeatures& features)
{
  bool found = InsertLighting(fragment, features);
  for (const Place* place : { &BaseDec, &BaseInit, &ComputeRayDirectionDec, &ClippingImpl, &ShadingInit,
         &BaseImpl, &ShadingImpl, &DepthPassImpl, &TerminateImpl, &AfterTerminateImpl })
  {
    found &= Insert(fragment, *place, TextFor(*place, features));
  }
  FillOwnPlaces(fragment, features);
  return found;
}

//------------------------------------------------------------------------------
bool ReplaceOpticsInVTK(std::string& fragment, const OpticsFeatures& features)
{
  const bool isLit = !features.Has(OpticsFeature::Reflectance) || ReplaceAny(fragment, LightingCalls);
  return isLit && (!features.Has(OpticsFeature::MultiSample) || ReplaceAny(fragment, ClassificationCalls));
}

//------------------------------------------------------------------------------
std::string LineEvaluationVertexShader(int order, int types)
{
  const std::string constants = "#define OPTICS_LINE_ORDER " + std::to_string(order) +
    "\n#define OPTICS_LINE_TYPES " + std::to_string(types) + "\n";
  return "//VTK::System::Dec\n" + constants + Opacity + SphericalHarmonics + CylinderLighting + LineVoxel +
    LineEvaluationVertex;
}

//------------------------------------------------------------------------------
std::string LineEvaluationFragmentShader()
{
  return LineEvaluationFragment;
}

//------------------------------------------------------------------------------
std::string ProjectedTetrahedraVertexShader()
{
  return ProjectedTetrahedraVertex;
}

//------------------------------------------------------------------------------
std::string ProjectedTetrahedraFragmentShader(const std::string& color)
{
  return std::string(ProjectedTetrahedraDec) + Opacity + DataSpace + color + ProjectedTetrahedraMain;
}

//------------------------------------------------------------------------------
std::string ProjectedTetrahedraFragmentShader(int silhouette, bool hasIsosurfaces)
{
  // a constant, so that what the mode does not need is not compiled
  const std::string interior =
    "int SilhouetteMode() { return " + std::to_string(silhouette) + "; }\n" + DataSpaceInterior;
  return ProjectedTetrahedraFragmentShader(hasIsosurfaces
      ? interior + ProjectedTetrahedraIsosurfaces + DataSpaceSegment + ProjectedTetrahedraSegment
      : interior + ProjectedTetrahedraInterior);
}
