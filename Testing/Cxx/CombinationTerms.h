// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// What a picture of the mapper is made of: terms, each with its choices, the first of which is the default.

#ifndef CombinationTerms_h
#define CombinationTerms_h

#include "LineTermScene.h"
#include "SupportedSettings.h"

#include "vtkAmbientCovarianceFilter.h"
#include "vtkLight.h"
#include "vtkMultiSampleClassification.h"
#include "vtkShortArray.h"

#include <cstring>

namespace
{
struct Choice
{
  const char* Name;
  Setting Apply;
  bool IsModelled = true; // by the reference in double
};

struct Term
{
  const char* Name;
  std::vector<Choice> Choices;
};

// As TestScene has it, on few voxels and pixels.
struct CombinationScene : TestScene
{
  CombinationScene()
  {
    this->Source->SetDimensions(12, 12, 12);
    this->Window->SetSize(24, 24);
    this->Property->SetScalarOpacityUnitDistance(0.2);
    this->Property->SetSpecular(1.0); // highlights are what the models differ by
    this->Optics->SetVisibilityGridSize(12);
  }
};

// Of the scalars, by what the data set made of the opacity function, which ends at 0.6 of it.
inline double ScaleOf(TestScene& scene)
{
  return scene.Opacity->GetRange()[1] / 0.6;
}

inline Setting RowNamed(const char* name)
{
  for (const Row& row : Rows)
  {
    if (std::strcmp(row.Name, name) == 0)
    {
      return row.Apply;
    }
  }
  std::cout << "There is no setting named " << name << std::endl;
  std::abort();
}

inline void UseShorts(TestScene& scene)
{
  vtkSmartPointer<vtkImageData> image = Field(scene);
  vtkNew<vtkShortArray> scalars;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double value = image->GetPointData()->GetScalars()->GetComponent(i, 0);
    scalars->InsertNextValue(static_cast<short>(1000.0 * value));
  }
  image->GetPointData()->SetScalars(scalars);
  scene.Mapper->SetInputData(image);
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(400.0, 0.0);
  scene.Opacity->AddPoint(600.0, 0.9);
  scene.Color->AddRGBPoint(1000.0, 0.9, 0.7, 0.5);
}

// Spirals as anisotropic voxels, on as many as the other data.
inline void UseLines(TestScene& scene)
{
  static const vtkSmartPointer<vtkImageData> voxels = Spirals(12, 12, 12, 2, false, 300, 0.03);
  scene.Mapper->SetInputData(voxels);
}

// Both functions stretched over the data's range.
inline void UseNativeRanges(TestScene& scene)
{
  scene.Mapper->SetColorRangeType(vtkGPUVolumeRayCastMapper::NATIVE);
  scene.Mapper->SetScalarOpacityRangeType(vtkGPUVolumeRayCastMapper::NATIVE);
}

inline void UseData(TestScene& scene)
{
  scene.Property->SetIntegrationSpaceToData();
  scene.Property->SetScalarOpacityUnitInterval(0.05 * ScaleOf(scene));
}

inline void UseLighting(TestScene& scene)
{
  const double scale = ScaleOf(scene);
  const double low[2] = { -scale, 0.45 * scale }, high[2] = { 0.5 * scale, 2.0 * scale };
  vtkNew<vtkLightingTransferFunction> function;
  function->SetSoftness(function->AddBoundary(low, high, 0.2, 0.7, 0.5), 0.1 * scale);
  scene.Property->SetLightingTransferFunction(function);
}

inline void UseRule(TestScene& scene)
{
  const double scale = ScaleOf(scene);
  const double sample[2] = { 0.3 * scale, 0.6 * scale }, any[2] = { -scale, 2.0 * scale };
  vtkNew<vtkMultiSampleClassification> rules;
  rules->SetSoftness(rules->AddRule(sample, any, any, 0.9, 0.2, 0.1, 0.3), 0, 0.1 * scale);
  scene.Property->SetMultiSampleClassification(rules);
}

inline vtkLight* AddSceneLight(TestScene& scene, double x, double y, double z)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(x, y, z);
  scene.Renderer->AddLight(light);
  return light;
}

inline void AddSuns(TestScene& scene)
{
  AddSceneLight(scene, 3.0, -2.0, 4.0)->SetDiffuseColor(1.0, 0.8, 0.6);
  AddSceneLight(scene, -3.0, -1.0, 1.0)->SetDiffuseColor(0.2, 0.3, 0.6);
}

inline void AddLamp(TestScene& scene)
{
  vtkLight* lamp = AddSceneLight(scene, -1.0, -2.0, 0.5);
  lamp->SetPositional(1);
  lamp->SetConeAngle(60.0);
  lamp->SetAttenuationValues(0.5, 0.2, 0.1);
}

inline void UseOcclusion(TestScene& scene, int algorithm, int samples, int bits)
{
  scene.Property->OcclusionOn();
  scene.Optics->SetVisibilityAlgorithm(algorithm);
  scene.Optics->SetVisibilitySamples(samples);
  scene.Optics->SetVisibilityPrecision(bits);
}

// On a grid that is as small as that of the other scenes.
inline void UsePreset(TestScene& scene, int quality)
{
  scene.Optics->SetQuality(quality);
  scene.Optics->SetVisibilityGridSize(12);
}

inline void CropTo(TestScene& scene, int flags)
{
  scene.Mapper->SetCropping(1);
  scene.Mapper->SetCroppingRegionPlanes(-0.31, 0.52, -0.33, 0.71, -0.42, 0.63);
  scene.Mapper->SetCroppingRegionFlags(flags);
}

// A corner between three planes.
inline void ClipByThree(TestScene& scene)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(-0.2, -0.2, -0.2);
    plane->SetNormal(axis == 0 ? 1.0 : 0.1, axis == 1 ? 1.0 : 0.2, axis == 2 ? 1.0 : 0.0);
    scene.Mapper->AddClippingPlane(plane);
  }
}

// The inner part of the 12 points, of a larger whole.
inline void DrawPiece(TestScene& scene)
{
  scene.Optics->SetDrawnExtent(2, 8, 0, 11, 1, 11);
  scene.Optics->SetWholeExtent(-4, 11, 0, 11, 0, 20);
}

inline void Mirror(TestScene& scene)
{
  vtkNew<vtkTransform> transform;
  transform->Scale(-1.0, 1.0, 1.0);
  scene.Volume->SetUserTransform(transform);
}

inline void Turn(TestScene& scene)
{
  vtkNew<vtkTransform> transform;
  transform->RotateWXYZ(40.0, 1.0, 2.0, 3.0);
  transform->Scale(1.2, 1.2, 1.2);
  scene.Volume->SetUserTransform(transform);
}

inline void AddSurface(TestScene& scene, double value, double opacity)
{
  scene.Property->AddIsosurface(value * ScaleOf(scene), 0.9, 0.2, 0.1, opacity);
}

using P = vtkOpticsVolumeProperty;

// What comes first is applied first.
const std::vector<Term> Terms = {
  { "data",
    { { "floats", [](TestScene&) {} }, { "shorts", UseShorts }, { "direction matrix", UseDirectionMatrix },
      { "cell data", UseCellData, false },
      { "luminance and opacity", [](TestScene& s) { UseDependentComponents(s, 2); }, false },
      { "colour and opacity", [](TestScene& s) { UseDependentComponents(s, 4); }, false },
      { "blanked points", Blank, false }, { "lines", UseLines, false } } },
  { "ranges of functions", { { "of scalars", [](TestScene&) {} }, { "their own", UseNativeRanges, false } } },
  { "steps",
    { { "short", [](TestScene&) {} }, { "long", [](TestScene& s) { s.Mapper->SetSampleDistance(0.13F); } },
      { "automatic", [](TestScene& s) { s.Mapper->SetAutoAdjustSampleDistances(1); }, false },
      { "locked", [](TestScene& s) { s.Mapper->SetLockSampleDistanceToInputSpacing(1); }, false },
      { "Draft", [](TestScene& s) { UsePreset(s, vtkOpticsVolumeMapper::Draft); }, false },
      { "Balanced", [](TestScene& s) { UsePreset(s, vtkOpticsVolumeMapper::Balanced); }, false } } },
  { "reflectance",
    { { "VTK", [](TestScene& s) { s.Property->SetSpecular(0.2); } }, // VTK clamps a sample at 1
      { "not shaded", [](TestScene& s) { s.Property->ShadeOff(); } },
      { "None", [](TestScene& s) { s.Property->SetReflectanceModelToNone(); } },
      { "BlinnPhong", [](TestScene& s) { s.Property->SetReflectanceModelToBlinnPhong(); } },
      { "Ward", [](TestScene& s) { s.Property->SetReflectanceModelToWard(); } },
      { "Lafortune", [](TestScene& s) { s.Property->SetReflectanceModelToLafortune(); } } } },
  { "frames",
    { { "Map", [](TestScene&) {} },
      { "Components",
        [](TestScene& s) { s.Optics->GetAmbientCovarianceFilter()->SetStorageToComponents(); } },
      { "World", [](TestScene& s) { s.Optics->GetAmbientCovarianceFilter()->SetStorageToWorld(); } },
      { "Curvature", [](TestScene& s) { s.Property->SetFrameSourceToCurvature(); } } } },
  { "frame precision",
    { { "8 bits", [](TestScene&) {}, false },
      { "16 bits", [](TestScene& s) { s.Optics->SetFramePrecision(16); } },
      { "32 bits", [](TestScene& s) { s.Optics->SetFramePrecision(32); } } } },
  { "frame resolution",
    { { "full", [](TestScene&) {} },
      { "half", [](TestScene& s) { s.Optics->SetFrameResolutionFactor(0.5); }, false } } },
  { "extinction gradient",
    { { "stored", [](TestScene&) {} },
      { "central", [](TestScene& s) { s.Optics->SetExtinctionGradientToCentralDifferences(); } } } },
  { "scalar gradient",
    { { "automatic", [](TestScene&) {} },
      { "stored", [](TestScene& s) { s.Optics->SetScalarGradientToStored(); } },
      { "central", [](TestScene& s) { s.Optics->SetScalarGradientToCentralDifferences(); } } } },
  { "specular",
    { { "from extinction", [](TestScene&) {} },
      { "everywhere", [](TestScene& s) { s.Property->SpecularFromExtinctionOff(); } } } },
  { "integral",
    { { "VTK's", [](TestScene&) {} }, { "data, post", UseData },
      { "data, pre-integrated",
        [](TestScene& s) {
          UseData(s);
          s.Property->SetClassificationToPreIntegrated();
        } },
      { "pre-integrated", [](TestScene& s) { s.Property->SetClassificationToPreIntegrated(); } } } },
  { "silhouette",
    { { "off", [](TestScene&) {} }, { "exact", [](TestScene& s) { s.Property->SetSilhouetteToExact(); } },
      { "clamped", [](TestScene& s) { s.Property->SetSilhouetteToClamped(); } },
      { "gradient", [](TestScene& s) { s.Property->SetSilhouetteToGradient(); } } } },
  { "transmitted light",
    { { "off", [](TestScene&) {} },
      { "diffuse", [](TestScene& s) { s.Property->SetTransmittedLightToDiffuse(); } },
      { "with highlights", [](TestScene& s) { s.Property->SetTransmittedLightToDiffuseAndSpecular(); } } } },
  { "isosurfaces",
    { { "none", [](TestScene&) {} }, { "one", [](TestScene& s) { AddSurface(s, 0.5, 0.5); } },
      { "three",
        [](TestScene& s) {
          AddSurface(s, 0.55, 0.4);
          AddSurface(s, 0.7, 0.6);
          s.Property->AddIsosurface(0.2 * ScaleOf(s), 0.7);
        } } } },
  { "lighting function",
    { { "none", [](TestScene&) {} }, { "fetched", UseLighting },
      { "extrapolated",
        [](TestScene& s) {
          UseLighting(s);
          s.Optics->SetLightingSamplesToExtrapolated();
        },
        false },
      { "hybrid normals",
        [](TestScene& s) {
          UseLighting(s);
          s.Property->HybridNormalsOn();
        } } } },
  { "lighting knobs",
    { { "defaults", [](TestScene&) {} },
      { "scale and step",
        [](TestScene& s) {
          s.Property->SetLightScale(2.0);
          s.Property->SetGradientStepLength(2.0);
        } } } },
  { "tables",
    { { "32 bits", [](TestScene&) {} }, { "16 bits", [](TestScene& s) { s.Optics->SetTablePrecision(16); } },
      { "small",
        [](TestScene& s) {
          s.Optics->SetPreIntegrationTableSize(16);
          s.Optics->SetLightingTableSize(16);
        },
        false } } },
  { "several samples", { { "none", [](TestScene&) {} }, { "a rule", UseRule } } },
  { "ambient light",
    { { "white", [](TestScene&) {} },
      { "coloured", [](TestScene& s) { s.Property->SetAmbientColor(0.2, 0.5, 1.0); } },
      { "occlusion", [](TestScene& s) { UseOcclusion(s, 0, 8, 16); }, false },
      { "occlusion by 4", [](TestScene& s) { UseOcclusion(s, 0, 4, 8); }, false },
      { "occlusion by 16", [](TestScene& s) { UseOcclusion(s, 0, 16, 32); }, false },
      { "occlusion by a disk", [](TestScene& s) { UseOcclusion(s, 1, 8, 16); }, false },
      { "occlusion by a disk's angle", [](TestScene& s) { UseOcclusion(s, 2, 8, 32); }, false } } },
  { "gathering",
    { { "4 samples", [](TestScene&) {} },
      { "none", [](TestScene& s) { s.Optics->SetVisibilityGatherSamples(0); }, false },
      { "8 samples", [](TestScene& s) { s.Optics->SetVisibilityGatherSamples(8); }, false } } },
  { "disk",
    { { "defaults", [](TestScene&) {} },
      { "small, approximated",
        [](TestScene& s) {
          s.Optics->SetVisibilityDiskSize(1);
          s.Optics->VisibilityTrueDistancesOff();
        },
        false } } },
  { "shadows",
    { { "off", [](TestScene&) {} }, { "hard", [](TestScene& s) { s.Property->ShadowsOn(); }, false },
      { "soft",
        [](TestScene& s) {
          s.Property->ShadowsOn();
          s.Property->SetShadowAngle(10.0);
        },
        false } } },
  { "lights",
    { { "headlight", [](TestScene&) {} }, { "suns", AddSuns }, { "lamp", AddLamp },
      { "none", [](TestScene& s) { s.Renderer->SetAutomaticLightCreation(false); } } } },
  { "sides",
    { { "two", [](TestScene&) {} }, { "one", [](TestScene& s) { s.Renderer->TwoSidedLightingOff(); } } } },
  { "phase function",
    { { "isotropic", [](TestScene&) {} },
      { "forward", [](TestScene& s) { s.Property->SetScatteringAnisotropy(0.5F); } } } },
  { "opacity",
    { { "by scalar", [](TestScene&) {} }, { "by gradient, too", RowNamed("gradient opacity"), false },
      { "2D", Use2DFunction, false } } },
  { "cropping",
    { { "off", [](TestScene&) {} },
      { "to a box", [](TestScene& s) { CropTo(s, VTK_CROP_SUBVOLUME); }, false },
      { "to a cross", [](TestScene& s) { CropTo(s, VTK_CROP_INVERTED_CROSS); }, false } } },
  { "clipping",
    { { "off", [](TestScene&) {} }, { "by a plane", RowNamed("clipping planes"), false },
      { "by three planes", ClipByThree, false } } },
  { "clipped voxels",
    { { "as they are", [](TestScene&) {} },
      { "of one value",
        [](TestScene& s) {
          s.Property->UseClippedVoxelIntensityOn();
          s.Property->SetClippedVoxelIntensity(0.3 * ScaleOf(s));
        },
        false } } },
  { "mask",
    { { "none", [](TestScene&) {} }, { "binary", RowNamed("binary mask"), false },
      { "labels", RowNamed("label map"), false } } },
  { "camera",
    { { "perspective", [](TestScene&) {} }, { "parallel", RowNamed("parallel projection") },
      { "inside", RowNamed("camera inside") }, { "stereo", RowNamed("stereo"), false } } },
  { "matrix",
    { { "none", [](TestScene&) {} }, { "turned", Turn }, { "uneven", RowNamed("user matrix"), false },
      { "mirrored", Mirror, false } } },
  { "blocks", { { "one", [](TestScene&) {} }, { "four", RowNamed("partitions"), false } } },
  { "piece", { { "the whole", [](TestScene&) {} }, { "a part", DrawPiece, false } } },
  { "values",
    { { "linear", [](TestScene&) {} },
      { "nearest", [](TestScene& s) { s.Property->SetInterpolationTypeToNearest(); }, false } } },
  { "jitter", { { "off", [](TestScene&) {} }, { "on", RowNamed("jitter"), false } } },
  { "empty space",
    { { "marched through", [](TestScene&) {} },
      { "skipped",
        [](TestScene& s) {
          s.Optics->SkipEmptySpaceOn();
          s.Optics->SetMacrocellSize(2);
        } } } },
  { "geometry",
    { { "none", [](TestScene&) {} }, { "opaque", RowNamed("opaque geometry"), false },
      { "peeled", PeelDepth, false },
      { "translucent", [](TestScene& s) { AddCone(s)->GetProperty()->SetOpacity(0.4); }, false } } },
  { "drawing",
    { { "plain", [](TestScene&) {} }, { "image sample distance", RowNamed("image sample distance"), false },
      { "depth pass", RowNamed("depth pass"), false }, { "level of detail", UseLevelOfDetail, false },
      { "colour window", RowNamed("final colour window"), false },
      { "shader property", RowNamed("shader property"), false } } },
};
}

#endif
