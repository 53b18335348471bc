// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// What the tests of the filters share: images from formulas, comparisons, a source that records
// what is requested of it.

#ifndef FilterTesting_h
#define FilterTesting_h

#include "vtkDataArray.h"
#include "vtkImageAlgorithm.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace
{
namespace testing
{
using Field = std::function<double(const glm::dvec3&)>; // of a world point

struct Geometry
{
  std::array<int, 6> Extent = { 0, 31, 0, 31, 0, 31 };
  glm::dvec3 Spacing = glm::dvec3(1.0);
  glm::dvec3 Origin = glm::dvec3(0.0);
  glm::dmat3 Direction = glm::dmat3(1.0);
};

// Turned about an axis that is none of the image's.
[[maybe_unused]] glm::dmat3 Rotation()
{
  const glm::dvec3 x = glm::normalize(glm::dvec3(0.8, 0.5, -0.3));
  const glm::dvec3 z = glm::normalize(glm::cross(x, glm::dvec3(0.1, 0.9, 0.4)));
  return glm::dmat3(x, glm::cross(z, x), z);
}

[[maybe_unused]] vtkSmartPointer<vtkImageData> MakeImage(
  const Geometry& geometry, const Field& field, int type = VTK_FLOAT)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(const_cast<int*>(geometry.Extent.data()));
  image->SetSpacing(&geometry.Spacing.x);
  image->SetOrigin(&geometry.Origin.x);
  const glm::dmat3 rows = glm::transpose(geometry.Direction);
  image->SetDirectionMatrix(&rows[0].x);
  image->AllocateScalars(type, 1);
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    glm::dvec3 point;
    image->GetPoint(i, &point.x);
    scalars->SetComponent(i, 0, field(point));
  }
  return image;
}

[[maybe_unused]] glm::dvec3 VectorAt(vtkDataArray* array, vtkIdType point)
{
  glm::dvec3 vector;
  array->GetTuple(point, &vector.x);
  return vector;
}

// Counts what is wrong and says it.
class Report
{
public:
  void Check(bool isRight, const std::string& what)
  {
    if (!isRight)
    {
      std::cerr << "Failed: " << what << "\n";
      this->Failed = true;
    }
  }
  void CheckAtMost(double value, double largest, const std::string& what)
  {
    std::cout << what << ": " << value << ", at most " << largest << "\n";
    this->Check(value <= largest, what + " is " + std::to_string(value));
  }
  void CheckAtLeast(double value, double least, const std::string& what)
  {
    std::cout << what << ": " << value << ", at least " << least << "\n";
    this->Check(value >= least, what + " is " + std::to_string(value));
  }
  int ExitCode() const { return this->Failed ? EXIT_FAILURE : EXIT_SUCCESS; }

private:
  bool Failed = false;
};

// Number of values that are NaN or infinite.
[[maybe_unused]] long long CountNotFinite(vtkDataArray* array)
{
  long long count = 0;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      count += !std::isfinite(array->GetComponent(i, c));
    }
  }
  return count;
}

// Number of tuples of a piece whose bytes differ from those of the whole image.
[[maybe_unused]] long long CountDifferent(vtkImageData* whole, vtkImageData* piece, const char* name)
{
  vtkDataArray* wanted = whole->GetPointData()->GetArray(name);
  vtkDataArray* found = piece->GetPointData()->GetArray(name);
  if (!wanted || !found)
  {
    return piece->GetNumberOfPoints() + 1;
  }
  const std::size_t size = wanted->GetNumberOfComponents() * wanted->GetDataTypeSize();
  int extent[6];
  piece->GetExtent(extent);
  long long different = 0;
  vtkIdType point = 0;
  for (int z = extent[4]; z <= extent[5]; ++z)
  {
    for (int y = extent[2]; y <= extent[3]; ++y)
    {
      for (int x = extent[0]; x <= extent[1]; ++x, ++point)
      {
        int index[3] = { x, y, z };
        const vtkIdType other = whole->ComputePointId(index);
        different += std::memcmp(static_cast<char*>(found->GetVoidPointer(0)) + point * size,
                       static_cast<char*>(wanted->GetVoidPointer(0)) + other * size, size) != 0;
      }
    }
  }
  return different;
}

// Passes on exactly the extents of an image that are requested, and remembers them.
class RecordingSource : public vtkImageAlgorithm
{
public:
  static RecordingSource* New();
  vtkTypeMacro(RecordingSource, vtkImageAlgorithm);

  void SetImage(vtkImageData* image)
  {
    this->Image = image;
    this->Modified();
  }
  std::vector<std::array<int, 6>> Requests;

protected:
  RecordingSource() { this->SetNumberOfInputPorts(0); }

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    vtkInformation* info = outputs->GetInformationObject(0);
    info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), this->Image->GetExtent(), 6);
    info->Set(vtkDataObject::SPACING(), this->Image->GetSpacing(), 3);
    info->Set(vtkDataObject::ORIGIN(), this->Image->GetOrigin(), 3);
    info->Set(vtkDataObject::DIRECTION(), this->Image->GetDirectionMatrix()->GetData(), 9);
    info->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
    return 1;
  }

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    std::array<int, 6> extent;
    outputs->GetInformationObject(0)->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent.data());
    this->Requests.push_back(extent);
    vtkNew<vtkImageData> part;
    part->ShallowCopy(this->Image);
    part->Crop(extent.data());
    vtkImageData::GetData(outputs)->ShallowCopy(part);
    return 1;
  }

private:
  vtkSmartPointer<vtkImageData> Image;
};
vtkStandardNewMacro(RecordingSource);

// The eight octants of an extent.
[[maybe_unused]] std::vector<std::array<int, 6>> Octants(const int whole[6])
{
  std::vector<std::array<int, 6>> octants;
  for (int i = 0; i < 8; ++i)
  {
    std::array<int, 6> octant;
    for (int axis = 0; axis < 3; ++axis)
    {
      // Not in the middle, so that no block or tile ends there.
      const int split = whole[2 * axis] + (whole[2 * axis + 1] - whole[2 * axis]) * (4 + axis) / 10;
      octant[2 * axis] = i >> axis & 1 ? split + 1 : whole[2 * axis];
      octant[2 * axis + 1] = i >> axis & 1 ? whole[2 * axis + 1] : split;
    }
    octants.push_back(octant);
  }
  return octants;
}

// Reproducible noise in [0, 1).
[[maybe_unused]] double Noise(const glm::dvec3& point, double seed = 0.0)
{
  const double value = std::sin(glm::dot(point, glm::dvec3(12.9898, 78.233, 37.719)) + seed) * 43758.5453;
  return value - std::floor(value);
}
}
}

#endif
