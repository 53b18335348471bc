// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// What the tests of lines share: lines from points, voxels of them, what a voxel shows.

#ifndef LineTesting_h
#define LineTesting_h

#include "Check.h"
#include "Directions.h"
#include "HarmonicBasis.h"
#include "LineVoxels.h"
#include "VoxelEvaluation.h"
#include "vtkAnisotropicLineVoxelizer.h"
#include "vtkAnisotropicVoxelEvaluator.h"

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

namespace
{
namespace lines
{
using Line = std::vector<glm::dvec3>;

[[maybe_unused]] vtkSmartPointer<vtkPolyData> MakeLines(const std::vector<Line>& all)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (const Line& line : all)
  {
    cells->InsertNextCell(static_cast<int>(line.size()));
    for (const glm::dvec3& point : line)
    {
      cells->InsertCellPoint(points->InsertNextPoint(&point.x));
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(cells);
  return data;
}

// Segments anywhere in [0, 1]^3.
[[maybe_unused]] std::vector<Line> RandomLines(int count, unsigned seed)
{
  RandomDirections random(seed);
  std::vector<Line> all;
  for (int i = 0; i < count; ++i)
  {
    const glm::dvec3 middle(random.Uniform(), random.Uniform(), random.Uniform());
    all.push_back({ middle, middle + random.Uniform(0.0, 0.4) * random.OnSphere() });
  }
  return all;
}

// One voxel, the unit cube.
[[maybe_unused]] void SetUnitVoxel(vtkAnisotropicLineVoxelizer* voxelizer)
{
  voxelizer->SetSampleDimensions(1, 1, 1);
  voxelizer->SetModelBounds(0.0, 1.0, 0.0, 1.0, 0.0, 1.0);
}

[[maybe_unused]] vtkSmartPointer<vtkLight> SceneLight(const glm::dvec3& toLight)
{
  auto light = vtkSmartPointer<vtkLight>::New();
  light->SetLightTypeToSceneLight();
  light->SetPosition(toLight.x, toLight.y, toLight.z);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  return light;
}

// What the voxel with this number of the first type shows; nothing where there is none.
[[maybe_unused]] volumeoptics::EvaluatedVoxel Look(
  vtkImageData* image, const glm::dvec3& toViewer, vtkTypeInt64 voxel = 0)
{
  std::string error;
  const volumeoptics::LineVoxels voxels(image, error);
  if (!error.empty() || voxels.Types.empty() || !voxels.Types[0].Places)
  {
    return {};
  }
  double basis[volumeoptics::HarmonicBasis::LargestCount];
  volumeoptics::HarmonicBasis(voxels.MaximumOrder, false).Evaluate(toViewer, basis);
  return volumeoptics::EvaluateVoxel(voxels.Types[0], voxel, basis, {});
}

[[maybe_unused]] double OpacityOf(const volumeoptics::EvaluatedVoxel& voxel)
{
  return 1.0 - std::exp(-voxel.Depth);
}

// Sum of an array of the field data, of one component.
[[maybe_unused]] double FieldSum(vtkImageData* image, const char* name, int component = 0)
{
  vtkDataArray* array = image->GetFieldData()->GetArray(name);
  double sum = 0.0;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    sum += array->GetComponent(i, component);
  }
  return sum;
}

[[maybe_unused]] vtkIdType CountOf(vtkImageData* image, const char* name)
{
  vtkDataArray* array = image->GetFieldData()->GetArray(name);
  return array ? array->GetNumberOfTuples() : 0;
}

// Largest difference of the coefficients, relative to the largest one; 1 where the sets differ.
[[maybe_unused]] double Difference(vtkImageData* a, vtkImageData* b)
{
  for (const char* name : { "LineType0_Places", "LineType0_Harmonics" })
  {
    if (CountOf(a, name) != CountOf(b, name) || FieldSum(a, name) != FieldSum(b, name))
    {
      return 1.0;
    }
  }
  vtkDataArray* first = a->GetFieldData()->GetArray("LineType0_Coefficients");
  vtkDataArray* second = b->GetFieldData()->GetArray("LineType0_Coefficients");
  double largest = 0.0, off = 0.0;
  for (vtkIdType i = 0; i < first->GetNumberOfValues(); ++i)
  {
    const int channels = first->GetNumberOfComponents();
    const double one = first->GetComponent(i / channels, static_cast<int>(i % channels));
    const double other = second->GetComponent(i / channels, static_cast<int>(i % channels));
    largest = std::max(largest, std::abs(one));
    off = std::max(off, std::abs(one - other));
  }
  return off / std::max(largest, 1e-300);
}

// Warnings and errors of an object, which would fail the test as output.
struct Messages
{
  explicit Messages(vtkObject* object)
    : Object(object)
  {
    this->Command->SetClientData(&this->Texts);
    this->Command->SetCallback([](vtkObject*, unsigned long, void* client, void* text) {
      static_cast<std::vector<std::string>*>(client)->push_back(static_cast<const char*>(text));
    });
    object->AddObserver(vtkCommand::WarningEvent, this->Command);
    object->AddObserver(vtkCommand::ErrorEvent, this->Command);
  }
  ~Messages() { this->Object->RemoveObserver(this->Command); }
  Messages(const Messages&) = delete;
  void operator=(const Messages&) = delete;
  bool Has(const std::string& text) const
  {
    return this->Texts.size() == 1 && this->Texts[0].find(text) != std::string::npos;
  }
  vtkObject* Object;
  vtkNew<vtkCallbackCommand> Command;
  std::vector<std::string> Texts;
};
}
}

#endif
