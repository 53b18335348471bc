// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Extremes of data, parameters and light: no crash, no OpenGL error, and on a float target, which
// hides nothing, every pixel finite and in range. With the argument --lighting under a lighting transfer
// function of a light scale of 1e4.

#include "ResizedTable.h"
#include "ScenePixels.h"
#include "TestScene.h"

#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkLight.h"
#include "vtkLongLongArray.h"
#include "vtkOpenGLError.h"
#include "vtkPointData.h"

#include <functional>
#include <limits>

namespace
{
using Setting = std::function<void(TestScene&)>;

bool UsesLighting = false;

const int Models[] = { vtkOpticsVolumeProperty::VTK, vtkOpticsVolumeProperty::None,
  vtkOpticsVolumeProperty::BlinnPhong, vtkOpticsVolumeProperty::Ward, vtkOpticsVolumeProperty::Lafortune };

void ShowAll(TestScene& scene)
{
  scene.Renderer->ResetCamera();
}

void CheckScene(
  Check& check, const std::string& name, const Setting& setting, const Setting& placeCamera = ShowAll)
{
  for (const int model : Models)
  {
    // VTK's model alone is no term's; TestShaderValidity has every model under a lighting transfer function
    const bool isDrawn =
      UsesLighting ? model <= vtkOpticsVolumeProperty::None : model > vtkOpticsVolumeProperty::VTK;
    if (!isDrawn)
    {
      continue;
    }
    TestScene scene;
    scene.Window->SetSize(60, 60);
    scene.Property->SetSpecular(1.0);
    scene.Property->SetReflectanceModel(model);
    if (UsesLighting)
    {
      LightEverywhere(scene, 1.0, 1.0, 1.0);
      scene.Property->SetLightScale(1.0e4);
    }
    setting(scene);
    placeCamera(scene);
    const std::string what = name + ", " + scene.Property->GetReflectanceModelAsString();
    scene.Window->Render();
    check.That(glGetError() == GL_NO_ERROR, what + ": OpenGL reports an error");
    const std::vector<float> pixels = scene.RenderFloat();
    const std::string fault = FaultOfPixels(pixels);
    check.That(fault.empty(), what + ": " + fault);
    const char* terms = UsesLighting ? "Reflectance,LightingTransferFunction" : "Reflectance";
    check.That(scene.Optics->GetActiveTerms() == terms, what + ": a term is not active");
  }
}

void SetGlossiness(TestScene& scene, double glossiness)
{
  for (const int model : { vtkOpticsVolumeProperty::BlinnPhong, vtkOpticsVolumeProperty::Lafortune })
  {
    scene.Property->SetGlossiness(model, glossiness);
  }
}

void SetScale(TestScene& scene, double scale)
{
  scene.Property->SetAnisotropyScale(vtkOpticsVolumeProperty::Ward, scale);
  scene.Property->SetAnisotropyScale(vtkOpticsVolumeProperty::Lafortune, scale);
}

// The field's scalars as another type and scale, with the transfer functions carried along.
template <typename Array>
void Rescale(TestScene& scene, double factor, double offset)
{
  scene.Source->Update();
  vtkNew<vtkImageData> image;
  image->CopyStructure(scene.Source->GetOutput());
  vtkDataArray* field = scene.Source->GetOutput()->GetPointData()->GetScalars();
  vtkNew<Array> scalars;
  scalars->SetNumberOfTuples(field->GetNumberOfTuples());
  for (vtkIdType i = 0; i < field->GetNumberOfTuples(); ++i)
  {
    scalars->SetComponent(i, 0, field->GetComponent(i, 0) * factor + offset);
  }
  image->GetPointData()->SetScalars(scalars);
  scene.Mapper->SetInputData(image);
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(0.4 * factor + offset, 0.0);
  scene.Opacity->AddPoint(0.6 * factor + offset, 0.3);
  scene.Color->RemoveAllPoints();
  scene.Color->AddRGBPoint(offset, 0.2, 0.3, 0.8);
  scene.Color->AddRGBPoint(factor + offset, 0.9, 0.7, 0.5);
}

void Poison(TestScene& scene, float value)
{
  scene.Source->Update();
  vtkNew<vtkImageData> image;
  image->DeepCopy(scene.Source->GetOutput());
  auto* scalars = vtkFloatArray::SafeDownCast(image->GetPointData()->GetScalars());
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); i += 97)
  {
    scalars->SetValue(i, value);
  }
  scene.Mapper->SetInputData(image);
}

// Every point, or only those above the middle plane.
void Blank(TestScene& scene, bool all)
{
  scene.Source->Update();
  vtkNew<vtkImageData> image;
  image->DeepCopy(scene.Source->GetOutput());
  image->AllocatePointGhostArray();
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    if (all || image->GetPoint(i)[2] > 0.0)
    {
      image->GetPointGhostArray()->SetValue(i, vtkDataSetAttributes::HIDDENPOINT);
    }
  }
  scene.Mapper->SetInputData(image);
}

void MakeHomogeneous(TestScene& scene)
{
  scene.Source->SetFieldToNoisyHomogeneous();
  scene.Source->SetNoiseAmplitude(0.0);
}

void PlaceCamera(TestScene& scene, const double position[3])
{
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(position);
  camera->SetFocalPoint(position[0], position[1] + 1.0, position[2]);
  scene.Renderer->ResetCameraClippingRange();
}

// The camera stands exactly on a point of the grid.
void PlaceCameraOnVoxel(TestScene& scene)
{
  scene.Source->Update();
  vtkImageData* image = scene.Source->GetOutput();
  PlaceCamera(scene, image->GetPoint(image->GetNumberOfPoints() / 2 + 5));
}

void SetBounds(TestScene& scene, double x, double y, double z)
{
  scene.Source->SetBounds(-x, x, -y, y, -z, z);
  const double smallest = std::min({ x, y, z });
  scene.Mapper->SetSampleDistance(static_cast<float>(0.05 * std::max({ x, y, z })));
  scene.Property->SetScalarOpacityUnitDistance(0.05 * smallest);
  scene.Source->SetSemiAxes(0.5 * x, 0.5 * y, 0.8 * z);
}

void LightFrom(TestScene& scene, double x, double y, double z)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToCameraLight();
  light->SetPosition(x, y, z);
  scene.Renderer->SetAutomaticLightCreation(false);
  scene.Renderer->AddLight(light);
}

void CheckParameters(Check& check)
{
  CheckScene(check, "exponent 0.01", [](TestScene& s) { SetGlossiness(s, 0.01); });
  CheckScene(check, "exponent 1e5", [](TestScene& s) { SetGlossiness(s, 1.0e5); });
  CheckScene(check, "roughness 1e-4",
    [](TestScene& s) { s.Property->SetGlossiness(vtkOpticsVolumeProperty::Ward, 1.0e-4); });
  CheckScene(check, "roughness 1",
    [](TestScene& s) { s.Property->SetGlossiness(vtkOpticsVolumeProperty::Ward, 1.0); });
  CheckScene(check, "anisotropy scale 0", [](TestScene& s) { SetScale(s, 0.0); });
  CheckScene(check, "anisotropy scale 1e4", [](TestScene& s) { SetScale(s, 1.0e4); });
  CheckScene(check, "forward scattering", [](TestScene& s) { s.Property->SetScatteringAnisotropy(1.0F); });
  CheckScene(check, "backward scattering", [](TestScene& s) { s.Property->SetScatteringAnisotropy(-1.0F); });
  CheckScene(check, "highlights everywhere", [](TestScene& s) { s.Property->SpecularFromExtinctionOff(); });
  CheckScene(check, "opaque at once", [](TestScene& s) {
    s.Opacity->RemoveAllPoints();
    s.Opacity->AddPoint(0.4999, 0.0);
    s.Opacity->AddPoint(0.5, 1.0);
  });
}

void CheckLighting(Check& check)
{
  CheckScene(check, "no gradient step", [](TestScene& s) { s.Property->SetGradientStepLength(0.0); });
  CheckScene(check, "a step of 1e4 voxels", [](TestScene& s) { s.Property->SetGradientStepLength(1.0e4); });
  CheckScene(check, "a table of one entry", [](TestScene& s) { s.Optics->SetLightingTableSize(1); });
  CheckScene(check, "hybrid normals", [](TestScene& s) { s.Property->HybridNormalsOn(); });
  CheckScene(check, "hybrid normals of a constant opacity", [](TestScene& s) {
    s.Property->HybridNormalsOn();
    s.Opacity->RemoveAllPoints();
    s.Opacity->AddPoint(0.0, 0.1);
  });
  CheckScene(
    check, "extrapolated samples", [](TestScene& s) { s.Optics->SetLightingSamplesToExtrapolated(); });
  CheckScene(check, "extrapolated samples of a long step", [](TestScene& s) {
    s.Optics->SetLightingSamplesToExtrapolated();
    s.Property->SetGradientStepLength(1.0e4);
  });
  CheckScene(check, "stored gradient", [](TestScene& s) { s.Optics->SetScalarGradientToStored(); });
  CheckScene(check, "a light scale of 1e6", [](TestScene& s) { s.Property->SetLightScale(1.0e6); });
  CheckScene(check, "no light", [](TestScene& s) { s.Property->SetLightScale(0.0); });
  CheckScene(check, "an empty function",
    [](TestScene& s) { s.Property->GetLightingTransferFunction()->RemoveAllBoundaries(); });
}

void CheckData(Check& check)
{
  CheckScene(check, "constant volume", MakeHomogeneous);
  CheckScene(check, "spacing 1e-6", [](TestScene& s) { SetBounds(s, 1.6e-5, 1.6e-5, 1.6e-5); });
  CheckScene(check, "spacing 1e6", [](TestScene& s) { SetBounds(s, 1.6e7, 1.6e7, 1.6e7); });
  CheckScene(check, "spacing 1:100", [](TestScene& s) { SetBounds(s, 1.0, 1.0, 100.0); });
  CheckScene(check, "scalars of 1e-30", [](TestScene& s) { Rescale<vtkFloatArray>(s, 1.0e-30, 0.0); });
  CheckScene(check, "scalars of 1e30", [](TestScene& s) { Rescale<vtkFloatArray>(s, 1.0e30, 0.0); });
  CheckScene(check, "int64", [](TestScene& s) { Rescale<vtkLongLongArray>(s, 1.0e15, 1.0e12); });
  CheckScene(check, "NaN", [](TestScene& s) { Poison(s, std::numeric_limits<float>::quiet_NaN()); });
  CheckScene(check, "infinity", [](TestScene& s) { Poison(s, std::numeric_limits<float>::infinity()); });
  CheckScene(
    check, "negative infinity", [](TestScene& s) { Poison(s, -std::numeric_limits<float>::infinity()); });
  CheckScene(check, "half of the points blanked", [](TestScene& s) { Blank(s, false); });
  CheckScene(check, "a 2D transfer function of few rows", UseTable2D);
  CheckScene(check, "every point blanked", [](TestScene& s) { Blank(s, true); });
}

void CheckCamera(Check& check)
{
  const Setting none = [](TestScene&) {};
  const Setting centre = [](TestScene& s) {
    const double origin[3] = {};
    PlaceCamera(s, origin);
  };
  CheckScene(check, "camera in a homogeneous region", MakeHomogeneous, centre);
  CheckScene(check, "camera inside", none, centre);
  CheckScene(check, "camera on a voxel", none, PlaceCameraOnVoxel);
  CheckScene(check, "camera on the surface of the volume", none, [](TestScene& s) {
    const double position[3] = { 0.0, -1.0, 0.0 };
    PlaceCamera(s, position);
  });
}

void CheckLight(Check& check)
{
  CheckScene(check, "light behind", [](TestScene& s) { LightFrom(s, 0.0, 0.0, -1.0); });
  CheckScene(check, "light at grazing incidence", [](TestScene& s) { LightFrom(s, 1.0, 0.0, 1.0e-7); });
  CheckScene(check, "light of no direction", [](TestScene& s) { LightFrom(s, 0.0, 0.0, 0.0); });
  CheckScene(check, "light inside the volume", [](TestScene& s) {
    vtkNew<vtkLight> light;
    light->SetPositional(true);
    light->SetPosition(0.1, 0.1, 0.1);
    light->SetAttenuationValues(0.0, 0.0, 1.0);
    s.Renderer->SetAutomaticLightCreation(false);
    s.Renderer->AddLight(light);
  });
}
}

int TestReflectanceExtremes(int argc, char* argv[])
{
  UsesLighting = std::any_of(argv, argv + argc, [](char* word) { return std::string(word) == "--lighting"; });
  Check check;
  if (UsesLighting)
  {
    CheckLighting(check);
    CheckData(check);
    return check.ExitCode();
  }
  CheckParameters(check);
  CheckData(check);
  CheckCamera(check);
  CheckLight(check);
  return check.ExitCode();
}
