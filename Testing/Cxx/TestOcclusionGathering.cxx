// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Final gathering of occlusion: against the cone integral by rays, and what it is left out with.

#include "ConeIntegral.h"
#include "FroxelSweep.h"
#include "OcclusionTesting.h"
#include "Optics.h"
#include "Scene.h"
#include "ShaderText.h"

#include "vtkPlane.h"

namespace
{
// A ridged field of the kind of Marschner and Lobb, whose surface is two voxels of 64 thick. No face of the volume cuts
// it where it is seen: there VTK's first sample stands for more than itself.
double Ridges(double x, double y, double z)
{
  const double ripple = std::cos(12.0 * std::cos(1.5707963 * std::hypot(x, y) / 2.0));
  const double atSides = std::max(std::max(std::abs(x), std::abs(y)) - 1.6, 0.0);
  return 0.5 - 0.6 * (z + 0.1) + 0.12 * ripple - 3.0 * atSides;
}

struct RidgeScene : public OcclusionScene
{
  explicit RidgeScene(bool isPerspective)
    : OcclusionScene(Ridges, 0.0, 16)
  {
    this->Opacity->RemoveAllPoints();
    this->Opacity->AddPoint(0.5, 0.0);
    this->Opacity->AddPoint(0.54, 1.0);
    this->Color->RemoveAllPoints();
    this->Color->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetParallelProjection(isPerspective);
    camera->SetPosition(2.0, -3.0, 4.0);
    isPerspective ? camera->ParallelProjectionOff() : camera->ParallelProjectionOn();
    camera->SetParallelScale(2.0);
    this->Renderer->ResetCameraClippingRange();
    this->Property->OcclusionOn();
  }
};

// The same by the reference, in double.
void CheckReference(Check& check, const reference::Scene& world)
{
  const reference::Occluders things(world, 0.25 * world.grid.SmallestSpacing());
  const auto points = reference::ShownPoints(world, 0.002);
  const auto truth = reference::VisibilityAt(things, points, { 60.0, 32, 1 });
  reference::SweepSettings settings;
  settings.axis = reference::SweepAxis::Pixel;
  settings.own = reference::OwnOpacity::Gathered;
  settings.gatherSamples = 5;
  const reference::SliceFrame frame = reference::FrameOfCamera(world);
  settings.froxels = reference::FroxelsOf(frame, 64, 1.0);
  const auto values = reference::FroxelSweep(things, frame, settings).At(things, points);
  check.AtMost("error in double", reference::CompareVisibility(points, values, truth).mean, 0.03);
}

// Mean absolute error of visibility, each sample by its contribution to the pixel.
double ErrorOf(RidgeScene& scene, const reference::Scene& world, double angle)
{
  const int size = scene.Window->GetSize()[0];
  const reference::Occluders things(world, 0.25 * world.grid.SmallestSpacing());
  const auto points = reference::ShownPoints(world, 0.002);
  const auto truth = reference::VisibilityAt(things, points, { angle, 32, 1 });
  std::vector<double> radiance(std::size_t(1) * size * size, 0.0);
  double opacities = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    radiance[points[i].pixel] += points[i].weight * truth[i];
    opacities += points[i].weight;
  }
  scene.Property->SetOcclusionAngle(angle);
  const std::vector<float> pixels = scene.RenderFloat();
  const std::size_t channels = pixels.size() / radiance.size();
  double sum = 0.0;
  for (std::size_t i = 0; i < radiance.size(); ++i)
  {
    sum += std::abs(pixels[channels * i] - radiance[i]);
  }
  return sum / opacities;
}

void CheckAgainstRays(Check& check)
{
  for (const bool isPerspective : { true, false })
  {
    RidgeScene scene(isPerspective);
    scene.Optics->SetVisibilityGridSize(64);
    scene.Render();
    const int size = scene.Window->GetSize()[0];
    reference::Scene world = reference::SceneFromVTK(scene.Renderer, scene.Volume, size, size);
    world.step *= 0.25; // a sample of the picture stands for all points of its step
    if (isPerspective)
    {
      CheckReference(check, world);
    }
    const std::vector<double> angles =
      isPerspective ? std::vector<double>{ 30.0, 60.0, 80.0 } : std::vector<double>{ 60.0 };
    for (const double angle : angles)
    {
      const std::string name =
        std::string(isPerspective ? "perspective " : "parallel ") + std::to_string(int(angle)) + " degrees";
      scene.Optics->SetVisibilityGatherSamples(5);
      const double gathered = ErrorOf(scene, world, angle);
      // what is asked of the mapper's balanced occlusion
      check.AtMost("error against rays, " + name, gathered, 0.03);
      scene.Optics->SetVisibilityGatherSamples(0);
      const double swept = ErrorOf(scene, world, angle);
      check.That(gathered < swept, "nearer than without, " + name + ": " + std::to_string(swept));
    }
  }
}

// The roof hides the floor from nothing where it is cut away, by a plane that leaves it for the rays' first samples.
void CheckClipping(Check& check)
{
  const double roofBegin = FloorHeight + 0.1;
  const auto roof = [=](double, double, double z) {
    return z < FloorHeight || (z > roofBegin && z < roofBegin + 0.2) ? Dense : 0.0;
  };
  OcclusionScene open(Floor), roofed(roof);
  open.Optics->SetVisibilityGridSize(64); // rays that reach the roof
  roofed.Optics->SetVisibilityGridSize(64);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, 0.0, roofBegin - 0.05);
  plane->SetNormal(0.0, 0.0, -1.0);
  roofed.Mapper->AddClippingPlane(plane);
  check.Near("a roof that is cut away hides nothing", roofed.Visibility(), open.Visibility(), 0.02);
}

// The cone is about the direction to the eye, far above the reach of gathering too: from where the floor is seen aslant,
// at 36 degrees, a roof straight above hides nothing.
void CheckWideView(Check& check)
{
  const auto roof = [](double x, double, double z) {
    return z < FloorHeight ? Dense : (x > 1.15 && z > 0.3 && z < 0.4 ? Glass : 0.0);
  };
  double visibility[2];
  for (const bool isRoofed : { false, true })
  {
    OcclusionScene scene(isRoofed ? Density(roof) : Density(Floor), 0.9);
    scene.Optics->SetVisibilityGridSize(64);
    scene.Property->SetOcclusionAngle(15.0);
    vtkCamera* camera = scene.Renderer->GetActiveCamera();
    camera->ParallelProjectionOff();
    camera->SetPosition(0.0, 0.0, 1.5);
    camera->SetViewAngle(90.0);
    scene.Renderer->ResetCameraClippingRange();
    visibility[isRoofed] = scene.Visibility(12, 0);
  }
  check.Near("a roof beside the way to the eye hides nothing", visibility[1], visibility[0], 0.02);
}

// On a floor that is denser than a step, wherever the samples happen to lie: else it would show rings. Steps are of a
// voxel, and the bound lies half-way between what is seen (.12) and that without the shift to what the eye met (.20).
void CheckRings(Check& check)
{
  OcclusionScene scene(Floor);
  double least = 1.0, largest = 0.0;
  for (int i = 0; i < 8; ++i)
  {
    // of 29 to 31 steps down to the floor, so that its place between two samples goes through all of a step
    scene.Mapper->SetSampleDistance(static_cast<float>(0.9 / (29.0 + 0.25 * i)));
    const double visibility = scene.Visibility();
    least = std::min(least, visibility);
    largest = std::max(largest, visibility);
  }
  check.AtMost("rings on a floor", largest - least, 0.15);
}

// Where opacity is not a function of the scalar alone, and where it is not asked for.
void CheckLeftOut(Check& check)
{
  OcclusionScene scene(Floor);
  scene.Property->OcclusionOn();
  ShaderText text(scene.Mapper);
  const auto gathers = [&] {
    scene.Render();
    scene.Render();
    return text.Text.find("opticsGathered") != std::string::npos;
  };
  check.That(gathers(), "gathers by default");
  scene.Optics->SetVisibilityGatherSamples(0);
  check.That(!gathers(), "not with 0 samples");
  scene.Optics->SetVisibilityGatherSamples(3);
  scene.Optics->SetVisibilityAlgorithmToDisk();
  check.That(!gathers(), "not with a disk");
  scene.Optics->SetVisibilityAlgorithmToDirectionSweep();
  scene.Mapper->CroppingOn();
  check.That(!gathers(), "not with cropping");
  scene.Mapper->CroppingOff();
  scene.Property->SetIntegrationSpaceToData();
  check.That(!gathers(), "not in data space");
  scene.Property->SetIntegrationSpaceToPhysical();
  check.That(gathers(), "again");
}

// Turning keeps lengths and angles, and takes one axis to the other.
void CheckTurning(Check& check)
{
  for (int i = 0; i < 20; ++i)
  {
    const glm::dvec3 axis = glm::normalize(glm::dvec3(std::cos(1.3 * i), std::sin(1.7 * i), -0.2 - 0.1 * i));
    const glm::dvec3 way(std::sin(2.1 * i), std::cos(0.7 * i), -0.5 + 0.05 * i);
    const glm::dvec3 turned = optics::TurnToAxis(way, axis);
    check.Near("length", glm::length(turned), glm::length(way), 1e-14);
    check.Near("angle with the axis", glm::dot(turned, axis), -way.z, 1e-14);
    const glm::dvec3 first = optics::TurnToAxis(glm::dvec3(0.0, 0.0, -1.0), axis);
    check.Near("axis", glm::length(first - axis), 0.0, 1e-14);
  }
}
}

int TestOcclusionGathering(int, char*[])
{
  Check check;
  CheckTurning(check);
  CheckAgainstRays(check);
  CheckClipping(check);
  CheckWideView(check);
  CheckRings(check);
  CheckLeftOut(check);
  return check.ExitCode();
}
