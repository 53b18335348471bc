// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Cells that a gradient opacity or the rows of a 2D transfer function hide are skipped, and no byte changes: every
// scalar can be seen, and large gradients alone are. Arguments: --2d (functions of two dimensions), --rows-0 to --rows-2
// (those of docs/support.md), --models.

#include "GradientScene.h"

namespace
{
// Each of the types with another field and shape; one in cells of 2^3 voxels.
void TestFields(Check& check)
{
  const std::vector<int> sizes[] = { { 32, 32, 32 }, { 40, 23, 19 }, { 17, 30, 33 } };
  int kind = 0;
  for (const GradientField& field : Fields)
  {
    for (const int type : Types)
    {
      const std::vector<int>& size = sizes[kind % 3];
      const double depth = kind % 2 == 0 ? 1.0 : 0.4;
      const vtkSmartPointer<vtkImageData> image = MakeImage(field, type, size, depth);
      const std::string name = std::string(field.Name) + " of " + vtkImageScalarTypeNameMacro(type);
      const auto apply = [&](TestScene& scene) {
        UseImage(scene, image);
        HideGradientsBelow(scene, FindMagnitude(image, HiddenPart));
        scene.Optics->SetMacrocellSize(2);
      };
      CompareWithVTK(check, name, apply);
      CheckSeen(check, name, apply);
      ++kind;
    }
  }
}

// Enlarged by VTK with overshoot, taken as they are, enlarged on one axis, and one that has a single row.
void TestFunctions2D(Check& check)
{
  const std::vector<int> sizes[] = { { 256, 256 }, { 1024, 1024 }, { 64, 2048 }, { 300, 33 }, { 64, 1 } };
  int kind = 0;
  for (const std::vector<int>& size : sizes)
  {
    for (const GradientField& field : Fields)
    {
      const int type = Types[kind++ % std::size(Types)];
      const vtkSmartPointer<vtkImageData> image = MakeImage(field, type, { 32, 20, 32 });
      const std::string name = std::string(field.Name) + " by " + std::to_string(size[0]) + " x " +
        std::to_string(size[1]) + " texels";
      const auto apply = [&](TestScene& scene) {
        UseImage(scene, image);
        Use2D(scene, size[0], size[1], size[1] > 1 ? FindMagnitude(image, HiddenPart) + 1.0 / size[1] : 0.0);
        scene.Optics->SetMacrocellSize(2);
      };
      CompareWithVTK(check, name, apply, size[1] > 1);
      CheckSeen(check, name, apply);
    }
  }
}

// One texel of a small function: VTK's resizing rings on both sides of its column.
void TestNarrowFunction(Check& check)
{
  const GradientField ramp = { "ramp", [](const double place[3]) { return 0.5 + 0.5 * place[0]; } };
  const vtkSmartPointer<vtkImageData> image = MakeImage(ramp, VTK_FLOAT, { 64, 16, 16 });
  const int row = static_cast<int>(64.0 * FindMagnitude(image, 0.5));
  for (const int rows : { 64, 1 })
  {
    const auto apply = [&](TestScene& scene) {
      UseImage(scene, image);
      scene.Optics->SetMacrocellSize(2);
      vtkNew<vtkImageData> function;
      function->SetDimensions(64, rows, 1);
      function->AllocateScalars(VTK_FLOAT, 4);
      for (int texel = 0; texel < 64 * rows; ++texel)
      {
        const int x = texel % 64, y = texel / 64;
        const bool isSeen = x == 24 && (y == row || rows == 1);
        const float color[4] = { 0.9F, 0.5F, 0.3F, isSeen ? 50.0F : 0.0F };
        std::copy(color, color + 4, static_cast<float*>(function->GetScalarPointer(x, y, 0)));
      }
      scene.Property->SetTransferFunctionMode(vtkVolumeProperty::TF_2D);
      scene.Property->SetTransferFunction2D(function);
    };
    CompareWithVTK(check, "one column of " + std::to_string(rows) + " rows", apply);
    CheckSeen(check, "one column of " + std::to_string(rows) + " rows", apply);
  }
}

// Few codes of 8 bits, between which a texture may interpolate in whole codes: larger gradients than any voxel's.
void TestFewCodes(Check& check)
{
  const GradientField waves = { "waves", [](const double place[3]) {
                                 const double wave = std::sin(5.0 * place[0]) * std::sin(4.0 * place[1]) *
                                   std::sin(7.0 * place[2]);
                                 return place[0] > 0.3 ? 0.04 + 0.04 * wave : 0.04;
                               } };
  const vtkSmartPointer<vtkImageData> image = MakeImage(waves, VTK_UNSIGNED_CHAR, { 40, 33, 36 });
  const auto apply = [&](TestScene& scene) {
    UseImage(scene, image);
    HideGradientsBelow(scene, FindMagnitude(image, 0.99));
    scene.Optics->SetMacrocellSize(2);
  };
  CompareWithVTK(check, "few codes", apply);
  CheckSeen(check, "few codes", apply);
}

// Six voxels on an axis: VTK looks 1.2 of them to both sides, and finds a fifth more than their difference.
void TestFewVoxels(Check& check)
{
  const GradientField ramp = { "ramp",
    [](const double place[3]) { return place[1] > 0.2 ? 0.5 + 0.3 * place[0] : 0.5; } };
  const vtkSmartPointer<vtkImageData> image = MakeImage(ramp, VTK_FLOAT, { 6, 32, 32 });
  const double* spacing = image->GetSpacing();
  const double mean = (spacing[0] + spacing[1] + spacing[2]) / 3.0;
  CompareWithVTK(check, "few voxels", [&](TestScene& scene) {
    UseImage(scene, image);
    // a half difference of 0.3 times the spacing, over a quarter of the range of 0.6
    HideGradientsBelow(scene, 1.1 * 0.3 * mean / (0.25 * 0.6));
  });
}

// What a row makes of the ellipsoid, whose inside and outside are hidden.
void UseRow(TestScene& scene, const Row& row)
{
  row.Apply(scene);
  HideGradientsBelow(scene, 0.3);
}

void TestRows(Check& check, std::size_t third)
{
  const std::set<std::string> several = { "luminance and opacity", "colour and opacity" };
  for (std::size_t i = third; i < std::size(Rows); i += 3)
  {
    const Row& row = Rows[i];
    const bool isServed = IsSkippedIn(row) && several.count(row.Name) == 0;
    CompareWithVTK(
      check, row.Name, [&](TestScene& scene) { UseRow(scene, row); }, isServed);
  }
}

// Models whose own gradients are those of the extinction; what isn't seen is not lit.
void TestModels(Check& check)
{
  using Property = vtkOpticsVolumeProperty;
  const vtkSmartPointer<vtkImageData> image = MakeImage(Fields[0], VTK_FLOAT, { 30, 32, 28 }, 0.7);
  const auto use1D = [&](TestScene& scene) {
    UseImage(scene, image);
    HideGradientsBelow(scene, FindMagnitude(image, HiddenPart));
  };
  const auto use2D = [&](TestScene& scene) {
    UseImage(scene, image);
    Use2D(scene, 256, 256, FindMagnitude(image, HiddenPart));
  };
  for (const int model : { Property::BlinnPhong, Property::Ward })
  {
    const auto useModel = [=](TestScene& scene) {
      scene.Property->SetReflectanceModel(model);
      scene.Property->SetSpecular(0.7);
    };
    const std::string name = ", model " + std::to_string(model);
    CompareWithout(check, "1D" + name, [&](TestScene& scene) { use1D(scene), useModel(scene); });
    CompareWithout(check, "2D" + name, [&](TestScene& scene) { use2D(scene), useModel(scene); });
  }
  CompareInFloat(check, "Ward", [&](TestScene& scene) {
    use1D(scene);
    UseWard(scene);
  });
  CompareInFloat(check, "occlusion and shadows", [&](TestScene& scene) {
    use1D(scene);
    scene.Property->OcclusionOn();
    scene.Property->ShadowsOn();
  });
}

void TestRowsOfWard(Check& check)
{
  const std::set<std::string> rows = { "cropping", "clipping planes", "blanked points", "cell data",
    "direction matrix" };
  for (const Row& row : Rows)
  {
    if (rows.count(row.Name) != 0)
    {
      CompareWithout(check, std::string(row.Name) + ", Ward", [&](TestScene& scene) {
        UseRow(scene, row);
        UseWard(scene);
      });
    }
  }
}

// Where the largest magnitude among voxels tells nothing, cells are those of the scalars alone, of which all are seen.
void TestLeftOut(Check& check)
{
  const auto compare = [&](const std::string& name, const Setting& change) {
    CompareWithVTK(
      check, name,
      [&](TestScene& scene) {
        HideGradientsBelow(scene, 0.3);
        change(scene);
      },
      false);
  };
  compare("nearest neighbour", [](TestScene& scene) { scene.Property->SetInterpolationTypeToNearest(); });
  compare(
    "clipped voxels have a value", [](TestScene& scene) { scene.Property->UseClippedVoxelIntensityOn(); });
  compare("gradient opacity disabled", [](TestScene& scene) { scene.Property->DisableGradientOpacityOn(); });
  // which VTK gives two points when it draws
  CompareWithVTK(check, "an empty function", [](TestScene& scene) {
    HideGradientsBelow(scene, 0.3);
    scene.Property->GetGradientOpacity()->RemoveAllPoints();
  });
  compare("all gradients are seen",
    [](TestScene& scene) { scene.Property->GetGradientOpacity()->AddPoint(0.0, 0.01); });
}

// Voxels that are no numbers, and numbers of few digits.
void TestOddities(Check& check)
{
  const auto compare = [&](const std::string& name, const std::function<double(vtkIdType, double)>& change) {
    const vtkSmartPointer<vtkImageData> image = MakeImage(Fields[0], VTK_FLOAT, { 32, 32, 32 });
    vtkDataArray* values = image->GetPointData()->GetScalars();
    const double magnitude = FindMagnitude(image, HiddenPart);
    for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
    {
      values->SetComponent(i, 0, change(i, values->GetComponent(i, 0)));
    }
    values->Modified(); // and with it the range
    CompareWithVTK(check, name, [&](TestScene& scene) {
      UseImage(scene, image);
      HideGradientsBelow(scene, magnitude);
    });
  };
  const double oddities[] = { std::nan(""), std::numeric_limits<double>::infinity() };
  for (const double odd : oddities)
  {
    compare(std::to_string(odd), [=](vtkIdType i, double value) { return i % 4999 == 0 ? odd : value; });
  }
  compare("an offset", [](vtkIdType, double value) { return 1.0e4 + value; });
  compare("small numbers", [](vtkIdType, double value) { return 1.0e-10 * value; });
  compare("large numbers", [](vtkIdType, double value) { return 1.0e10 * value; });
}
}

int TestEmptySpaceGradients(int argc, char* argv[])
{
  Check check;
  const auto has = [&](const char* argument) {
    return std::any_of(argv, argv + argc, [&](char* word) { return std::string(word) == argument; });
  };
  if (has("--2d"))
  {
    TestFunctions2D(check);
    TestNarrowFunction(check);
  }
  else if (has("--rows-0") || has("--rows-1") || has("--rows-2"))
  {
    TestRows(check, has("--rows-0") ? 0 : has("--rows-1") ? 1 : 2);
  }
  else if (has("--models"))
  {
    TestModels(check);
  }
  else if (has("--ward"))
  {
    TestRowsOfWard(check);
  }
  else
  {
    TestFields(check);
    TestFewCodes(check);
    TestFewVoxels(check);
    TestLeftOut(check);
    TestOddities(check);
  }
  return check.ExitCode();
}
