// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// What lighting transfer functions are for: light on the chosen boundary alone, none on noise, hybrid
// normals that light what faces the light, the same of every type of scalars.

#include "Optics.h"
#include "SmallScene.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkLight.h"
#include "vtkPointData.h"
#include "vtkShortArray.h"
#include "vtkSignedCharArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnsignedIntArray.h"
#include "vtkUnsignedShortArray.h"

#include <vtksys/SystemTools.hxx>

#include <functional>
#include <random>

namespace
{
const int Points = 40;
using Field = std::function<double(double radius)>;

// A function of the radius in [-1, 1]^3, rounded to integers, so that every type can hold it.
template <typename Array = vtkFloatArray>
vtkSmartPointer<vtkImageData> Ball(const Field& field)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(Points, Points, Points);
  const double spacing = 2.0 / (Points - 1);
  image->SetSpacing(spacing, spacing, spacing);
  image->SetOrigin(-1.0, -1.0, -1.0);
  vtkNew<Array> scalars;
  scalars->SetNumberOfTuples(image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double* p = image->GetPoint(i);
    const double radius = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    scalars->SetComponent(i, 0, std::round(field(radius)));
  }
  image->GetPointData()->SetScalars(scalars);
  return image;
}

// 0 outside of radius 0.8, 50 within, 100 within 0.4; boundaries are two to three voxels wide.
double TwoMaterials(double radius)
{
  const auto step = [radius](double edge) { return 0.5 - 0.5 * std::tanh((radius - edge) / 0.05); };
  return 50.0 * step(0.8) + 50.0 * step(0.4);
}

// White, thin and the same everywhere, on black: what is seen is light.
void ShowThinly(TestScene& scene, vtkImageData* image)
{
  scene.Mapper->SetInputData(image);
  scene.Mapper->SetSampleDistance(0.02F);
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(0.0, 0.02);
  scene.Color->RemoveAllPoints();
  scene.Color->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
  scene.Renderer->SetBackground(0.0, 0.0, 0.0);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.Renderer->GetActiveCamera()->SetPosition(0.0, -5.0, 0.0);
  scene.Renderer->GetActiveCamera()->SetParallelScale(1.0);
  scene.Renderer->ResetCameraClippingRange();
}

void LightBoundary(TestScene& scene, double lowA, double highA, double lowB, double highB, double ambient,
  double diffuse, double specular)
{
  vtkNew<vtkLightingTransferFunction> function;
  const double a[2] = { lowA, highA }, b[2] = { lowB, highB };
  function->AddBoundary(a, b, ambient, diffuse, specular);
  scene.Property->SetLightingTransferFunction(function);
}

double Energy(const std::vector<float>& pixels)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < pixels.size(); ++i)
  {
    sum += i % 4 < 3 ? pixels[i] : 0.0;
  }
  return sum;
}

// Light in the picture between two radii around its centre.
double EnergyBetween(const std::vector<float>& pixels, double low, double high)
{
  const int size = static_cast<int>(std::lround(std::sqrt(pixels.size() / 4.0)));
  double sum = 0.0;
  for (int y = 0; y < size; ++y)
  {
    for (int x = 0; x < size; ++x)
    {
      const double radius = std::hypot(2.0 * (x + 0.5) / size - 1.0, 2.0 * (y + 0.5) / size - 1.0);
      sum += radius >= low && radius < high ? pixels[4 * (y * size + x)] : 0.0F;
    }
  }
  return sum;
}

// The sphere within is lit, or the one around it, and nothing else. Two voxels are 0.1.
void CheckBoundary(Check& check)
{
  SmallScene scene;
  ShowThinly(scene, Ball(TwoMaterials));
  LightBoundary(scene, 40.0, 65.0, 85.0, 110.0, 1.0, 0.0, 0.0);
  const std::vector<float> within = scene.RenderFloat();
  check.AtLeast("light on the inner boundary", EnergyBetween(within, 0.0, 0.5), 1.0);
  check.Near("light outside of the inner boundary", EnergyBetween(within, 0.55, 2.0), 0.0, 0.0);
  LightBoundary(scene, -10.0, 15.0, 35.0, 60.0, 1.0, 0.0, 0.0);
  const std::vector<float> around = scene.RenderFloat();
  check.AtLeast("light on the outer boundary", EnergyBetween(around, 0.6, 0.9), 1.0);
  check.Near("light outside of the outer boundary", EnergyBetween(around, 0.95, 2.0), 0.0, 0.0);
  LightBoundary(scene, 0.0, 10.0, 90.0, 100.0, 1.0, 0.0, 0.0);
  check.Near("light on a boundary that is not there", Energy(scene.RenderFloat()), 0.0, 0.0);
}

// A noisy ball in air: uniform light is on its noise, a boundary of air and ball only on its surface.
void CheckNoise(Check& check)
{
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0.0, 4.0);
  SmallScene scene;
  ShowThinly(scene, Ball([&](double radius) { return (radius < 0.8 ? 90.0 : 10.0) + noise(random); }));
  LightBoundary(scene, -1.0e9, 1.0e9, -1.0e9, 1.0e9, 0.0, 0.0, 1.0);
  const double uniform = Energy(scene.RenderFloat());
  LightBoundary(scene, -20.0, 40.0, 60.0, 120.0, 0.0, 0.0, 1.0);
  const std::vector<float> chosen = scene.RenderFloat();
  std::cout << "noise: uniform light " << uniform << ", on the boundary " << Energy(chosen) << "\n";
  check.AtLeast("light on the boundary", Energy(chosen), 1.0);
  check.AtMost("light on the noise", Energy(chosen), uniform / 10.0);
}

// The side of the light by the difference of densities: no jump, and 1 where there is none.
void CheckHybridSide(Check& check)
{
  check.Near("side of growing density", optics::HybridSide(0.3, 0.1), 1.0, 0.0);
  check.Near("side of equal density", optics::HybridSide(0.0, 0.1), 1.0, 0.0);
  check.Near("side in the middle of the change", optics::HybridSide(-0.05, 0.1), 0.0, Rounding);
  check.Near("side at the end of the change", optics::HybridSide(-0.1, 0.1), -1.0, Rounding);
  check.Near("side of falling density", optics::HybridSide(-1.0, 0.1), -1.0, 0.0);
}

// A ball in a denser medium that is clear: gradients point out of it, light must fall on its front.
double LitBall(Check& check, bool isTwoSided, bool isHybrid, double opacity)
{
  SmallScene scene;
  ShowThinly(scene, Ball([](double radius) { return 50.0 + 50.0 * std::tanh((radius - 0.6) / 0.05); }));
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(45.0, opacity);
  scene.Opacity->AddPoint(55.0, 0.0);
  LightBoundary(scene, -1.0e9, 1.0e9, -1.0e9, 1.0e9, 0.0, 1.0, 0.0);
  scene.Renderer->SetTwoSidedLighting(isTwoSided);
  scene.Property->SetHybridNormals(isHybrid);
  const double energy = Energy(scene.RenderFloat());
  check.That(scene.Optics->GetActiveTerms() == "Reflectance,LightingTransferFunction", "no active term");
  return energy;
}

void CheckHybridNormals(Check& check)
{
  const double both = LitBall(check, true, false, 0.9);
  const double oneSided = LitBall(check, false, false, 0.9);
  const double hybrid = LitBall(check, true, true, 0.9);
  std::cout << "opaque: two-sided " << both << ", one-sided " << oneSided << ", hybrid " << hybrid << "\n";
  // the far side is hidden; within the ball opacity is constant, and light fades
  check.AtMost("one-sided light on the front of a ball of low scalars", oneSided, 0.05 * both);
  check.AtLeast("hybrid light on the front of a ball of low scalars", hybrid, 0.8 * both);
  const double bothThrough = LitBall(check, true, false, 0.002);
  const double through = LitBall(check, true, true, 0.002);
  std::cout << "translucent: two-sided " << bothThrough << ", hybrid " << through << "\n";
  check.Near("hybrid light on a translucent ball, a half", through / bothThrough, 0.5, 0.1);
}

void LightSoftly(TestScene& scene)
{
  LightBoundary(scene, 40.0, 65.0, 85.0, 110.0, 0.3, 1.0, 0.5);
  scene.Property->GetLightingTransferFunction()->SetSoftness(0, 10.0);
  scene.Property->SetLightScale(5.0);
}

template <typename Array>
void CheckType(Check& check, const std::vector<unsigned char>& expected)
{
  vtkNew<Array> array;
  SmallScene scene;
  ShowThinly(scene, Ball<Array>(TwoMaterials));
  LightSoftly(scene);
  const int difference = LargestDifference(expected, scene.Render());
  std::cout << array->GetClassName() << ": differs by " << difference << "\n";
  check.That(
    difference <= 1, std::string(array->GetClassName()) + ": differs by " + std::to_string(difference));
}

void CheckTypes(Check& check)
{
  SmallScene scene;
  ShowThinly(scene, Ball(TwoMaterials));
  LightSoftly(scene);
  const std::vector<unsigned char> expected = scene.Render();
  check.AtLeast("light", *std::max_element(expected.begin(), expected.end()), 50);
  CheckType<vtkSignedCharArray>(check, expected);
  CheckType<vtkUnsignedCharArray>(check, expected);
  CheckType<vtkShortArray>(check, expected);
  CheckType<vtkUnsignedShortArray>(check, expected);
  CheckType<vtkIntArray>(check, expected);
  CheckType<vtkUnsignedIntArray>(check, expected);
  CheckType<vtkDoubleArray>(check, expected);
}
}

int TestLightingTerm(int, char*[])
{
  // Mesa's software rasteriser interpolates a texture of 8 bits to 8 bits, here a hundredth of the range, a
  // tenth of an edge: pictures then differ by up to 12 of 255. With this it interpolates floats.
  vtksys::SystemTools::PutEnv("GALLIVM_PERF=no_aos_sampling");
  Check check;
  CheckBoundary(check);
  CheckNoise(check);
  CheckHybridSide(check);
  CheckHybridNormals(check);
  CheckTypes(check);
  return check.ExitCode();
}
