// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LineVoxels.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnsignedShortArray.h"

#include <algorithm>
#include <cmath>

namespace volumeoptics
{
namespace
{
// Far above what memory holds; sums and products of it are no overflow.
constexpr vtkTypeInt64 MostEntries = vtkTypeInt64(1) << 56;

std::string NameOf(int type, const char* part)
{
  return "LineType" + std::to_string(type) + "_" + part;
}

// Values of an array of this type, at least `least` of them; otherwise nullptr.
template <class Value>
const Value* Pointer(vtkImageData* image, const std::string& name, int type, vtkIdType least)
{
  vtkDataArray* array = image->GetFieldData()->GetArray(name.c_str());
  const bool isRight = array && array->GetDataType() == type && array->GetNumberOfValues() >= least;
  return isRight ? static_cast<const Value*>(array->GetVoidPointer(0)) : nullptr;
}

template <class Array>
Array* AddArray(vtkImageData* image, const std::string& name, vtkIdType tuples, int components = 1)
{
  vtkNew<Array> array;
  array->SetName(name.c_str());
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  image->GetFieldData()->AddArray(array);
  return array;
}

void AddIntegers(vtkImageData* image, const char* name, const std::vector<int>& values)
{
  std::copy(values.begin(), values.end(), AddArray<vtkIntArray>(image, name, values.size())->GetPointer(0));
}

void WriteType(const LineTypeBricks& bricks, vtkImageData* image)
{
  std::size_t voxels = 0, coefficients = 0;
  for (const LineBrick& brick : bricks.Bricks)
  {
    voxels += brick.Places.size();
    coefficients += brick.Harmonics.size();
  }
  const int type = bricks.Type;
  auto* brickStart =
    AddArray<vtkTypeInt64Array>(image, NameOf(type, "BrickStarts"), bricks.Bricks.size() + 1)->GetPointer(0);
  auto* voxelStart =
    AddArray<vtkTypeInt64Array>(image, NameOf(type, "VoxelStarts"), voxels + 1)->GetPointer(0);
  auto* place = AddArray<vtkUnsignedShortArray>(image, NameOf(type, "Places"), voxels)->GetPointer(0);
  auto* harmonic =
    AddArray<vtkUnsignedCharArray>(image, NameOf(type, "Harmonics"), coefficients)->GetPointer(0);
  auto* value =
    AddArray<vtkFloatArray>(image, NameOf(type, "Coefficients"), coefficients, LineChannels)->GetPointer(0);
  *brickStart = 0;
  *voxelStart = 0;
  for (const LineBrick& brick : bricks.Bricks)
  {
    brickStart[1] = brickStart[0] + static_cast<vtkTypeInt64>(brick.Places.size());
    ++brickStart;
    for (int count : brick.Counts)
    {
      voxelStart[1] = voxelStart[0] + count;
      ++voxelStart;
    }
    place = std::copy(brick.Places.begin(), brick.Places.end(), place);
    harmonic = std::copy(brick.Harmonics.begin(), brick.Harmonics.end(), harmonic);
    value = std::copy(brick.Values.begin(), brick.Values.end(), value);
  }
  auto* range = AddArray<vtkDoubleArray>(image, NameOf(type, "ColorRange"), 6)->GetPointer(0);
  std::copy(bricks.ColorRange.begin(), bricks.ColorRange.end(), range);
}

// Begins of runs, and their end: from 0, ascending.
bool AreStarts(const vtkTypeInt64* starts, vtkIdType count)
{
  return starts[0] == 0 && std::is_sorted(starts, starts + count + 1);
}

// Ten of each light.
std::vector<double> NumbersOf(const std::vector<LineLight>& lights)
{
  std::vector<double> numbers;
  for (const LineLight& light : lights)
  {
    numbers.push_back(light.Kind);
    for (const glm::dvec3& vector : { light.Direction, light.Diffuse, light.Specular })
    {
      numbers.insert(numbers.end(), &vector.x, &vector.x + 3);
    }
  }
  return numbers;
}
}

void WriteLineVoxels(const LineGrid& grid, int maximumOrder, const std::vector<int>& brickIndices,
  const std::vector<LineTypeBricks>& types, const std::vector<LineLight>& lights, vtkImageData* image)
{
  image->Initialize();
  const glm::ivec3 corners = grid.Bricks() + 1;
  const glm::dvec3 spacing = grid.Voxel * glm::dvec3(grid.Brick);
  image->SetDimensions(&corners.x);
  image->SetOrigin(&grid.Corner.x);
  image->SetSpacing(&spacing.x);
  vtkNew<vtkIntArray> scalars;
  scalars->SetName("BrickIndex");
  scalars->SetNumberOfValues(brickIndices.size());
  std::copy(brickIndices.begin(), brickIndices.end(), scalars->GetPointer(0));
  image->GetCellData()->SetScalars(scalars);
  const glm::ivec3 size = grid.Dimensions, brick = grid.Brick;
  AddIntegers(image, "SampleDimensions", { size.x, size.y, size.z });
  AddIntegers(image, "BrickDimensions", { brick.x, brick.y, brick.z });
  AddIntegers(image, "MaximumOrder", { maximumOrder });
  std::vector<int> numbers;
  for (const LineTypeBricks& type : types)
  {
    numbers.push_back(type.Type);
    WriteType(type, image);
  }
  AddIntegers(image, "LineTypes", numbers);
  const std::vector<double> values = NumbersOf(lights);
  std::copy(values.begin(), values.end(),
    AddArray<vtkDoubleArray>(image, "LineLights", lights.size(), 10)->GetPointer(0));
}

bool HasLights(vtkImageData* image, const std::vector<LineLight>& lights)
{
  const std::vector<double> values = NumbersOf(lights);
  vtkDataArray* array = image->GetFieldData()->GetArray("LineLights");
  const double* stored = Pointer<double>(image, "LineLights", VTK_DOUBLE, values.size());
  const auto isNear = [](double a, double b) { return std::abs(a - b) < 1e-6; };
  return stored && array->GetNumberOfValues() == static_cast<vtkIdType>(values.size()) &&
    std::equal(values.begin(), values.end(), stored, isNear);
}

bool HoldsLineVoxels(vtkImageData* image)
{
  return image->GetCellData()->HasArray("BrickIndex") &&
    Pointer<int>(image, "SampleDimensions", VTK_INT, 3) && Pointer<int>(image, "BrickDimensions", VTK_INT, 3);
}

void GetVoxelSpacing(vtkImageData* image, double spacing[3])
{
  image->GetSpacing(spacing);
  const int* brick = HoldsLineVoxels(image) ? Pointer<int>(image, "BrickDimensions", VTK_INT, 3) : nullptr;
  for (int axis = 0; brick && axis < 3; ++axis)
  {
    spacing[axis] /= std::max(brick[axis], 1);
  }
}

LineVoxels::LineVoxels(vtkImageData* image, std::string& error)
{
  error = this->ReadGrid(image);
  vtkDataArray* types = image->GetFieldData()->GetArray("LineTypes");
  for (vtkIdType i = 0; error.empty() && types && i < types->GetNumberOfTuples(); ++i)
  {
    error = this->ReadType(image, static_cast<int>(types->GetComponent(i, 0)));
  }
}

std::string LineVoxels::ReadGrid(vtkImageData* image)
{
  const int* dimensions = Pointer<int>(image, "SampleDimensions", VTK_INT, 3);
  const int* brick = Pointer<int>(image, "BrickDimensions", VTK_INT, 3);
  const int* order = Pointer<int>(image, "MaximumOrder", VTK_INT, 1);
  vtkDataArray* indices = image->GetCellData()->GetArray("BrickIndex");
  if (!dimensions || !brick || !order || !indices || indices->GetDataType() != VTK_INT)
  {
    return "no anisotropic voxels: cell scalars BrickIndex and field data SampleDimensions, "
           "BrickDimensions and MaximumOrder of int are needed";
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Grid.Dimensions[axis] = dimensions[axis];
    this->Grid.Brick[axis] = brick[axis];
    this->Grid.Corner[axis] = image->GetOrigin()[axis];
    this->Grid.Voxel[axis] = image->GetSpacing()[axis] / std::max(brick[axis], 1);
  }
  const auto isIn = [](const glm::ivec3& lengths, int largest) {
    return glm::all(glm::greaterThan(lengths, glm::ivec3(0))) &&
      glm::all(glm::lessThanEqual(lengths, glm::ivec3(largest)));
  };
  const bool isRight = isIn(this->Grid.Brick, 1024) && isIn(this->Grid.Dimensions, 1 << 20) &&
    this->Grid.VoxelsOfBrick() <= 65536 && *order >= 0 && *order <= 12 &&
    indices->GetNumberOfValues() == this->Grid.NumberOfBricks();
  if (!isRight)
  {
    return "its bricks do not fit its SampleDimensions, or MaximumOrder is not in [0, 12]";
  }
  this->MaximumOrder = *order;
  this->BrickIndices = static_cast<const int*>(indices->GetVoidPointer(0));
  const int* last = std::max_element(this->BrickIndices, this->BrickIndices + indices->GetNumberOfValues());
  this->NumberOfOccupiedBricks = *last + 1;
  return "";
}

std::string LineVoxels::ReadType(vtkImageData* image, int type)
{
  LineCoefficients set;
  set.Type = type;
  std::string broken = "the arrays of line type " + std::to_string(type) + " do not fit each other";
  const vtkIdType bricks = this->NumberOfOccupiedBricks;
  set.BrickStarts = Pointer<vtkTypeInt64>(image, NameOf(type, "BrickStarts"), VTK_TYPE_INT64, bricks + 1);
  if (!set.BrickStarts || !AreStarts(set.BrickStarts, bricks))
  {
    return broken;
  }
  const vtkIdType voxels = std::min(set.BrickStarts[bricks], MostEntries); // more are in no array
  set.NumberOfVoxels = voxels;
  set.VoxelStarts = Pointer<vtkTypeInt64>(image, NameOf(type, "VoxelStarts"), VTK_TYPE_INT64, voxels + 1);
  if (!set.VoxelStarts || !AreStarts(set.VoxelStarts, voxels))
  {
    return broken;
  }
  const vtkIdType count = std::min(set.VoxelStarts[voxels], MostEntries);
  vtkDataArray* values = image->GetFieldData()->GetArray(NameOf(type, "Coefficients").c_str());
  if (values && values->GetNumberOfComponents() != LineChannels)
  {
    return "coefficients of " + std::to_string(values->GetNumberOfComponents()) +
      " components for line type " + std::to_string(type) + ", where " + std::to_string(LineChannels) +
      " are known";
  }
  set.Places = Pointer<unsigned short>(image, NameOf(type, "Places"), VTK_UNSIGNED_SHORT, voxels);
  set.Harmonics = Pointer<unsigned char>(image, NameOf(type, "Harmonics"), VTK_UNSIGNED_CHAR, count);
  set.Values = Pointer<float>(image, NameOf(type, "Coefficients"), VTK_FLOAT, count * LineChannels);
  const double* range = Pointer<double>(image, NameOf(type, "ColorRange"), VTK_DOUBLE, 6);
  const int harmonics = (this->MaximumOrder + 1) * (this->MaximumOrder + 1);
  const bool isRight = range &&
    (voxels == 0 ||
      (set.Places && *std::max_element(set.Places, set.Places + voxels) < this->Grid.VoxelsOfBrick())) &&
    (count == 0 ||
      (set.Values && set.Harmonics && *std::max_element(set.Harmonics, set.Harmonics + count) < harmonics));
  if (!isRight)
  {
    return broken;
  }
  set.LeastColor = { range[0], range[1], range[2] };
  set.LargestColor = { range[3], range[4], range[5] };
  this->Types.push_back(set);
  return "";
}
}
