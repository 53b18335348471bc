// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Closed answers of the integral in data space on tetrahedra: opacity depends on the scalars at both
// ends of the ray alone. Of the projection every pixel on a float target, of VTK's ray caster, which
// has 8 bits rounded down, one pixel.

#include "TetrahedraScene.h"

#include <glm/glm.hpp>

#include <algorithm>

namespace
{
const int Size = 64;

// A float's digits over the sums of a ray, and what 256 entries of a table of constants add to them.
const double FloatTolerance = 2e-5;

// VTK's ray caster rounds down to 8 bits.
const double ByteTolerance = 1.0 / 255.0;

const double Corners[4][3] = { { -0.9, -0.8, -0.3 }, { 0.9, -0.7, 0.2 }, { 0.1, 0.9, -0.5 },
  { 0.0, -0.1, 0.8 } };

double Center(int pixel)
{
  return (pixel + 0.5) / Size * 2.0 - 1.0;
}

// Where a line along z meets the cell of Corners: from below and from above.
bool MeetsCell(double x, double y, double& low, double& high)
{
  low = -10.0;
  high = 10.0;
  for (int opposite = 0; opposite < 4; ++opposite)
  {
    glm::dvec3 p[3];
    for (int i = 0, corner = 0; corner < 4; ++corner)
    {
      if (corner != opposite)
      {
        p[i++] = glm::dvec3(Corners[corner][0], Corners[corner][1], Corners[corner][2]);
      }
    }
    const glm::dvec3 inside(Corners[opposite][0], Corners[opposite][1], Corners[opposite][2]);
    glm::dvec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
    normal *= glm::dot(normal, inside - p[0]) > 0.0 ? 1.0 : -1.0;
    const double z = p[0].z - (normal.x * (x - p[0].x) + normal.y * (y - p[0].y)) / normal.z;
    normal.z > 0.0 ? low = std::max(low, z) : high = std::min(high, z);
  }
  return low < high;
}

void TestOneCell(Check& check)
{
  const glm::dvec3 gradient(0.3, -0.2, 0.4);
  const Function field = [gradient](double x, double y, double z) {
    return 0.5 + gradient.x * x + gradient.y * y + gradient.z * z;
  };
  Grid grid = MakeCell(Corners, field);
  for (int silhouette : { vtkOpticsVolumeProperty::SilhouetteOff, vtkOpticsVolumeProperty::Exact })
  {
    TetrahedraScene scene(TetrahedraScene::Projected, grid, Size);
    scene.SetConstantOpacity(0.7);
    scene.Property->SetSilhouette(silhouette);
    const std::vector<float> pixels = RenderFloat(scene.Window, scene.Renderer);
    double worst = 0.0;
    int covered = 0;
    for (int y = 0; y < Size; ++y)
    {
      for (int x = 0; x < Size; ++x)
      {
        double low = 0.0, high = 0.0;
        const bool isMet = MeetsCell(Center(x), Center(y), low, high);
        covered += isMet;
        const double rate = silhouette == 0 ? std::abs(gradient.z) : glm::length(gradient);
        const double expected = isMet ? 1.0 - std::pow(0.3, rate * (high - low)) : 0.0;
        worst = std::max(worst, std::abs(pixels[4 * (y * Size + x)] - expected));
      }
    }
    check.AtLeast("pixels in the cell", covered, 1000);
    check.AtMost("worst pixel of a cell, silhouette " + std::to_string(silhouette), worst, FloatTolerance);
  }
}

// Linear in a direction: opacity 1 - (1 - a)^|ds| whatever the cells and the world's scale are.
void TestBox(Check& check)
{
  const Function field = [](double, double, double z) { return 0.5 + 0.4 * z; };
  const double expected = 1.0 - std::pow(0.3, 0.8);
  for (double scale : { 1e-6, 1.0, 1e6 })
  {
    for (int cells : { 1, 2, 7 })
    {
      const std::string name =
        std::to_string(cells) + " cells an axis at scale " + std::to_string(std::log10(scale));
      Grid grid = MakeBox(cells, field, scale);
      TetrahedraScene projected(TetrahedraScene::Projected, grid, Size);
      projected.SetConstantOpacity(0.7);
      projected.See(scale);
      const std::vector<float> pixels = RenderFloat(projected.Window, projected.Renderer);
      const auto ends =
        std::minmax_element(pixels.begin(), pixels.end(), [](float a, float b) { return a < b; });
      check.Near("least opacity of " + name, *ends.first, expected, FloatTolerance);
      check.AtMost("finite alpha of " + name, *ends.second, 1.0);
      TetrahedraScene cast(TetrahedraScene::RayCast, grid, Size);
      cast.SetConstantOpacity(0.7);
      cast.See(scale);
      check.Near("ray caster, " + name, cast.RenderOpacity(20, 35), expected, ByteTolerance);
    }
  }
}

// Colour falls along the ray as the scalar, .9 in front to .1 behind, and what is in front attenuates
// it: which end is in front counts, and the order of the cells.
void TestColor(Check& check)
{
  const Function field = [](double, double, double z) { return 0.5 + 0.4 * z; };
  const double tau = -std::log(0.3), length = 0.8, left = std::exp(-tau * length);
  const double expected = 0.9 * (1.0 - left) - (1.0 / tau - left * (length + 1.0 / tau));
  for (int cells : { 1, 7 })
  {
    Grid grid = MakeBox(cells, field);
    for (TetrahedraScene::Kind kind : { TetrahedraScene::Projected, TetrahedraScene::RayCast })
    {
      TetrahedraScene scene(kind, grid, Size);
      scene.SetConstantOpacity(0.7);
      scene.Color->RemoveAllPoints();
      scene.Color->AddRGBPoint(0.0, 0.0, 0.0, 0.0);
      scene.Color->AddRGBPoint(1.0, 1.0, 1.0, 1.0);
      const std::string name = kind == TetrahedraScene::Projected ? "projected colour" : "ray cast colour";
      check.Near(name, scene.RenderOpacity(20, 35), expected, ByteTolerance);
    }
  }
}
}

int TestDataSpaceTetrahedra(int, char*[])
{
  Check check;
  TestOneCell(check);
  TestBox(check);
  TestColor(check);
  return check.ExitCode();
}
