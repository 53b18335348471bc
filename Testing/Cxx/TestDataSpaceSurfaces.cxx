// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// An isosurface of opacity a has opacity a on every ray that crosses it once, whatever the gradient, the
// step, the world's scale and the place of the crossing on the ray. Of gradients, floats in the voxels and
// their linear interpolation hold what is tested: within one volume from 1e-6 of the range in two voxels to
// the range in one, where the small gradients have small scalars, as around a charge.

#include "TestScene.h"

#include "vtkFloatArray.h"
#include "vtkPointData.h"

namespace
{
const double Bound = 1.0 / 255.0;

const int Size = 24;
const double StepsOfVoxels = Size - 1;

const double DistanceOfCharge = 0.05 / StepsOfVoxels;

// The scalar changes along y, within [0, 1], as a power: above 0 of the way from the face, below 0 of the distance
// to a charge a twentieth of a voxel in front of it.
double ScalarAt(int row, double power)
{
  const double y = row / StepsOfVoxels;
  return std::pow(power < 0.0 ? y / DistanceOfCharge + 1.0 : y, power);
}

void UseField(TestScene& scene, double power, double worldScale)
{
  vtkNew<vtkImageData> image;
  const double spacing = worldScale / StepsOfVoxels;
  image->SetDimensions(Size, Size, Size);
  image->SetSpacing(spacing, spacing, spacing);
  image->SetOrigin(-0.5 * worldScale, -0.5 * worldScale, -0.5 * worldScale);
  vtkNew<vtkFloatArray> values;
  values->SetNumberOfTuples(image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    values->SetValue(i, static_cast<float>(ScalarAt(static_cast<int>(i / Size % Size), power)));
  }
  image->GetPointData()->SetScalars(values);
  scene.Mapper->SetInputData(image);
}

struct Case
{
  double Value;
  double Opacity;
  double StepInVoxels;
  double Power;
  double WorldScale;
};

std::string NameOf(const Case& a)
{
  return "value " + std::to_string(a.Value) + ", opacity " + std::to_string(a.Opacity) + ", step " +
    std::to_string(a.StepInVoxels) + ", power " + std::to_string(a.Power) + ", scale " +
    std::to_string(a.WorldScale);
}

void LookAlongY(TestScene& scene, double worldScale)
{
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(0.4 * worldScale, -2.5 * worldScale, 0.3 * worldScale);
  camera->SetViewAngle(12.0); // within the face
  scene.Renderer->ResetCameraClippingRange();
}

void CheckCase(Check& check, const Case& tested, bool preIntegrated)
{
  TestScene scene;
  scene.Window->SetSize(40, 40);
  UseField(scene, tested.Power, tested.WorldScale);
  LookAlongY(scene, tested.WorldScale);
  scene.Renderer->SetBackground(0.0, 0.0, 0.0);
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(0.0, 0.0);
  scene.Opacity->AddPoint(1.0, 0.0); // transparent but for the surface
  scene.Property->ShadeOff();
  scene.Property->SetIntegrationSpaceToData();
  scene.Property->SetClassification(preIntegrated ? 1 : 0);
  scene.Property->AddIsosurface(tested.Value, 1.0, 0.5, 0.25, tested.Opacity);
  scene.Mapper->SetSampleDistance(
    static_cast<float>(tested.StepInVoxels * tested.WorldScale / StepsOfVoxels));
  const std::vector<float> pixels = scene.RenderFloat();
  double least = 2.0;
  double largest = -1.0;
  for (std::size_t i = 0; i < pixels.size(); i += 4)
  {
    least = std::min<double>(least, pixels[i]);
    largest = std::max<double>(largest, pixels[i]);
  }
  check.Near(NameOf(tested) + ": least", least, tested.Opacity, Bound);
  check.Near(NameOf(tested) + ": largest", largest, tested.Opacity, Bound);
}

// The field of an inverse square, a surface in the middle of some of its voxels.
void CheckGradients(Check& check, const Case& usual, bool preIntegrated)
{
  std::vector<double> gradients;
  for (const int row : { 0, 1, 4, 11, 22 })
  {
    Case tested = usual;
    tested.Power = -2.0;
    const double front = ScalarAt(row, tested.Power);
    const double back = ScalarAt(row + 1, tested.Power);
    tested.Value = 0.5 * (front + back);
    gradients.push_back(front - back);
    for (const double step : { 0.25, 1.0, 4.0 })
    {
      tested.StepInVoxels = step;
      CheckCase(check, tested, preIntegrated);
    }
  }
  check.AtLeast("ratio of the gradients", gradients.front() / gradients.back(), 1.0e6);
}
}

int TestDataSpaceSurfaces(int, char*[])
{
  Check check;
  const Case usual = { 0.5, 0.6, 1.0, 1.0, 1.0 };
  for (const bool preIntegrated : { false, true })
  {
    // 0.001 and 0.999 lie in the first and the last partial segment
    for (const double value : { 0.001, 0.02, 0.5, 0.98, 0.999 })
    {
      for (const double step : { 0.25, 1.0, 4.0 })
      {
        Case tested = usual;
        tested.Value = value;
        tested.StepInVoxels = step;
        CheckCase(check, tested, preIntegrated);
      }
    }
    for (const double opacity : { 0.0, 0.1, 1.0 })
    {
      Case tested = usual;
      tested.Opacity = opacity;
      CheckCase(check, tested, preIntegrated);
    }
    for (const double scale : { 1.0e-6, 1.0e6 })
    {
      Case tested = usual;
      tested.WorldScale = scale;
      CheckCase(check, tested, preIntegrated);
    }
    CheckGradients(check, usual, preIntegrated);
  }
  return check.ExitCode();
}
