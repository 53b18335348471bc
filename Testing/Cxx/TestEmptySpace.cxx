// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Skipping empty space changes no byte: for each row of docs/support.md, and for more scenes, the picture with it is
// VTK's own, and with an optical model that without it. Where a scene is not supported, nothing is added. Arguments:
// --scenes (scalar types, functions, steps), --models, --sweeps, --ward-0 to --ward-2,
// --integral and --integral-scenes (data space, pre-integration).

#include "SkippingScene.h"

namespace
{
void TestRows(Check& check)
{
  for (const Row& row : Rows)
  {
    CompareWithVTK(check, row.Name, row.Apply, IsSkippedIn(row));
  }
}

// The ellipsoid as another type, in [0, 100].
void UseType(TestScene& scene, int type, double offset)
{
  vtkSmartPointer<vtkImageData> image = Field(scene);
  vtkDataArray* source = image->GetPointData()->GetScalars();
  auto values = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  values->SetNumberOfTuples(source->GetNumberOfTuples());
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    values->SetComponent(i, 0, offset + std::floor(100.0 * std::clamp(source->GetComponent(i, 0), 0.0, 1.0)));
  }
  image->GetPointData()->SetScalars(values);
  scene.Mapper->SetInputData(image);
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(offset + 40.0, 0.0);
  scene.Opacity->AddPoint(offset + 60.0, 0.9);
}

void TestTypes(Check& check)
{
  for (const int type : { VTK_UNSIGNED_CHAR, VTK_SIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT, VTK_INT,
         VTK_UNSIGNED_INT, VTK_LONG, VTK_FLOAT, VTK_DOUBLE })
  {
    const double offset = type == VTK_SIGNED_CHAR ? -90.0 : type == VTK_SHORT ? -1000.0 : 10.0;
    CompareWithVTK(
      check, vtkImageScalarTypeNameMacro(type), [&](TestScene& scene) { UseType(scene, type, offset); });
  }
  // large numbers of few digits in a float
  CompareWithVTK(check, "an offset", [](TestScene& scene) { UseType(scene, VTK_FLOAT, 1.0e6); });
}

// Every 50th voxel is one of these.
void UseOddities(TestScene& scene, const std::vector<float>& oddities)
{
  UseType(scene, VTK_FLOAT, 0.0);
  auto* image = vtkImageData::SafeDownCast(scene.Mapper->GetDataSetInput());
  vtkDataArray* values = image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); i += 997)
  {
    values->SetComponent(i, 0, oddities[i % oddities.size()]);
  }
  values->Modified();
}

void SetOpacities(TestScene& scene, const std::vector<std::pair<double, double>>& nodes)
{
  scene.Opacity->RemoveAllPoints();
  for (const auto& [scalar, opacity] : nodes)
  {
    scene.Opacity->AddPoint(scalar, opacity);
  }
}

const Row MoreScenes[] = {
  { "NaN", [](TestScene& scene) { UseOddities(scene, { std::numeric_limits<float>::quiet_NaN() }); } },
  { "NaN that may be seen",
    [](TestScene& scene) {
      UseOddities(scene, { std::numeric_limits<float>::quiet_NaN() });
      SetOpacities(scene, { { 0.0, 0.5 }, { 10.0, 0.0 }, { 90.0, 0.0 }, { 100.0, 0.5 } });
    } },
  { "infinite",
    [](TestScene& scene) {
      const float infinite = std::numeric_limits<float>::infinity();
      UseOddities(scene, { infinite, -infinite, 50.0F });
    } },
  { "thin shell",
    [](TestScene& scene) {
      SetOpacities(scene, { { 0.5, 0.0 }, { 0.501, 0.9 }, { 0.502, 0.0 } });
    } },
  { "two shells",
    [](TestScene& scene) {
      SetOpacities(scene, { { 0.3, 0.0 }, { 0.31, 0.3 }, { 0.32, 0.0 }, { 0.85, 0.0 }, { 0.86, 0.9 } });
    } },
  { "steps without clamping",
    [](TestScene& scene) {
      SetOpacities(scene, { { 0.4, 0.0 }, { 0.4, 0.5 }, { 0.6, 0.5 } });
      scene.Opacity->ClampingOff();
    } },
  { "native range",
    [](TestScene& scene) { scene.Mapper->SetScalarOpacityRangeType(vtkGPUVolumeRayCastMapper::NATIVE); } },
  { "long steps", [](TestScene& scene) { scene.Mapper->SetSampleDistance(0.4F); } },
  { "thin and clear shell, steps of two voxels",
    [](TestScene& scene) {
      SetOpacities(scene, { { 0.5, 0.0 }, { 0.501, 0.005 }, { 0.502, 0.0 } });
      scene.Mapper->SetSampleDistance(0.13F);
    } },
  { "thin and clear shell, steps longer than a cell",
    [](TestScene& scene) {
      SetOpacities(scene, { { 0.5, 0.0 }, { 0.501, 0.9 }, { 0.502, 0.0 } });
      scene.Mapper->SetSampleDistance(0.6F);
    } },
  { "short steps", [](TestScene& scene) { scene.Mapper->SetSampleDistance(0.003F); } },
  { "nearest neighbour", [](TestScene& scene) { scene.Property->SetInterpolationTypeToNearest(); } },
  { "not shaded", [](TestScene& scene) { scene.Property->ShadeOff(); } },
  { "a plain property",
    [](TestScene& scene) {
      vtkNew<vtkVolumeProperty> plain;
      plain->DeepCopy(scene.Property);
      scene.Volume->SetProperty(plain);
    } },
  { "along an axis",
    [](TestScene& scene) {
      scene.Renderer->GetActiveCamera()->SetPosition(0.0, -3.0, 0.0);
      scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
      scene.Renderer->GetActiveCamera()->SetParallelScale(1.0);
      scene.Renderer->ResetCameraClippingRange();
    } },
};

void TestMoreScenes(Check& check)
{
  for (const Row& row : MoreScenes)
  {
    CompareWithVTK(check, row.Name, row.Apply, std::string(row.Name) != "native range");
  }
}

void TestModels(Check& check)
{
  using Property = vtkOpticsVolumeProperty;
  for (const int model : { Property::None, Property::BlinnPhong, Property::Ward, Property::Lafortune })
  {
    CompareWithout(check, "model " + std::to_string(model),
      [&](TestScene& scene) { scene.Property->SetReflectanceModel(model); });
  }
  CompareWithout(check, "lighting table", [](TestScene& scene) { LightEverywhere(scene, 0.2, 0.6, 0.3); });
  CompareInFloat(check, "Ward", UseWard);
}

// A third of the rows: most of the time is that of linking each one's two programs.
void TestRowsOfWard(Check& check, std::size_t third)
{
  for (std::size_t i = third; i < std::size(Rows); i += 3)
  {
    const Row& row = Rows[i];
    const bool isServed = IsSkippedIn(row);
    CompareWithout(
      check, std::string(row.Name) + ", Ward",
      [&](TestScene& scene) {
        row.Apply(scene);
        UseWard(scene);
      },
      isServed);
  }
}

// Several settings of the integral share the rows among them.
void UseIntegral(TestScene& scene, std::size_t kind)
{
  vtkOpticsVolumeProperty* property = scene.Property;
  property->SetIntegrationSpace(
    kind % 3 == 0 ? vtkOpticsVolumeProperty::Physical : vtkOpticsVolumeProperty::Data);
  property->SetClassification(
    kind % 3 == 1 ? vtkOpticsVolumeProperty::Post : vtkOpticsVolumeProperty::PreIntegrated);
  property->AddIsosurface(0.45, 0.8, 0.2, 0.1, 0.4);
  property->SetSilhouette(static_cast<int>(kind % 4));
  property->SetTransmittedLight(static_cast<int>(kind % 2));
  if (kind % 5 == 0)
  {
    UseWard(scene);
  }
}

void CompareIntegral(Check& check, const Row& row, std::size_t kind, bool isServed)
{
  CompareWithout(
    check, std::string(row.Name) + ", integral " + std::to_string(kind),
    [&](TestScene& scene) {
      row.Apply(scene);
      UseIntegral(scene, kind);
    },
    isServed);
}

void TestIntegralInRows(Check& check)
{
  std::size_t kind = 0;
  for (const Row& row : Rows)
  {
    const std::string name = row.Name;
    if (name != "label map" && name != "2D transfer function") // which have VTK's integral
    {
      CompareIntegral(check, row, kind, IsSkippedIn(row));
    }
    ++kind;
  }
}

void TestIntegralInScenes(Check& check)
{
  std::size_t kind = 0;
  for (const Row& row : MoreScenes)
  {
    const std::string name = row.Name;
    if (name != "a plain property") // which has no integral
    {
      CompareIntegral(check, row, kind, name != "native range");
    }
    ++kind;
  }
  for (kind = 0; kind < 3; ++kind)
  {
    CompareInFloat(
      check, "integral " + std::to_string(kind), [&](TestScene& scene) { UseIntegral(scene, kind); });
  }
}

// What a sweep finds does not depend on what rays skip: a sweep has no ray.
void TestSweeps(Check& check)
{
  for (std::size_t kind = 0; kind < 3; ++kind)
  {
    CompareInFloat(check, "occlusion, integral " + std::to_string(kind), [&](TestScene& scene) {
      UseIntegral(scene, kind);
      scene.Property->OcclusionOn();
    });
  }
  CompareInFloat(check, "occlusion", [](TestScene& scene) { scene.Property->OcclusionOn(); });
  CompareInFloat(check, "shadows", [](TestScene& scene) { scene.Property->ShadowsOn(); });
}

// Blocks of one scalar each, the opacity all around: only what lies between blocks is seen in data space.
void TestConstantCells(Check& check)
{
  CompareWithout(check, "constant blocks", [](TestScene& scene) {
    UseType(scene, VTK_UNSIGNED_CHAR, 0.0);
    auto* image = vtkImageData::SafeDownCast(scene.Mapper->GetDataSetInput());
    for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
    {
      const bool isInside = image->GetPoint(i)[0] > 0.3;
      image->GetPointData()->GetScalars()->SetComponent(i, 0, isInside ? 90.0 : 20.0);
    }
    SetOpacities(scene, { { 0.0, 0.5 }, { 100.0, 0.9 } });
    scene.Property->SetIntegrationSpaceToData();
    scene.Property->AddIsosurface(50.0, 0.8, 0.2, 0.1, 0.4);
  });
}
// Steps from air over a slab's front to its inside and out again: nothing is seen at any sample, in cells of one scalar,
// and both faces are seen between them. Only steps up to the size of a cell may be skipped by their ends.
void UseStepsOverSlab(TestScene& scene)
{
  UseType(scene, VTK_UNSIGNED_CHAR, 0.0);
  auto* image = vtkImageData::SafeDownCast(scene.Mapper->GetDataSetInput());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const vtkIdType y = i / 32 % 32;
    image->GetPointData()->GetScalars()->SetComponent(i, 0, y >= 8 && y < 16 ? 90.0 : 20.0);
  }
  scene.Optics->SetMacrocellSize(2);
  scene.Mapper->SetSampleDistance(static_cast<float>(12.0 * image->GetSpacing()[1])); // voxels 0, 12, 24
  SetOpacities(scene, { { 40.0, 0.0 }, { 50.0, 0.9 }, { 60.0, 0.0 } });
  scene.Property->SetIntegrationSpaceToData();
  scene.Property->SetClassificationToPreIntegrated(); // of the scalars between two samples
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(0.0, -3.0, 0.0);
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.7); // the front face alone
  scene.Renderer->ResetCameraClippingRange();
}

void TestStepsOverSlab(Check& check)
{
  SkippingScene air;
  air.Optics->SkipEmptySpaceOff();
  UseStepsOverSlab(air);
  const std::vector<unsigned char> seen = air.Render();
  SetOpacities(air, { { 0.0, 0.0 } });
  check.AtLeast("difference that the slab makes", LargestDifference(seen, air.Render()), 20);
  CompareWithout(check, "steps over a slab", UseStepsOverSlab);
}
}

int TestEmptySpace(int argc, char* argv[])
{
  Check check;
  const auto has = [&](const char* argument) {
    return std::any_of(argv, argv + argc, [&](char* word) { return std::string(word) == argument; });
  };
  if (has("--scenes"))
  {
    TestTypes(check);
    TestMoreScenes(check);
  }
  else if (has("--models"))
  {
    TestModels(check);
  }
  else if (has("--sweeps"))
  {
    TestSweeps(check);
  }
  else if (has("--ward-0") || has("--ward-1") || has("--ward-2"))
  {
    TestRowsOfWard(check, has("--ward-0") ? 0 : has("--ward-1") ? 1 : 2);
  }
  else if (has("--integral"))
  {
    TestIntegralInRows(check);
  }
  else if (has("--integral-scenes"))
  {
    TestIntegralInScenes(check);
    TestConstantCells(check);
    TestStepsOverSlab(check);
  }
  else
  {
    TestRows(check);
  }
  return check.ExitCode();
}
