// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Lighting.h"

#include "OutputFile.h"
#include "ReadingGuard.h"
#include "UserError.h"

#include "vtkGradientAlignedHistogram.h"
#include "vtkLightingTransferFunction.h"
#include "vtkLightingTransferFunctionItem.h"
#include "vtkMultiSampleClassification.h"
#include "vtkOpticsVolumeProperty.h"

#include <vtkCallbackCommand.h>
#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkImageData.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRenderer.h>

#include <fstream>
#include <iterator>

namespace
{
// Turns an object's errors into one text instead of output.
class Errors
{
public:
  explicit Errors(vtkObject* object)
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(&this->Text);
    command->SetCallback([](vtkObject*, unsigned long, void* text, void* message) {
      *static_cast<std::string*>(text) += LastLine(static_cast<const char*>(message));
    });
    object->AddObserver(vtkCommand::ErrorEvent, command);
  }

  std::string Text;
};
}

std::string ReadLighting(const std::string& path)
{
  const ReadingGuard guard(path);
  const vtkNew<vtkLightingTransferFunction> function;
  const Errors errors(function);
  if (!function->ReadJson(path.c_str()))
  {
    throw UserError(errors.Text + ". The format is in docs/lighting-transfer-function.md.");
  }
  return function->WriteJsonString();
}

void WriteLighting(vtkLightingTransferFunction* function, const std::string& path)
{
  const vtkNew<vtkLightingTransferFunction> copy;
  const Errors errors(copy);
  copy->ShallowCopy(function);
  WriteFile(path, [&](const std::string& temporary) { return copy->WriteJson(temporary.c_str()); });
}

void Apply(const LightingSettings& lighting, vtkOpticsVolumeProperty* property)
{
  vtkSmartPointer<vtkLightingTransferFunction> function;
  if (!lighting.Function.empty())
  {
    function = vtkSmartPointer<vtkLightingTransferFunction>::New();
    function->ReadJsonString(lighting.Function);
  }
  property->SetLightingTransferFunction(function);
  vtkSmartPointer<vtkMultiSampleClassification> rules;
  if (!lighting.Rules.empty())
  {
    rules = vtkSmartPointer<vtkMultiSampleClassification>::New();
    rules->ReadJsonString(lighting.Rules);
  }
  property->SetMultiSampleClassification(rules);
  property->SetLightScale(lighting.Scale);
  property->SetGradientStepLength(lighting.StepLength);
  property->SetHybridNormals(lighting.HybridNormals);
}

LightingPane::LightingPane(vtkImageData* image, vtkPiecewiseFunction* opacity,
  vtkLightingTransferFunction* function, double stepLength, int guesses)
{
  this->Histogram->SetInputData(image);
  this->Histogram->SetStepLength(stepLength);
  this->Histogram->Update();
  this->Item->SetLightingTransferFunction(function);
  this->Item->SetHistogram(this->Histogram->GetOutput(0));
  this->Item->SetGradientHistogram(this->Histogram->GetOutput(1));
  this->Item->SetOpacityFunction(opacity);
  if (function->GetNumberOfBoundaries() == 0 && !function->GetTableImage())
  {
    this->Item->InitializeFromHistogram(guesses);
  }
  this->Actor->GetScene()->AddItem(this->Item);
  this->Actor->GetScene()->SetRenderer(this->Renderer);
  this->Renderer->AddActor(this->Actor);
}

LightingPane::~LightingPane() = default;

vtkContextScene* LightingPane::GetScene()
{
  return this->Actor->GetScene();
}
