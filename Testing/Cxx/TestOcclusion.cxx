// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Occlusion of a floor, against closed forms of its visibility: nothing above it, a pane of glass, a roof,
// and the inside of a homogeneous volume.

#include "OcclusionTesting.h"

namespace
{
const double Angles[] = { 0.0, 30.0, 60.0, 80.0 };

std::string At(double degrees)
{
  return " at " + std::to_string(static_cast<int>(degrees)) + " degrees";
}

void CheckOpenFloor(Check& check)
{
  OcclusionScene scene(Floor);
  for (const double angle : Angles)
  {
    scene.Property->SetOcclusionAngle(angle);
    // rays of 80 degrees must get out of the floor's own ramp: 64 froxels, that they are long enough. .03 is what is asked
    // of occlusion; a sample's own stretch counts as even, which the ramp is not
    scene.Optics->SetVisibilityGridSize(64);
    scene.Optics->SetVisibilityGatherSamples(6);
    check.Near("open floor" + At(angle), scene.Visibility(), OpenFloor(angle), 0.03);
    // the ray takes the cone's mean cosine for all of it: .016 at 80 degrees; and its own mean over steps
    scene.Optics->SetVisibilityGridSize(128);
    scene.Optics->SetVisibilityGatherSamples(0);
    check.Near("open floor, not gathered" + At(angle), scene.Visibility(), OpenFloor(angle), 0.02);
  }
}

// Black glass, optical depth 0.7 on the way straight up.
void CheckPane(Check& check)
{
  const double depth = 0.7;
  const double thickness = 4.8 / 32.0; // four voxels, and two fifths of one on each side
  const double opacity = 1.0 - std::exp(-depth * 0.02 / thickness);
  const auto pane = [](double x, double y, double z) {
    return z < FloorHeight ? Dense : (std::abs(z + 0.25) < 0.0626 ? Glass : 0.0);
  };
  OcclusionScene open(Floor);
  OcclusionScene scene(pane, opacity);
  for (const double angle : Angles)
  {
    scene.Property->SetOcclusionAngle(angle);
    open.Property->SetOcclusionAngle(angle);
    const double expected = MeanOverCone(angle, [&](double cosine) { return std::exp(-depth / cosine); });
    // slices of 3/4 of a voxel find its thickness to within a quarter of one, 5 % of its depth
    check.Near("pane" + At(angle), scene.Visibility() / open.Visibility(), expected, 0.03);
  }
}

// How much of the cone passes the edge of a half-plane from x = 0 on to the left, that reaches from one height above
// the point to another.
double PastRoof(double degrees, double x, double low, double high)
{
  return MeanOverCone(degrees, [&](double cosine) {
    const double tangent = std::sqrt(1.0 - cosine * cosine) / cosine;
    int free = 0;
    for (int i = 0; i < 360; ++i)
    {
      const double slope = tangent * std::cos(vtkMath::RadiansFromDegrees(i + 0.5));
      free += x + std::min(slope * low, slope * high) > 0.0 ? 1 : 0;
    }
    return free / 360.0;
  });
}

// Opaque, over the half of the floor.
void CheckRoof(Check& check)
{
  const auto roof = [](double x, double, double z) {
    return z < FloorHeight || (x < 0.0 && std::abs(z) < 0.1) ? Dense : 0.0;
  };
  OcclusionScene open(Floor);
  OcclusionScene scene(roof);
  const double edge = -0.4 / 16.0; // where the opacity's ramp begins, between two points
  for (const double angle : { 30.0, 60.0 })
  {
    scene.Property->SetOcclusionAngle(angle);
    open.Property->SetOcclusionAngle(angle);
    for (const int pixel : { 1, 4, 7 })
    {
      const double expected = PastRoof(angle, pixel * 2.0 / 33.0 - edge, 0.3, 0.5);
      // one of eight directions more or less
      check.Near("roof" + At(angle) + ", pixel " + std::to_string(pixel),
        scene.Visibility(pixel) / open.Visibility(pixel), expected, 0.125);
    }
  }
}

// Of a homogeneous volume from its front to its back: int exp(-t) exp(-t / c) dt over the optical depth.
void CheckFog(Check& check)
{
  const double depth = 2.0;
  OcclusionScene scene([](double, double, double) { return Dense; });
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(0.0, 1.0 - std::exp(-depth * 0.02));
  for (const double angle : { 0.0, 30.0, 45.0 })
  {
    scene.Property->SetOcclusionAngle(angle);
    const double seen = MeanOverCone(angle, [&](double cosine) {
      const double rate = 1.0 + 1.0 / cosine;
      return (1.0 - std::exp(-depth * rate)) / rate;
    });
    check.Near("fog" + At(angle), scene.Visibility(), seen / (1.0 - std::exp(-depth)), 0.01);
  }
}

// Nothing to see and nothing in the way: no NaN.
void CheckNothing(Check& check)
{
  OcclusionScene scene([](double, double, double) { return 0.0; });
  scene.Property->OcclusionOn();
  check.That(AreFinite(scene.RenderFloat()), "an empty volume is drawn");
  check.Near("an empty volume", scene.Red(), 0.0, 0.0);
}

// Ambient light has its colour with and without occlusion.
void CheckColor(Check& check)
{
  OcclusionScene scene(Floor);
  const double white = scene.Red();
  scene.Property->SetAmbientColor(0.5, 1.0, 1.0);
  check.Near("coloured light alone", scene.Red(), 0.5 * white, 1.0e-3);
  const double half = scene.Visibility();
  scene.Property->SetAmbientColor(1.0, 1.0, 1.0);
  check.Near("coloured light and occlusion", half, scene.Visibility(), 1.0e-3);
}

// With Shade on it is the ambient part that is darkened.
void CheckShade(Check& check)
{
  OcclusionScene scene(Floor);
  const double free = scene.Visibility();
  scene.Property->ShadeOn();
  scene.Property->SetAmbient(0.5);
  scene.Property->SetDiffuse(0.0);
  scene.Property->SetSpecular(0.0);
  scene.Property->OcclusionOn();
  check.Near("ambient part", scene.Red(), 0.5 * free, 0.005);
  scene.Property->SetAmbient(0.0);
  scene.Property->SetDiffuse(1.0);
  const double lit = scene.Red();
  scene.Property->OcclusionOff();
  check.Near("diffuse part", lit, scene.Red(), 0.005);
}
}

int TestOcclusion(int, char*[])
{
  Check check;
  CheckOpenFloor(check);
  CheckPane(check);
  CheckRoof(check);
  CheckFog(check);
  CheckNothing(check);
  CheckColor(check);
  CheckShade(check);
  return check.ExitCode();
}
