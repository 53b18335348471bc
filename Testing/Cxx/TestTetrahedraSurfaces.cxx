// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Isosurfaces and silhouettes on tetrahedra, by projection and by VTK's ray caster: an isosurface of
// opacity a shows a wherever a ray crosses it once, and by eq. 15 what its angle makes of a.

#include "TetrahedraScene.h"

#include <algorithm>

namespace
{
const int Size = 64;

// A code of 8 bits; the ray caster rounds down.
const double ByteTolerance = 1.0 / 255.0;

using Kind = TetrahedraScene::Kind;

std::string Name(Kind kind)
{
  return kind == TetrahedraScene::Projected ? "projected, " : "ray caster, ";
}

// The largest difference from one opacity among the pixels that the grid surely covers.
double WorstPixel(const std::vector<unsigned char>& pixels, double expected)
{
  double worst = 0.0;
  for (int y = 2; y < Size - 2; ++y)
  {
    for (int x = 2; x < Size - 2; ++x)
    {
      worst = std::max(worst, std::abs(pixels[3 * (y * Size + x)] / 255.0 - expected));
    }
  }
  return worst;
}

void AddSurface(TetrahedraScene& scene, double value, double opacity)
{
  scene.Property->AddIsosurface(value, 1.0, 1.0, 1.0, opacity);
}

// Every ray crosses once, at gradients that span 1e6 from ray to ray and along them.
void TestOpacityOfSurface(Check& check, Kind kind)
{
  const Function steep = [](double x, double, double z) { return std::exp(7.0 * z + 7.0 * x); };
  for (double opacity : { 0.05, 0.3, 0.5, 0.98, 1.0 })
  {
    for (double value : { 0.02, 1.0, 30.0 })
    {
      Grid grid = MakeBox(8, [&](double x, double y, double z) { return steep(0.3 * x * y, y, z); });
      TetrahedraScene scene(kind, grid, Size);
      AddSurface(scene, value, opacity);
      const std::string name = Name(kind) + "opacity " + std::to_string(opacity);
      check.AtMost(name + " at " + std::to_string(value), WorstPixel(scene.Render(), opacity), ByteTolerance);
    }
  }
}

// A whole layer of points and faces has the isovalue; scalars of 1e-30 and 1e30.
void TestSurfaceInFaces(Check& check, Kind kind)
{
  for (double range : { 1e-30, 1.0, 1e30 })
  {
    Grid grid = MakeBox(8, [range](double, double, double z) { return range * z; });
    for (bool isParallel : { true, false })
    {
      TetrahedraScene scene(kind, grid, Size);
      scene.Renderer->GetActiveCamera()->SetParallelProjection(isParallel);
      scene.Renderer->GetActiveCamera()->SetViewAngle(20.0);
      AddSurface(scene, 0.0, 0.4);
      AddSurface(scene, 0.25 * range, 0.5);
      const std::string name = Name(kind) + "range " + std::to_string(std::log10(range));
      check.AtMost(name + (isParallel ? ", parallel" : ", perspective"),
        WorstPixel(scene.Render(), 1.0 - 0.6 * 0.5), ByteTolerance);
    }
  }
}

// A plane at an angle. Steeper than the box's corners it would leave pixels without a crossing.
void TestSilhouettes(Check& check, Kind kind)
{
  const double opacity = 0.3;
  for (double cosine : { 1.0, 0.8, 0.6 })
  {
    const double sine = std::sqrt(1.0 - cosine * cosine);
    const Function field = [=](double x, double, double z) { return sine * 0.5 * x + cosine * z; };
    const double angled = cosine / std::hypot(cosine, 0.5 * sine);
    Grid grid = MakeBox(4, field);
    const std::pair<int, double> modes[] = { { vtkOpticsVolumeProperty::SilhouetteOff, opacity },
      { vtkOpticsVolumeProperty::Exact, 1.0 - std::pow(1.0 - opacity, 1.0 / angled) },
      { vtkOpticsVolumeProperty::Clamped, std::min(1.0, opacity / angled) },
      { vtkOpticsVolumeProperty::Gradient, 1.0 - std::pow(1.0 - opacity, 1.0 / angled) } };
    for (const auto& [mode, expected] : modes)
    {
      TetrahedraScene scene(kind, grid, Size);
      scene.Property->SetSilhouette(mode);
      AddSurface(scene, 0.0, opacity);
      check.AtMost(Name(kind) + scene.Property->GetSilhouetteAsString() + " at " + std::to_string(cosine),
        WorstPixel(scene.Render(), expected), ByteTolerance);
    }
  }
}

// The angle is the world's: stretching the volume along z turns the plane against the ray.
void TestStretchedSilhouette(Check& check, Kind kind)
{
  Grid grid = MakeBox(4, [](double x, double, double z) { return x + z; });
  TetrahedraScene scene(kind, grid, Size);
  scene.Volume->SetScale(1.0, 1.0, 0.5);
  scene.Property->SetSilhouetteToExact();
  scene.SetConstantOpacity(0.3);
  scene.Property->SetScalarOpacityUnitInterval(4.0);
  // gradient (1, 0, 2) in the world, length of the ray 1: |grad s| d = sqrt(5)
  const double expected = 1.0 - std::pow(0.7, std::sqrt(5.0) / 4.0);
  check.AtMost(Name(kind) + "stretched", WorstPixel(scene.Render(), expected), ByteTolerance);
}

// By how much a pixel of one picture is outside of what the other one has within two pixels of it.
int OutsideOfNeighbours(
  const std::vector<unsigned char>& picture, const std::vector<unsigned char>& other, int x, int y)
{
  int least = 255, largest = 0;
  for (int row = y - 2; row <= y + 2; ++row)
  {
    for (int column = x - 2; column <= x + 2; ++column)
    {
      least = std::min<int>(least, other[3 * (row * Size + column)]);
      largest = std::max<int>(largest, other[3 * (row * Size + column)]);
    }
  }
  const int value = picture[3 * (y * Size + x)];
  return std::max({ 0, least - value, value - largest });
}

// The two classes see the same, up to the place of a ray within its pixel: VTK's ray caster looks at a
// corner, and its picture is drawn as a texture, interpolated: up to two pixels, and what is narrower than
// one (silhouettes of a surface, tested above) fades.
void TestAgreement(Check& check)
{
  const Function field = [](double x, double y, double z) { return std::sin(2.0 * x + y) + z * z - 0.3 * y; };
  Grid grid = MakeBox(6, field);
  std::vector<unsigned char> pictures[2];
  for (Kind kind : { TetrahedraScene::Projected, TetrahedraScene::RayCast })
  {
    TetrahedraScene scene(kind, grid, Size);
    scene.Opacity->AddPoint(-0.5, 0.0);
    scene.Opacity->AddPoint(0.8, 0.3);
    scene.Property->SetScalarOpacityUnitInterval(0.5);
    AddSurface(scene, 0.4, 0.2);
    AddSurface(scene, 1.1, 0.3);
    scene.Volume->SetPosition(scene.OffTheEdges[0], scene.OffTheEdges[1], 0.0);
    pictures[kind] = scene.Render();
  }
  int worst = 0;
  for (int y = 2; y < Size - 2; ++y)
  {
    for (int x = 2; x < Size - 2; ++x)
    {
      worst = std::max(worst, OutsideOfNeighbours(pictures[0], pictures[1], x, y));
      worst = std::max(worst, OutsideOfNeighbours(pictures[1], pictures[0], x, y));
    }
  }
  // a code of rounding in each picture, and one that the interpolation takes off a crest
  check.AtMost("difference of the two classes, codes", worst, 3);
}
}

int TestTetrahedraSurfaces(int, char*[])
{
  Check check;
  for (Kind kind : { TetrahedraScene::Projected, TetrahedraScene::RayCast })
  {
    TestOpacityOfSurface(check, kind);
    TestSurfaceInFaces(check, kind);
    TestSilhouettes(check, kind);
    TestStretchedSilhouette(check, kind);
  }
  TestAgreement(check);
  return check.ExitCode();
}
