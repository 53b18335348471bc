// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "OpticsShaderPlaces.h"

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
#include "DataSpace.h"
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
#include "LineLookup.h"
#include "LineRay.h"
#include "LineShadingImpl.h"
#include "LineShadingInit.h"
#include "LineShadowed.h"
#include "LineShadows.h"
#include "LineTerminate.h"
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
#include "PieceDec.h"
#include "PieceEnd.h"
#include "PieceInit.h"
#include "PieceOfSamples.h"
#include "PieceOfSegments.h"
#include "PieceRay.h"
#include "PieceTerminate.h"
#include "OwnDepth.h"
#include "OwnOpacity.h"
#include "OwnOpacityInData.h"
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
#include "RayEnd.h"
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

namespace
{
using F = OpticsFeature;

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
  { F::Piece, &BaseDec, PieceDec },

  { F::Piece, &BaseInit, PieceInit },
  { F::PieceOfSamples, &BaseInit, PieceOfSamples },
  { F::PieceOfSegments, &BaseInit, PieceOfSegments },
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

  { F::Piece, &TerminateInit, PieceTerminate },
  { F::PieceOfSegments, &EndPlace, PieceEnd },
  { F::Piece, &ComputeRayDirectionDec, PieceRay },
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

  { F::RayEnd, &ComputeRayDirectionDec, RayEnd },
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
}

//------------------------------------------------------------------------------
std::string OpticsText(const Place& place, const OpticsFeatures& features)
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
