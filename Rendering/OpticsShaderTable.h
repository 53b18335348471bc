// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The one table of what is injected into VTK's fragment shader, and where. The source is a function
// of the set of features alone: it is rebuilt when the set changes, and at no other time.

#ifndef OpticsShaderTable_h
#define OpticsShaderTable_h

#include <bitset>
#include <string>

enum class OpticsFeature
{
  Ray,          // eye space along the ray
  SampleScalar, // the sample's components are handed on to computeLighting()
  OpacityTable,
  ColorTable,
  NoColorTable,
  OpacityFormulas,
  Reflectance, // light is evaluated here: replaces VTK's computeLighting()
  ReflectanceVTK,
  ReflectanceNone,
  ReflectanceBlinnPhong,
  ReflectanceWard,
  ReflectanceLafortune,
  CoefficientsOfProperty,
  CoefficientsOfTable,
  ScalarPairFetched,
  ScalarPairExtrapolated,
  MultiSample,
  HybridNormals,
  HybridDiffuse,     // with a model whose diffuse part has a side
  Scattering,        // a model whose diffuse part is a phase function
  Surface,           // a model with a normal
  ExtinctionSurface, // a model with the normal of the classified extinction
  SurfaceOfExtinction,
  SurfaceInData,
  ScalarLookup,
  ScalarGradientStored,
  ScalarGradientCentral,
  Anisotropic,
  AnisotropyMap,
  AnisotropyComponents,
  AnisotropyWorld,
  FrameLookup, // the grid of stored normals and frames is sampled
  GradientStored,
  GradientCentral,
  GradientCentralWithoutNormal,
  GradientCentralWithNormal,
  OpacityAtScalar,
  OpacityAtScalarAndGradient,
  OpacityAt2D,
  OpacityAtLabel,
  GradientOpacityNone,
  GradientOpacityScalar,
  LightsDirectional,
  LightsPositional,
  Integral, // segments are integrated here: replaces VTK's sampling of a ray
  IntegralPost,
  IntegralPreIntegrated,
  IntegralInData,
  IntegralInSpace,
  ColorOfSegment,
  ColorOfFirst,
  ColorOfSample,
  SilhouetteOff,
  SilhouetteOn, // any but off
  SilhouetteExact,
  SilhouetteClamped,
  TransmittedNone,
  Transmitted,
  HiddenHalf,
  HiddenByCropping,
  AmbientLight, // other than white and everywhere the same
  AmbientAlone, // without Shade
  OcclusionNone,
  OwnOpacity,
  OwnOpacityInData,
  Occlusion,
  OcclusionGathered,
  SeenSamples,
  Shadows,
  DataSpaceFormulas,
  VisibilityFormulas,
  VisibilitySweep, // the text serves a sweep as well (SweepProgram)
  SweepOfSample,
  SweepOfSegment,
  SweepInSpace,
  SweepInData,
  SweepIsosurfaces,
  SweepIsosurfacesNone,
  SweepFrame,
  SweepClipping,
  SweepClippingNone,
  IsosurfacesNone,
  Isosurfaces,
  RayEnd,     // a leap may go beyond it
  EmptySpace, // what sees nothing is skipped
  EmptySpaceOfSamples,
  EmptySpaceOfSegments, // of the integral's
  Lines,                // anisotropic voxels are drawn in place of VTK's samples
  LineBlock,
  LineBlockNone,
  LineAmbient,
  LineAmbientNone,
  LineShadows,
  Piece, // of a larger volume
  PieceOfSamples,
  PieceOfSegments, // of the integral's
  Count
};

class OpticsFeatures
{
public:
  void Add(OpticsFeature feature) { this->Bits.set(static_cast<std::size_t>(feature)); }
  bool Has(OpticsFeature feature) const { return this->Bits.test(static_cast<std::size_t>(feature)); }
  bool IsEmpty() const { return this->Bits.none(); }
  bool operator==(const OpticsFeatures& other) const
  {
    return this->Bits == other.Bits && this->NumberOfLights == other.NumberOfLights &&
      this->NumberOfShadowViews == other.NumberOfShadowViews &&
      this->NumberOfGatherSamples == other.NumberOfGatherSamples;
  }

  int NumberOfLights = 0;
  int NumberOfShadowViews = 0;
  int NumberOfGatherSamples = 0;

private:
  std::bitset<static_cast<std::size_t>(OpticsFeature::Count)> Bits;
};

/**
 * Inserts the text of the features at VTK's tags, before VTK's own text. Where this VTK's shader has no such tag it is
 * left as it was, and the tag returned; else nothing.
 */
std::string InsertOpticsBeforeVTK(std::string& fragment, const OpticsFeatures& features);

/**
 * Replaces statements of VTK's own text, after VTK has written it. Returns the statement that is missing, or nothing.
 */
std::string ReplaceOpticsInVTK(std::string& fragment, const OpticsFeatures& features);

#endif
