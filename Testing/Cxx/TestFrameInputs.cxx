// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Normals and anisotropy that were computed elsewhere, connected or as arrays of the volume, give the
// picture that the mapper's own do, and nothing is computed. For normals alone the covariance is. What
// does not fit is said once, and the mapper computes.

#include "FrameEvents.h"
#include "TestScene.h"

#include "vtkAlgorithmOutput.h"
#include "vtkAmbientCovarianceFilter.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkSobelNormalFilter.h"

#include <functional>
#include <limits>

namespace
{
// What the mapper's filters make of the scene's volume.
struct Frames
{
  explicit Frames(TestScene& scene, double factor = 1.0)
  {
    this->Normals->SetInputConnection(scene.Source->GetOutputPort());
    this->Normals->SetResolutionFactor(factor);
    this->Anisotropy->SetInputConnection(scene.Source->GetOutputPort());
    this->Anisotropy->SetInputConnection(1, this->Normals->GetOutputPort());
    this->Anisotropy->SetResolutionFactor(factor);
    this->Anisotropy->Update();
  }
  vtkNew<vtkSobelNormalFilter> Normals;
  vtkNew<vtkAmbientCovarianceFilter> Anisotropy;
};

vtkSmartPointer<vtkImageData> Copy(vtkImageData* image)
{
  auto copy = vtkSmartPointer<vtkImageData>::New();
  copy->DeepCopy(image);
  return copy;
}

void Connect(TestScene& scene, vtkImageData* normals, vtkImageData* anisotropy)
{
  scene.Optics->SetNormalsInputData(normals);
  scene.Optics->SetAnisotropyInputData(anisotropy);
}

// Arrays of the volume itself.
void UseArrays(TestScene& scene)
{
  const Frames frames(scene);
  vtkSmartPointer<vtkImageData> image = Copy(scene.Source->GetOutput());
  vtkPointData* normals = frames.Normals->GetOutput()->GetPointData();
  image->GetPointData()->AddArray(normals->GetArray("Normals"));
  image->GetPointData()->AddArray(normals->GetArray("GradientMagnitude"));
  image->GetPointData()->AddArray(
    frames.Anisotropy->GetOutput()->GetPointData()->GetArray("AmbientCovariance"));
  scene.Mapper->SetInputData(image);
}

struct Row
{
  const char* Name;
  std::function<void(TestScene&)> Apply;
};

const Row Right[] = {
  { "connections",
    [](TestScene& scene) {
      // the pipeline goes on living in the mapper
      const Frames frames(scene);
      scene.Optics->SetNormalsInputConnection(frames.Normals->GetOutputPort());
      scene.Optics->SetAnisotropyInputConnection(frames.Anisotropy->GetOutputPort());
    } },
  { "data",
    [](TestScene& scene) {
      const Frames frames(scene);
      Connect(scene, Copy(frames.Normals->GetOutput()), Copy(frames.Anisotropy->GetOutput()));
    } },
  { "arrays of the volume", UseArrays },
};

// Of the right size, but on a grid beside the normals'.
void ConnectElsewhere(TestScene& scene, double x, double spacing)
{
  const Frames frames(scene);
  vtkSmartPointer<vtkImageData> anisotropy = Copy(frames.Anisotropy->GetOutput());
  anisotropy->SetOrigin(
    anisotropy->GetOrigin()[0] + x, anisotropy->GetOrigin()[1], anisotropy->GetOrigin()[2]);
  anisotropy->SetSpacing(
    spacing * anisotropy->GetSpacing()[0], anisotropy->GetSpacing()[1], anisotropy->GetSpacing()[2]);
  Connect(scene, frames.Normals->GetOutput(), anisotropy);
}

const Row Wrong[] = {
  { "grids of different sizes",
    [](TestScene& scene) {
      const Frames frames(scene), half(scene, 0.5);
      Connect(scene, frames.Normals->GetOutput(), half.Anisotropy->GetOutput());
    } },
  { "grids of different origins", [](TestScene& scene) { ConnectElsewhere(scene, 0.1, 1.0); } },
  { "grids of different spacings", [](TestScene& scene) { ConnectElsewhere(scene, 0.0, 1.1); } },
  { "grids of different directions",
    [](TestScene& scene) {
      const Frames frames(scene);
      vtkSmartPointer<vtkImageData> anisotropy = Copy(frames.Anisotropy->GetOutput());
      anisotropy->SetDirectionMatrix(0.0, 1.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 1.0);
      Connect(scene, frames.Normals->GetOutput(), anisotropy);
    } },
  { "no arrays",
    [](TestScene& scene) {
      scene.Source->Update();
      Connect(scene, scene.Source->GetOutput(), scene.Source->GetOutput());
    } },
  { "images without points",
    [](TestScene& scene) {
      vtkNew<vtkImageData> empty;
      Connect(scene, empty, empty);
    } },
  { "normals alone, on a grid beside the volume's",
    [](TestScene& scene) {
      const Frames frames(scene);
      vtkSmartPointer<vtkImageData> normals = Copy(frames.Normals->GetOutput());
      normals->SetOrigin(normals->GetOrigin()[0] + 0.1, normals->GetOrigin()[1], normals->GetOrigin()[2]);
      scene.Optics->SetNormalsInputData(normals);
    } },
  { "normals alone, finer than the volume",
    [](TestScene& scene) {
      const Frames frames(scene);
      vtkSmartPointer<vtkImageData> normals = Copy(frames.Normals->GetOutput());
      normals->SetSpacing(
        0.5 * normals->GetSpacing()[0], 0.5 * normals->GetSpacing()[1], 0.5 * normals->GetSpacing()[2]);
      scene.Optics->SetNormalsInputData(normals);
    } },
  { "an array that is too short",
    [](TestScene& scene) {
      const Frames frames(scene);
      vtkSmartPointer<vtkImageData> normals = Copy(frames.Normals->GetOutput());
      normals->GetPointData()->GetArray("Normals")->SetNumberOfTuples(5);
      Connect(scene, normals, frames.Anisotropy->GetOutput());
    } },
};

std::vector<unsigned char> DrawComputed()
{
  TestScene scene;
  scene.Property->SetReflectanceModelToWard();
  return scene.Render();
}

void CheckRow(Check& check, const Row& row, bool isRight, const std::vector<unsigned char>& expected)
{
  const std::string name = row.Name;
  TestScene scene;
  Warnings warnings(scene.Optics);
  FrameEvents events(scene.Optics);
  scene.Property->SetReflectanceModelToWard();
  row.Apply(scene);
  check.That(scene.Render() == expected, name + ": the picture differs from the computed one");
  scene.Renderer->GetActiveCamera()->Azimuth(1.0);
  scene.Render();
  const std::size_t messages = isRight ? 0 : 1;
  check.That(
    events.Starts == (isRight ? 0 : 1), name + ": computed " + std::to_string(events.Starts) + " times");
  check.That(
    warnings.Texts.size() == messages, name + ": said " + std::to_string(warnings.Texts.size()) + " times");
  check.That(scene.Optics->GetActiveTerms() == "Reflectance", name + ": the term is not active");

  Connect(scene, nullptr, nullptr);
  scene.Renderer->GetActiveCamera()->Azimuth(-1.0);
  check.That(LargestDifference(scene.Render(), expected) <= 1, name + ": disconnected, the picture differs");
}

// By 90 degrees about z.
void Turn(vtkImageData* normals)
{
  vtkDataArray* array = normals->GetPointData()->GetArray("Normals");
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    const double* normal = array->GetTuple3(i);
    array->SetTuple3(i, -normal[1], normal[0], normal[2]);
  }
  array->Modified();
}

// The covariance of normals that come alone is that of these normals, which are turned here, so that
// the mapper's own would draw another picture.
void CheckNormalsAlone(Check& check, double factor, const std::vector<unsigned char>& computed)
{
  const std::string name = "normals alone at factor " + std::to_string(factor);
  TestScene scene;
  Warnings warnings(scene.Optics);
  scene.Property->SetReflectanceModelToWard();
  const Frames frames(scene, factor);
  vtkSmartPointer<vtkImageData> normals = Copy(frames.Normals->GetOutput());
  frames.Anisotropy->SetNormalsData(normals);
  const auto drawBoth = [&] {
    frames.Anisotropy->Update();
    Connect(scene, normals, frames.Anisotropy->GetOutput());
    return scene.Render();
  };
  const auto drawAlone = [&] {
    Connect(scene, normals, nullptr);
    return scene.Render();
  };
  Turn(normals);
  const std::vector<unsigned char> turned = drawBoth();
  // beyond rounding, which makes 1
  check.AtLeast(name + ": difference of the turned normals", LargestDifference(turned, computed), 5);
  FrameEvents events(scene.Optics);
  check.That(drawAlone() == turned, name + ": the picture is not that of the normals' covariance");
  scene.Renderer->GetActiveCamera()->Azimuth(1.0);
  scene.Render();
  scene.Renderer->GetActiveCamera()->Azimuth(-1.0);
  check.That(events.Starts == 1, name + ": computed " + std::to_string(events.Starts) + " times, not once");

  Turn(normals);
  const std::vector<unsigned char> changed = drawAlone();
  check.That(events.Starts == 2, name + ": changed normals are not noticed");
  check.That(
    LargestDifference(drawBoth(), changed) <= 1, name + ": changed, the picture is not the normals'");
  check.That(warnings.Texts.empty(), name + ": there is something to say");
}

// Vectors that are not unit and numbers that are none must not reach a pixel.
void CheckHostile(Check& check, int bits)
{
  TestScene scene;
  scene.Property->SetReflectanceModelToWard();
  scene.Optics->SetFramePrecision(bits);
  const Frames frames(scene);
  vtkSmartPointer<vtkImageData> normals = Copy(frames.Normals->GetOutput());
  vtkSmartPointer<vtkImageData> anisotropy = Copy(frames.Anisotropy->GetOutput());
  const float hostile[] = { std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
    -std::numeric_limits<float>::infinity(), 1.0e30F, -7.0F };
  int next = 0;
  for (vtkIdType i = 0; i < normals->GetNumberOfPoints(); i += 7)
  {
    const float value = hostile[next++ % 5];
    normals->GetPointData()->GetArray("Normals")->SetComponent(i, next % 3, value);
    normals->GetPointData()->GetArray("GradientMagnitude")->SetComponent(i, 0, value);
    anisotropy->GetPointData()->GetArray("AmbientCovariance")->SetComponent(i, next % 3, value);
  }
  Connect(scene, normals, anisotropy);
  const std::vector<float> pixels = scene.RenderFloat();
  const std::string name = "hostile frames of " + std::to_string(bits) + " bits";
  check.That(AreFinite(pixels), name + ": a pixel is not finite");
  check.That(*std::min_element(pixels.begin(), pixels.end()) >= 0.0F, name + ": a pixel is below 0");
}
}

int TestFrameInputs(int, char*[])
{
  Check check;
  const std::vector<unsigned char> expected = DrawComputed();
  for (const Row& row : Right)
  {
    CheckRow(check, row, true, expected);
  }
  for (const Row& row : Wrong)
  {
    CheckRow(check, row, false, expected);
  }
  CheckNormalsAlone(check, 1.0, expected);
  CheckNormalsAlone(check, 0.5, expected);
  for (const int bits : { 8, 16, 32 })
  {
    CheckHostile(check, bits);
  }
  return check.ExitCode();
}
