// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Inputs, properties and windows that change, come back or are missing: each picture is that of a
// mapper that has seen nothing else.

#include "FrameEvents.h"
#include "TestScene.h"

#include "vtkExecutive.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkShortArray.h"
#include "vtkSmartVolumeMapper.h"

#include <functional>

namespace
{
using Setting = std::function<void(TestScene&)>;

vtkSmartPointer<vtkImageData> Field(TestScene& scene, int size)
{
  scene.Source->SetDimensions(size, size, size);
  scene.Source->Update();
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->DeepCopy(scene.Source->GetOutput());
  return image;
}

// The field as another type, whose transfer functions are 1000 times as wide.
void UseShorts(TestScene& scene)
{
  vtkSmartPointer<vtkImageData> image = Field(scene, 24);
  vtkNew<vtkShortArray> scalars;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    scalars->InsertNextValue(
      static_cast<short>(1000.0 * image->GetPointData()->GetScalars()->GetComponent(i, 0)));
  }
  image->GetPointData()->SetScalars(scalars);
  scene.Mapper->SetInputData(image);
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(400.0, 0.0);
  scene.Opacity->AddPoint(600.0, 0.9);
}

void UseField(TestScene& scene)
{
  scene.Mapper->SetInputData(Field(scene, 32));
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(0.4, 0.0);
  scene.Opacity->AddPoint(0.6, 0.9);
}

// The same image, whose scalars change in place.
void TurnScalars(TestScene& scene)
{
  auto* image = vtkImageData::SafeDownCast(scene.Mapper->GetDataSetInput());
  auto* scalars = vtkFloatArray::SafeDownCast(image->GetPointData()->GetScalars());
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    scalars->SetValue(i, 1.1F - scalars->GetValue(i));
  }
  scalars->Modified();
}

void UseProperty(TestScene& scene, int model)
{
  vtkNew<vtkOpticsVolumeProperty> property;
  property->DeepCopy(scene.Property);
  property->SetReflectanceModel(model);
  scene.Volume->SetProperty(property);
}

void UsePlainProperty(TestScene& scene)
{
  vtkNew<vtkVolumeProperty> property;
  property->DeepCopy(scene.Property);
  scene.Volume->SetProperty(property);
}

struct Step
{
  const char* Name;
  Setting Apply;
};

const Step Steps[] = {
  { "shorts", UseShorts },
  { "floats", UseField },
  { "scalars changed in place",
    [](TestScene& scene) {
      UseField(scene);
      TurnScalars(scene);
    } },
  { "floats again", UseField },
  { "a property of Lafortune",
    [](TestScene& scene) { UseProperty(scene, vtkOpticsVolumeProperty::Lafortune); } },
  { "a plain property", UsePlainProperty },
  { "a plain property with the mapper's optics",
    [](TestScene& scene) {
      UsePlainProperty(scene);
      scene.Optics->SetOptics(scene.Property);
    } },
  { "a property without surface",
    [](TestScene& scene) { UseProperty(scene, vtkOpticsVolumeProperty::None); } },
  { "a property of Ward", [](TestScene& scene) { UseProperty(scene, vtkOpticsVolumeProperty::Ward); } },
  { "nearest values",
    [](TestScene& scene) {
      UseProperty(scene, vtkOpticsVolumeProperty::Ward);
      scene.Volume->GetProperty()->SetInterpolationTypeToNearest();
    } },
  { "linear values", [](TestScene& scene) { UseProperty(scene, vtkOpticsVolumeProperty::Ward); } },
};

void CheckSteps(Check& check)
{
  TestScene scene;
  scene.Property->SetReflectanceModelToWard();
  Warnings warnings(scene.Optics);
  for (const Step& step : Steps)
  {
    TestScene fresh;
    fresh.Property->SetReflectanceModelToWard();
    UseField(fresh);
    step.Apply(fresh);
    step.Apply(scene);
    check.That(scene.Render() == fresh.Render(), std::string(step.Name) + ": the picture has a memory");
  }
  check.That(warnings.Texts.empty(), "a change makes the mapper say something");
}

void CheckTwoWindows(Check& check)
{
  TestScene first;
  first.Property->SetReflectanceModelToWard();
  const std::vector<unsigned char> expected = first.Render();
  for (int i = 0; i < 2; ++i)
  {
    TestScene second;
    second.Property->SetReflectanceModelToWard();
    second.Volume->SetMapper(first.Mapper);
    check.That(second.Render() == expected, "the second window shows another picture");
    check.That(first.Render() == expected, "back in the first window the picture is another one");
    check.That(second.Render() == expected, "the second window shows another picture the second time");
  } // the second window goes, the mapper stays
  check.That(first.Render() == expected, "after a window has gone the picture is another one");
}

// A window goes before its mapper, with or without its renderer's help.
void CheckWindowFirst(Check& check, bool tellsMapper)
{
  vtkNew<vtkOpticsVolumeMapper> mapper;
  std::vector<unsigned char> expected;
  for (int i = 0; i < 3; ++i)
  {
    TestScene scene(mapper);
    scene.Property->SetReflectanceModelToWard();
    const std::vector<unsigned char> pixels = scene.Render();
    expected = i == 0 ? pixels : expected;
    check.That(pixels == expected, "window " + std::to_string(i) + " shows another picture");
    check.That(mapper->GetActiveTerms() == "Reflectance,EmptySpace", "a term is not active in a new window");
    if (!tellsMapper)
    {
      scene.Renderer->RemoveVolume(scene.Volume);
    }
    scene.Window->Finalize();
    if (tellsMapper)
    {
      check.That(mapper->GetTermMemorySize() == 0, "textures outlive their window");
    }
    else
    {
      scene.Renderer->AddVolume(scene.Volume);
      check.That(scene.Render() == expected, "the window made anew shows another picture");
    }
  }
}

vtkSmartPointer<vtkImageData> Empty(bool hasPoints)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  if (hasPoints)
  {
    image->SetDimensions(8, 8, 8);
  }
  return image;
}

// No crash, one error that tells what to do, and the picture as soon as there is something to draw.
void CheckMissing(Check& check, const std::string& name, const std::string& remedy, const Setting& takeAway)
{
  TestScene scene;
  scene.Property->SetReflectanceModelToWard();
  const std::vector<unsigned char> expected = scene.Render();
  Warnings warnings(scene.Optics);
  takeAway(scene);
  scene.Renderer->ResetCameraClippingRange();
  const std::vector<unsigned char> pixels = scene.Render();
  scene.Render();
  check.That(std::equal(pixels.begin() + 3, pixels.end(), pixels.begin()), name + ": something is drawn");
  check.That(warnings.Texts.size() == 1,
    name + ": said " + std::to_string(warnings.Texts.size()) + " times, not once");
  for (const std::string& text : warnings.Texts)
  {
    check.That(text.find(remedy) != std::string::npos, name + ": no remedy in " + text);
  }
  scene.Mapper->SetInputConnection(scene.Source->GetOutputPort());
  scene.Renderer->ResetCameraClippingRange();
  check.AtMost(
    name + ": difference of the picture afterwards", LargestDifference(scene.Render(), expected), 1);
}

// VTK's pipeline has its own error for that.
void CheckNoInput(Check& check)
{
  TestScene scene;
  scene.Property->SetReflectanceModelToWard();
  const std::vector<unsigned char> expected = scene.Render();
  scene.Mapper->RemoveAllInputConnections(0);
  Warnings errors(scene.Mapper->GetExecutive());
  Warnings warnings(scene.Optics);
  const std::vector<unsigned char> pixels = scene.Render();
  check.That(std::equal(pixels.begin() + 3, pixels.end(), pixels.begin()), "no input: something is drawn");
  check.That(!errors.Texts.empty() && warnings.Texts.empty(), "no input: not said by VTK alone");
  scene.Mapper->SetInputConnection(scene.Source->GetOutputPort());
  check.That(scene.Render() == expected, "the picture after there was no input is another one");
}

// vtkSmartVolumeMapper's ray caster and its coarse one are ours, too.
void CheckSmartMapper(Check& check)
{
  TestScene expected;
  expected.Property->SetReflectanceModelToWard();
  vtkOpticsVolumeMapper::SetGlobalOverride(true);
  vtkNew<vtkSmartVolumeMapper> smart;
  vtkOpticsVolumeMapper::SetGlobalOverride(false);
  TestScene scene;
  scene.Property->SetReflectanceModelToWard();
  smart->SetInputConnection(scene.Source->GetOutputPort());
  smart->SetRequestedRenderModeToGPU();
  smart->SetAutoAdjustSampleDistances(0);
  smart->SetInteractiveAdjustSampleDistances(0);
  smart->SetSampleDistance(0.02F);
  scene.Volume->SetMapper(smart);
  // VTK's own does so by 1 without any term
  check.AtMost("difference of vtkSmartVolumeMapper", LargestDifference(scene.Render(), expected.Render()), 3);
  check.That(smart->GetLastUsedRenderMode() == vtkSmartVolumeMapper::GPURenderMode, "it is no ray caster");

  // more than the memory that the smart mapper may take: it resamples the volume for its coarse mapper
  smart->SetMaxMemoryInBytes(20000);
  scene.Source->SetDimensions(48, 48, 48);
  expected.Property->SetReflectanceModelToVTK();
  expected.Source->SetDimensions(48, 48, 48);
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(scene.Window);
  for (const double rate : { interactor->GetStillUpdateRate(), interactor->GetDesiredUpdateRate() })
  {
    scene.Window->SetDesiredUpdateRate(rate);
    check.AtLeast("difference of the coarse smart mapper from VTK's model",
      LargestDifference(scene.Render(), expected.Render()), 20);
    check.That(AreFinite(scene.RenderFloat()), "a pixel of the smart mapper is not finite");
  }
}
}

int TestChangingScenes(int, char*[])
{
  Check check;
  CheckSteps(check);
  CheckTwoWindows(check);
  CheckWindowFirst(check, true);
  CheckWindowFirst(check, false);
  CheckNoInput(check);
  CheckMissing(
    check, "no scalars", "scalars", [](TestScene& scene) { scene.Mapper->SetInputData(Empty(true)); });
  CheckMissing(
    check, "no points", "scalars", [](TestScene& scene) { scene.Mapper->SetInputData(Empty(false)); });
  CheckSmartMapper(check);
  return check.ExitCode();
}
