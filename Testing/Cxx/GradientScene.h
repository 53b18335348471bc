// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Fields whose small gradients are hidden, though every scalar can be seen: by a gradient opacity, or by the rows of a
// 2D transfer function.

#ifndef GradientScene_h
#define GradientScene_h

#include "SkippingScene.h"

#include "vtkPointData.h"

#include <random>

namespace
{
using FieldFunction = std::function<double(const double[3])>; // in [0, 1], of a place in [-1, 1]

struct GradientField
{
  const char* Name;
  FieldFunction At;
};

inline double Noise(double amplitude)
{
  static std::mt19937 random(5);
  return amplitude * (random() / 4294967296.0 - 0.5);
}

// Gradients that grow from voxel to voxel in a corner, with noise, between homogeneous blocks, and at the border alone.
const GradientField Fields[] = {
  { "corner",
    [](
      const double place[3]) { return std::pow(std::max(place[0] - place[1] + place[2], 0.0) / 3.0, 2.0); } },
  { "noise", [](const double place[3]) { return 0.5 + Noise(std::max(0.9 * (place[0] - 0.3), 0.0)); } },
  { "blocks",
    [](const double place[3]) {
      return place[0] > 0.4 ? 0.2 : place[1] > 0.4 && place[2] > 0.0 ? 0.8 : 0.5;
    } },
  { "border", [](const double place[3]) { return std::max(place[2] - 0.5, 0.0) + 0.3 + Noise(0.01); } },
};

// Codes fill a part of their type.
inline vtkSmartPointer<vtkImageData> MakeImage(
  const GradientField& field, int type, const std::vector<int>& size, double depth = 1.0)
{
  const bool isByte = type == VTK_UNSIGNED_CHAR || type == VTK_SIGNED_CHAR;
  const double scale = isByte ? 120.0 : type == VTK_FLOAT ? 1.0 : 20000.0;
  const double offset = type == VTK_SIGNED_CHAR ? -60.0 : type == VTK_SHORT ? -9000.0 : 0.0;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size[0], size[1], size[2]);
  image->SetSpacing(2.0 / (size[0] - 1), 2.0 / (size[1] - 1), depth * 2.0 / (size[2] - 1));
  image->SetOrigin(-1.0, -1.0, -depth);
  image->AllocateScalars(type, 1);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double place[3];
    image->GetPoint(i, place);
    place[2] /= depth;
    image->GetPointData()->GetScalars()->SetComponent(i, 0, offset + scale * field.At(place));
  }
  return image;
}

inline void FindRange(TestScene& scene, double range[2])
{
  scene.Mapper->GetInputAlgorithm()->Update();
  vtkDataSet* data = scene.Mapper->GetDataSetInput();
  vtkDataArray* ofPoints = data->GetPointData()->GetScalars();
  (ofPoints ? ofPoints : data->GetCellData()->GetScalars())->GetFiniteRange(range);
}

inline void ShowEveryScalar(TestScene& scene)
{
  double range[2];
  FindRange(scene, range);
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(range[0], 0.1);
  scene.Opacity->AddPoint(range[1], 0.2);
  scene.Color->RemoveAllPoints();
  scene.Color->AddRGBPoint(range[0], 0.2, 0.3, 0.8);
  scene.Color->AddRGBPoint(range[1], 0.9, 0.7, 0.5);
}

// Nothing below a magnitude in [0, 1], all from a little above it on.
inline void HideGradientsBelow(TestScene& scene, double magnitude)
{
  double range[2];
  FindRange(scene, range);
  const double one = 0.25 * (range[1] - range[0]);
  vtkNew<vtkPiecewiseFunction> function;
  function->AddPoint(0.0, 0.0);
  function->AddPoint(magnitude * one, 0.0);
  function->AddPoint((magnitude + 0.004) * one, 1.0);
  scene.Property->SetGradientOpacity(function);
  ShowEveryScalar(scene);
}

inline void UseImage(TestScene& scene, vtkImageData* image)
{
  scene.Mapper->SetInputData(image);
  scene.Renderer->ResetCamera();
  ShowEveryScalar(scene);
}

// The magnitude below which this part of the voxels is; VTK's measure, but for the fraction that it looks beyond a voxel.
inline double FindMagnitude(vtkImageData* image, double part)
{
  double range[2];
  image->GetScalarRange(range);
  const int* size = image->GetDimensions();
  const double* spacing = image->GetSpacing();
  const double mean = (spacing[0] + spacing[1] + spacing[2]) / 3.0;
  std::vector<double> magnitudes;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const int voxel[3] = { static_cast<int>(i % size[0]), static_cast<int>(i / size[0] % size[1]),
      static_cast<int>(i / size[0] / size[1]) };
    double square = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      int front[3] = { voxel[0], voxel[1], voxel[2] }, back[3] = { voxel[0], voxel[1], voxel[2] };
      front[axis] = std::min(voxel[axis] + 1, size[axis] - 1);
      back[axis] = std::max(voxel[axis] - 1, 0);
      const double difference = image->GetScalarComponentAsDouble(front[0], front[1], front[2], 0) -
        image->GetScalarComponentAsDouble(back[0], back[1], back[2], 0);
      square += std::pow(difference * mean / (2.0 * spacing[axis]), 2.0);
    }
    magnitudes.push_back(std::sqrt(square) / (0.25 * (range[1] - range[0])));
  }
  const auto wanted = magnitudes.begin() + static_cast<std::ptrdiff_t>(part * magnitudes.size());
  std::nth_element(magnitudes.begin(), wanted, magnitudes.end());
  return std::min(*wanted, 0.85);
}

// Nothing is compared but the background where all is hidden.
inline void CheckSeen(Check& check, const std::string& name, const Setting& apply)
{
  SkippingScene scene;
  apply(scene);
  const std::vector<unsigned char> seen = scene.Render();
  scene.Volume->VisibilityOff();
  check.AtLeast(name + ": what is seen", LargestDifference(seen, scene.Render()), 20);
}

const double HiddenPart = 0.9; // of the voxels

const int Types[] = { VTK_UNSIGNED_CHAR, VTK_SIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT, VTK_FLOAT };

// Rows from the first on are seen, of the columns in the middle; a small function is one that VTK enlarges.
inline void Use2D(TestScene& scene, int columns, int rows, double magnitude)
{
  vtkNew<vtkImageData> function;
  function->SetDimensions(columns, rows, 1);
  function->AllocateScalars(VTK_FLOAT, 4);
  for (int texel = 0; texel < columns * rows; ++texel)
  {
    const int x = texel % columns, y = texel / columns;
    const bool isSeen = y >= magnitude * rows && (x > columns / 8 || rows == 1);
    const float color[4] = { 0.9F, x * 1.0F / columns, 0.3F, isSeen ? 0.2F : 0.0F };
    std::copy(color, color + 4, static_cast<float*>(function->GetScalarPointer(x, y, 0)));
  }
  scene.Property->SetTransferFunctionMode(vtkVolumeProperty::TF_2D);
  scene.Property->SetTransferFunction2D(function);
}
}

#endif
