// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Extremes of the integral on a target of float: nothing but finite numbers, opacity in [0, 1].

#include "TestScene.h"

#include "vtkFloatArray.h"
#include "vtkPointData.h"

#include <functional>
#include <limits>

namespace
{
using Setting = std::function<void(TestScene&)>;

// The ellipsoid's scalars times a factor, the opacity function's nodes with them.
void ScaleData(TestScene& scene, double factor)
{
  scene.Source->Update();
  vtkNew<vtkImageData> image;
  image->CopyStructure(scene.Source->GetOutput());
  vtkDataArray* source = scene.Source->GetOutput()->GetPointData()->GetScalars();
  vtkNew<vtkFloatArray> values;
  for (vtkIdType i = 0; i < source->GetNumberOfTuples(); ++i)
  {
    values->InsertNextValue(static_cast<float>(source->GetComponent(i, 0) * factor));
  }
  image->GetPointData()->SetScalars(values);
  scene.Mapper->SetInputData(image);
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(0.2 * factor, 0.0);
  scene.Opacity->AddPoint(0.8 * factor, 0.1);
  scene.Property->RemoveAllIsosurfaces();
  scene.Property->AddIsosurface(0.5 * factor, 0.5);
}

void PutNaN(TestScene& scene)
{
  scene.Source->Update();
  vtkNew<vtkImageData> image;
  image->DeepCopy(scene.Source->GetOutput());
  vtkDataArray* values = image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); i += 7)
  {
    values->SetComponent(i, 0, std::numeric_limits<double>::quiet_NaN());
  }
  scene.Mapper->SetInputData(image);
}

void UseOpacity(TestScene& scene, double low, double high)
{
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(0.0, low);
  scene.Opacity->AddPoint(1.0, high);
}

struct Extreme
{
  const char* Name;
  Setting Apply;
};

const Extreme Extremes[] = {
  { "opacity 0", [](TestScene& s) { UseOpacity(s, 0.0, 0.0); } },
  { "opacity 1", [](TestScene& s) { UseOpacity(s, 1.0, 1.0); } },
  { "a tiny unit interval", [](TestScene& s) { s.Property->SetScalarOpacityUnitInterval(1.0e-35); } },
  { "a vast unit interval", [](TestScene& s) { s.Property->SetScalarOpacityUnitInterval(1.0e35); } },
  { "a range of 1e-30", [](TestScene& s) { ScaleData(s, 1.0e-30); } },
  { "a range of 1e30", [](TestScene& s) { ScaleData(s, 1.0e30); } },
  { "NaN voxels", PutNaN },
  { "constant data", [](TestScene& s) { ScaleData(s, 0.0); } },
  { "one node",
    [](TestScene& s) {
      s.Opacity->RemoveAllPoints();
      s.Opacity->AddPoint(0.5, 0.3);
    } },
  { "coincident nodes",
    [](TestScene& s) {
      s.Opacity->RemoveAllPoints();
      s.Opacity->AddPoint(0.5, 0.0, 0.5, 1.0);
      s.Opacity->AddPoint(0.5, 1.0, 0.5, 1.0);
    } },
  { "functions beside the data",
    [](TestScene& s) {
      s.Opacity->RemoveAllPoints();
      s.Opacity->AddPoint(5.0, 0.0);
      s.Opacity->AddPoint(6.0, 1.0);
    } },
  { "a table of 2 entries", [](TestScene& s) { s.Optics->SetPreIntegrationTableSize(2); } },
  { "half floats", [](TestScene& s) { s.Optics->SetTablePrecision(16); } },
  { "long steps", [](TestScene& s) { s.Mapper->SetSampleDistance(100.0F); } },
  { "a headlight on one side, seen from the other",
    [](TestScene& s) {
      s.Property->ShadeOn();
      s.Renderer->TwoSidedLightingOff();
    } },
  { "many isosurfaces",
    [](TestScene& s) {
      for (int i = 0; i < 64; ++i)
      {
        s.Property->AddIsosurface(i / 64.0, 0.02);
      }
    } },
};

void CheckExtreme(Check& check, const Extreme& extreme, bool preIntegrated, int silhouette)
{
  TestScene scene;
  scene.Window->SetSize(16, 16);
  scene.Source->SetDimensions(16, 16, 16);
  Warnings warnings(scene.Optics);
  scene.Renderer->SetBackground(0.0, 0.0, 0.0);
  scene.Color->RemoveAllPoints();
  scene.Color->AddRGBPoint(0.0, 1.0, 1.0, 1.0); // so that red is the opacity
  scene.Property->ShadeOff();
  scene.Property->SetIntegrationSpaceToData();
  scene.Property->SetClassification(preIntegrated ? 1 : 0);
  scene.Property->SetSilhouette(silhouette);
  scene.Property->AddIsosurface(0.5, 0.5);
  extreme.Apply(scene);
  const std::vector<float> pixels = scene.RenderFloat();
  const std::string name = std::string(extreme.Name) + (preIntegrated ? ", pre-integrated" : ", post") +
    ", silhouette " + std::to_string(silhouette);
  check.That(AreFinite(pixels), name + ": a pixel is not finite");
  const auto range = std::minmax_element(pixels.begin(), pixels.end());
  check.AtLeast(name + ": least opacity", *range.first, 0.0);
  check.AtMost(name + ": largest opacity", *range.second, 1.0 + 1.0e-6);
  check.That(scene.Optics->GetActiveTerms() == "Integration", name + ": the term is not active");
  for (const std::string& text : warnings.Texts)
  {
    check.That(false, name + ": " + text);
  }
}
}

int TestIntegrationExtremes(int, char*[])
{
  Check check;
  for (const Extreme& extreme : Extremes)
  {
    for (const bool preIntegrated : { false, true })
    {
      for (const int silhouette : { vtkOpticsVolumeProperty::SilhouetteOff, vtkOpticsVolumeProperty::Exact,
             vtkOpticsVolumeProperty::Clamped })
      {
        CheckExtreme(check, extreme, preIntegrated, silhouette);
      }
    }
  }
  return check.ExitCode();
}
