// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Each row of docs/support.md that the reflectance term, the integral, or, with the argument --lighting, a
// lighting transfer function does not support: it says so once, and the picture is VTK's own.

#include "SupportedSettings.h"

#include "vtkContourValues.h"
#include "vtkFloatArray.h"
#include "vtkMultiVolume.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"

namespace
{
void UseIndependentComponents(TestScene& scene)
{
  scene.Source->Update();
  vtkImageData* source = scene.Source->GetOutput();
  vtkNew<vtkImageData> image;
  image->CopyStructure(source);
  vtkNew<vtkFloatArray> values;
  values->SetNumberOfComponents(2);
  values->SetNumberOfTuples(image->GetNumberOfPoints());
  values->CopyComponent(0, source->GetPointData()->GetScalars(), 0);
  values->CopyComponent(1, source->GetPointData()->GetScalars(), 0);
  image->GetPointData()->SetScalars(values);
  scene.Mapper->SetInputData(image);
}

void UseRectilinearGrid(TestScene& scene)
{
  scene.Source->Update();
  vtkImageData* image = scene.Source->GetOutput();
  vtkNew<vtkRectilinearGrid> grid;
  grid->SetDimensions(image->GetDimensions());
  vtkNew<vtkFloatArray> coordinates;
  for (int i = 0; i < image->GetDimensions()[0]; ++i)
  {
    coordinates->InsertNextValue(static_cast<float>(image->GetOrigin()[0] + i * image->GetSpacing()[0]));
  }
  grid->SetXCoordinates(coordinates);
  grid->SetYCoordinates(coordinates);
  grid->SetZCoordinates(coordinates);
  grid->GetPointData()->SetScalars(image->GetPointData()->GetScalars());
  scene.Mapper->SetInputData(grid);
}

void UseTwoVolumes(TestScene& scene)
{
  vtkNew<vtkVolume> second;
  second->SetProperty(scene.Property);
  second->SetPosition(0.3, 0.0, 0.2);
  scene.Mapper->SetInputConnection(1, scene.Source->GetOutputPort());
  vtkNew<vtkMultiVolume> both;
  both->SetMapper(scene.Mapper);
  both->SetVolume(scene.Volume, 0);
  both->SetVolume(second, 1);
  scene.Renderer->RemoveVolume(scene.Volume);
  scene.Renderer->AddVolume(both);
}

void UseSlice(TestScene& scene)
{
  vtkNew<vtkPlane> plane;
  plane->SetNormal(0.3, 1.0, 0.2);
  scene.Property->SetSliceFunction(plane);
  scene.Mapper->SetBlendModeToSlice();
}

// A model that the scene asks for, and one of its settings, which must not show.
struct Model
{
  const char* Name;
  Setting Use;
  Setting Change;
};

const Model Reflectance = { "reflectance", [](TestScene& s) { s.Property->SetReflectanceModelToWard(); },
  [](TestScene& s) { s.Property->SetGlossiness(0.1); } };
const Model Integral = { "integral", [](TestScene& s) { s.Property->SetIntegrationSpaceToData(); },
  [](TestScene& s) { s.Property->SetClassificationToPreIntegrated(); } };
const Model Lighting = { "lighting transfer function",
  [](TestScene& s) { LightEverywhere(s, 1.0, 1.0, 1.0); },
  [](TestScene& s) { s.Property->SetLightScale(3.0); } };

std::vector<Model> Models;

void CheckRefusedBy(Check& check, const Model& model, const std::string& setName, const Setting& setting)
{
  const std::string name = std::string(model.Name) + ", " + setName;
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> stock;
  TestScene expected(stock);
  setting(expected);
  TestScene scene;
  setting(scene);
  model.Use(scene);
  Warnings warnings(scene.Optics);
  const std::vector<unsigned char> first = scene.Render();
  model.Change(scene);
  const std::vector<unsigned char> second = scene.Render();
  check.That(expected.Render() == first, name + ": the picture is not VTK's");
  check.That(first == second, name + ": a setting of the refused model changes the picture");
  check.That(scene.Optics->GetActiveTerms().empty(), name + ": the term is active");
  check.That(warnings.Texts.size() == 1,
    name + ": said " + std::to_string(warnings.Texts.size()) + " times, not once");
}

void CheckRefused(Check& check, const std::string& name, const Setting& setting)
{
  for (const Model& model : Models)
  {
    CheckRefusedBy(check, model, name, setting);
  }
}

void AddTooManyIsosurfaces(TestScene& s)
{
  for (int i = 0; i < 1025; ++i)
  {
    s.Property->AddIsosurface(i / 1025.0, 0.1);
  }
}

// A model of light goes on without the integral, and so without its isosurfaces.
void CheckModelWithoutIntegral(Check& check)
{
  const auto draw = [](bool isWanted, const std::string& said) {
    TestScene scene;
    scene.Window->SetSize(40, 40);
    scene.Property->SetReflectanceModelToWard();
    if (isWanted)
    {
      scene.Property->SetIntegrationSpaceToData();
      AddTooManyIsosurfaces(scene);
    }
    Warnings warnings(scene.Optics);
    const std::vector<unsigned char> picture = scene.Render();
    const bool isSaid = !warnings.Texts.empty() && warnings.Texts[0].find(said) != std::string::npos;
    return isSaid == isWanted ? picture : std::vector<unsigned char>();
  };
  check.That(draw(true, "1025 isosurfaces") == draw(false, "1025 isosurfaces"),
    "too many isosurfaces: the model's picture is another one, or nothing is said");
}

void CheckRefusedByIntegral(Check& check)
{
  for (const Row& row : Rows)
  {
    const std::string name = row.Name;
    if (name == "2D transfer function" || name == "label map")
    {
      CheckRefusedBy(check, Integral, name, row.Apply);
    }
  }
  CheckRefusedBy(check, Integral, "more isosurfaces than there is room for",
    [](TestScene& s) { AddTooManyIsosurfaces(s); });
  CheckModelWithoutIntegral(check);
}
}

int TestRefusedSettings(int argc, char* argv[])
{
  const bool isLighting =
    std::any_of(argv, argv + argc, [](char* word) { return std::string(word) == "--lighting"; });
  Models = isLighting ? std::vector<Model>{ Lighting } : std::vector<Model>{ Reflectance, Integral };
  Check check;
  CheckRefused(check, "maximum intensity", [](TestScene& s) { s.Mapper->SetBlendModeToMaximumIntensity(); });
  CheckRefused(check, "minimum intensity", [](TestScene& s) { s.Mapper->SetBlendModeToMinimumIntensity(); });
  CheckRefused(check, "average intensity", [](TestScene& s) { s.Mapper->SetBlendModeToAverageIntensity(); });
  CheckRefused(check, "additive", [](TestScene& s) { s.Mapper->SetBlendModeToAdditive(); });
  CheckRefused(check, "isosurface", [](TestScene& s) {
    s.Mapper->SetBlendModeToIsoSurface();
    s.Property->GetIsoSurfaceValues()->SetValue(0, 0.5);
  });
  CheckRefused(check, "slice", UseSlice);
  CheckRefused(check, "several volumes in one mapper", UseTwoVolumes);
  CheckRefused(check, "independent components", UseIndependentComponents);
  CheckRefused(check, "rectilinear grid", UseRectilinearGrid);
  CheckRefused(check, "gradient opacity of a label", [](TestScene& s) {
    vtkNew<vtkPiecewiseFunction> function;
    function->AddPoint(0.0, 1.0);
    s.Property->SetLabelGradientOpacity(1, function);
  });
  if (!isLighting)
  {
    CheckRefusedByIntegral(check);
  }
  return check.ExitCode();
}
