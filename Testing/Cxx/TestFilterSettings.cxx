// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Values outside their range are set to the nearest one with one warning; wrong inputs give one
// error that names the remedy, and an empty output.

#include "FilterTesting.h"
#include "vtkAmbientCovarianceFilter.h"
#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkExecutive.h"
#include "vtkFloatArray.h"
#include "vtkPrincipalCurvatureFilter.h"
#include "vtkSobelNormalFilter.h"

#include <sstream>

namespace
{
struct Messages
{
  int Count = 0;
  std::string Last;
};

void Remember(vtkObject*, unsigned long, void* data, void* text)
{
  auto* messages = static_cast<Messages*>(data);
  ++messages->Count;
  messages->Last = static_cast<const char*>(text);
}

void Observe(vtkObject* object, Messages& messages)
{
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(Remember);
  command->SetClientData(&messages);
  object->AddObserver(vtkCommand::WarningEvent, command);
  object->AddObserver(vtkCommand::ErrorEvent, command);
}

class Checker
{
public:
  void One(const std::string& part, const std::string& what)
  {
    this->Report.Check(this->Messages.Count == 1 && this->Messages.Last.find(part) != std::string::npos,
      what + ": " + std::to_string(this->Messages.Count) + " messages, the last: " + this->Messages.Last);
    this->Messages = {};
  }
  testing::Report Report;
  ::Messages Messages;
};

void CheckRanges(Checker& checker)
{
  vtkNew<vtkAmbientCovarianceFilter> filter;
  Observe(filter, checker.Messages);
  filter->SetRadius(-1.0);
  checker.One("[0.5, 256]", "Radius");
  checker.Report.Check(filter->GetRadius() == 0.5, "Radius is the nearest");
  filter->SetRadius(std::nan(""));
  checker.One("not a number", "Radius NaN");
  checker.Report.Check(filter->GetRadius() == 0.5, "Radius stays");
  filter->SetScalarTolerance(2.0);
  checker.One("[0, 1]", "ScalarTolerance");
  filter->SetNumberOfSamples(0);
  checker.One("[3, 65536]", "NumberOfSamples");
  filter->SetSamplingPattern(7);
  checker.One("Exhaustive (3)", "SamplingPattern");
  filter->SetSampleInterpolation(-1);
  checker.One("Linear (1)", "SampleInterpolation");
  filter->SetFilterStandardDeviation(-1.0);
  checker.One("[0, 100]", "FilterStandardDeviation");
  filter->SetStorage(5);
  checker.One("World (2)", "Storage");
  filter->SetResolutionFactor(3.0);
  checker.One("[0.01, 1]", "ResolutionFactor");
  filter->SetSmoothing(-2.0);
  checker.One("[0, 100]", "Smoothing");
  filter->SetOutputPrecision(12);
  checker.One("8, 16, 32", "OutputPrecision");
  filter->SetInputComponent(-1);
  checker.One("InputComponent", "InputComponent");
  filter->SetScalarRange(0.0, HUGE_VAL);
  checker.One("finite", "ScalarRange");
  std::ostringstream printed;
  filter->Print(printed);
  for (const char* name : { "Radius", "ScalarTolerance", "ScalarRange", "NumberOfSamples", "SamplingPattern",
         "SampleInterpolation", "FilterStandardDeviation", "NoiseCorrection", "Seed", "Storage",
         "ResolutionFactor", "Smoothing", "InputComponent", "OutputPrecision" })
  {
    checker.Report.Check(printed.str().find(std::string(name) + ": ") != std::string::npos,
      std::string("PrintSelf names ") + name);
  }
}

void CheckInputs(Checker& checker)
{
  testing::Geometry geometry;
  geometry.Extent = { 0, 5, 0, 5, 0, 5 };
  const auto image = testing::MakeImage(geometry, [](const glm::dvec3& p) { return p.x; });
  vtkNew<vtkImageData> empty;
  empty->SetDimensions(4, 4, 4);
  vtkNew<vtkImageData> ofCells;
  ofCells->CopyStructure(image);
  vtkNew<vtkFloatArray> values;
  values->SetName("values");
  values->SetNumberOfTuples(ofCells->GetNumberOfCells());
  values->Fill(1.0);
  ofCells->GetCellData()->AddArray(values);

  vtkNew<vtkSobelNormalFilter> filter;
  Observe(filter, checker.Messages);
  Messages pipeline; // the executive says that the algorithm failed
  Observe(filter->GetExecutive(), pipeline);
  auto run = [&](vtkImageData* input, const std::string& part) {
    filter->SetInputData(input);
    filter->Update();
    checker.One(part, part);
    checker.Report.Check(
      filter->GetOutput()->GetPointData()->GetNumberOfArrays() == 0, "the output is empty");
  };
  run(empty, "point scalars");
  filter->SetInputComponent(3);
  run(image, "InputComponent 3");
  filter->SetInputComponent(0);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "values");
  run(ofCells, "vtkCellDataToPointData");

  vtkNew<vtkAmbientCovarianceFilter> covariance;
  Observe(covariance, checker.Messages);
  Observe(covariance->GetExecutive(), pipeline);
  covariance->SetInputData(image);
  covariance->SetNormalsData(image);
  covariance->Update();
  checker.One("vtkSobelNormalFilter", "no normals");
}
}

int TestFilterSettings(int, char*[])
{
  Checker checker;
  CheckRanges(checker);
  CheckInputs(checker);
  return checker.Report.ExitCode();
}
