// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Every scalar type, memory layout and component gives the same normals and covariance.

#include "FilterTesting.h"
#include "vtkAmbientCovarianceFilter.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkSobelNormalFilter.h"

namespace
{
double Scalar(const glm::dvec3& p)
{
  return std::round(60.0 + 25.0 * std::sin(0.4 * p.x) + 20.0 * std::cos(0.3 * p.y + 0.2 * p.z));
}

void CheckEqual(vtkImageData* image, int component, const char* array, vtkImageData* normals,
  vtkImageData* covariance, const std::string& name, testing::Report& report)
{
  vtkNew<vtkSobelNormalFilter> sobel;
  sobel->SetInputData(image);
  sobel->SetInputComponent(component);
  vtkNew<vtkAmbientCovarianceFilter> filter;
  filter->SetInputData(image);
  filter->SetInputComponent(component);
  filter->SetRadius(4.0);
  if (array)
  {
    sobel->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, array);
    filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, array);
  }
  sobel->Update();
  filter->Update();
  report.CheckAtMost(
    testing::CountDifferent(normals, sobel->GetOutput(), "Normals"), 0, name + ": different normals");
  report.CheckAtMost(testing::CountDifferent(covariance, filter->GetOutput(), "AmbientCovariance"), 0,
    name + ": different covariances");
}
}

int TestFilterScalarTypes(int, char*[])
{
  testing::Report report;
  testing::Geometry geometry;
  geometry.Extent = { 0, 19, 0, 19, 0, 19 };
  const auto reference = testing::MakeImage(geometry, Scalar, VTK_DOUBLE);
  vtkNew<vtkSobelNormalFilter> sobel;
  sobel->SetInputData(reference);
  sobel->Update();
  vtkNew<vtkAmbientCovarianceFilter> filter;
  filter->SetInputData(reference);
  filter->SetRadius(4.0);
  filter->Update();
  for (const int type :
    { VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT,
      VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG, VTK_UNSIGNED_LONG_LONG, VTK_ID_TYPE, VTK_FLOAT })
  {
    CheckEqual(testing::MakeImage(geometry, Scalar, type), 0, nullptr, sobel->GetOutput(),
      filter->GetOutput(), vtkImageScalarTypeNameMacro(type), report);
  }
  vtkNew<vtkSOADataArrayTemplate<float>> columns;
  columns->SetName("Columns");
  columns->SetNumberOfComponents(2);
  columns->SetNumberOfTuples(reference->GetNumberOfPoints());
  for (vtkIdType i = 0; i < reference->GetNumberOfPoints(); ++i)
  {
    columns->SetComponent(i, 0, testing::Noise(glm::dvec3(i, 0, 0)));
    columns->SetComponent(i, 1, reference->GetPointData()->GetScalars()->GetComponent(i, 0));
  }
  const auto image = testing::MakeImage(geometry, [](const glm::dvec3&) { return 0.0; });
  image->GetPointData()->AddArray(columns);
  CheckEqual(
    image, 1, "Columns", sobel->GetOutput(), filter->GetOutput(), "second of a structure of arrays", report);
  return report.ExitCode();
}
