// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Directions of a cone and of the disk at its base, and steps between slices: closed cases.

#include "Check.h"
#include "Optics.h"

#include <string>

namespace
{
constexpr double Degree = 0.017453292519943295;

// The mean direction of a cone is (1 + cos)/2 along the axis; equal shares of the cosines have that mean
// exactly, whatever their number.
void CheckConeDirections(Check& check)
{
  for (double angle : { 0.0, 1e-6, 0.1, 30.0, 60.0, 80.0 })
  {
    const double coneCosine = std::cos(angle * Degree);
    for (int count : { 1, 3, 4, 8, 16, 1024 })
    {
      const std::string what = std::to_string(count) + " directions of " + std::to_string(angle);
      glm::dvec3 mean(0.0);
      for (int i = 0; i < count; ++i)
      {
        const optics::ConeRay ray = optics::ConeDirection(i, count, coneCosine);
        const glm::dvec3 direction(ray.slope * ray.cosine, ray.cosine);
        check.Near(what + ", length", glm::length(direction), 1.0, Rounding);
        check.AtLeast(what + ", inside", ray.cosine, coneCosine);
        mean += direction / double(count);
      }
      check.Near(what + ", mean", mean.z, 0.5 * (1.0 + coneCosine), Rounding);
    }
  }
  const optics::ConeRay axis = optics::ConeDirection(3, 8, 1.0);
  check.Near("no cone: slope", glm::length(axis.slope), 0.0, 0.0);
  check.Near("no cone: cosine", axis.cosine, 1.0, 0.0);
}

// Azimuths turn all ways: across the axis the directions cancel but for the part of one of them.
void CheckBalance(Check& check)
{
  for (int count : { 4, 8, 16, 64 })
  {
    glm::dvec2 mean(0.0);
    for (int i = 0; i < count; ++i)
    {
      const optics::ConeRay ray = optics::ConeDirection(i, count, 0.5);
      mean += ray.slope * ray.cosine / double(count);
    }
    check.AtMost("off the axis, " + std::to_string(count), glm::length(mean), 0.8 / count);
  }
}

struct DiskSums
{
  int Count = 0;
  double SolidAngle = 0.0;
  glm::dvec2 Slope = glm::dvec2(0.0);
};

DiskSums SumOverDisk(int size, double tangent)
{
  DiskSums sums;
  for (int i = 0; i < size * size; ++i)
  {
    if (optics::IsOnDisk(i, size))
    {
      const optics::ConeRay ray = optics::DiskDirection(i, size, tangent);
      sums.Count += 1;
      sums.SolidAngle += optics::SolidAngleOfDisk(ray.cosine) * 4.0 * tangent * tangent / (size * size);
      sums.Slope += ray.slope;
    }
  }
  return sums;
}

void CheckDisk(Check& check)
{
  check.Near("2 x 2", SumOverDisk(2, 1.0).Count, 4.0, 0.0);
  check.Near("5 x 5", SumOverDisk(5, 1.0).Count, 21.0, 0.0);
  check.Near("13 x 13", SumOverDisk(13, 1.0).Count, 137.0, 0.0);
  const optics::ConeRay corner = optics::DiskDirection(0, 2, 3.0);
  check.Near("first of 2 x 2", corner.slope.x, -1.5, Rounding);
  check.Near("first of 2 x 2", corner.slope.y, -1.5, Rounding);
  for (double angle : { 0.0, 30.0, 60.0, 80.0 })
  {
    const DiskSums sums = SumOverDisk(401, std::tan(angle * Degree));
    check.Near("balanced", glm::length(sums.Slope), 0.0, 1e-8);
    // the circle is off by a part of a square of the grid: 1e-3 of the disk's area
    const double cone = 2.0 * optics::Pi * (1.0 - std::cos(angle * Degree));
    check.Near("solid angle of the cone, " + std::to_string(angle), sums.SolidAngle, cone, 2e-3 * cone);
  }
}

void CheckTransmittance(Check& check)
{
  check.Near("nothing there", optics::StretchTransmittance(0.0, 1e30), 1.0, 0.0);
  check.Near("opaque, however thin", optics::StretchTransmittance(1.0, 0.0), 0.0, 0.0);
  check.Near("one length", optics::StretchTransmittance(0.75, 1.0), 0.25, Rounding);
  check.Near("half of it", optics::StretchTransmittance(0.75, 0.5), 0.5, Rounding);
  check.Near("a slope of 60 degrees", optics::StretchTransmittance(0.5, 1.0 / 0.5), 0.25, Rounding);
  check.Near("far", optics::StretchTransmittance(0.5, 1e30), 0.0, 0.0);
}

// Against sums over the stretch and over the cone.
void CheckOwnVisibility(Check& check)
{
  check.Near("nothing there", optics::StretchVisibility(0.0, 3.0), 1.0, 0.0);
  check.Near("opaque", optics::StretchVisibility(1.0, 1.0), 0.5, Rounding);
  check.Near("no way out", optics::StretchVisibility(0.6, 0.0), 1.0, Rounding);
  const int parts = 20000;
  for (const double opacity : { 1.0e-6, 0.005, 0.3, 0.99 })
  {
    const double depth = -std::log1p(-opacity);
    double sum = 0.0;
    for (int i = 0; i < parts; ++i)
    {
      sum += std::exp(-depth * (i + 0.5) / parts * (1.0 + 1.7)) * depth / parts;
    }
    check.Near("a stretch", optics::StretchVisibility(opacity, 1.7), sum / opacity, 1.0e-7);
  }
  for (const double cosine : { 0.1736, 0.5, 0.9, 0.95, 0.999 })
  {
    double sum = 0.0;
    for (int i = 0; i < parts; ++i)
    {
      sum += optics::StretchVisibility(1.0, 1.0 / (cosine + (1.0 - cosine) * (i + 0.5) / parts)) / parts;
    }
    check.Near("a cone", optics::StretchVisibility(1.0, optics::MeanWayOut(cosine)), sum, 1.0e-8);
  }
  check.Near("no cone", optics::MeanWayOut(1.0), 1.0, 0.0);
}

void CheckPlaces(Check& check)
{
  const glm::dvec2 place(0.25, -0.5), slope(2.0, 1.0);
  const glm::dvec2 parallel = optics::PlaceOnSlice(place, slope, 0.125, 1.0, 1.0);
  check.Near("parallel", parallel.x, 0.5, Rounding);
  check.Near("parallel", parallel.y, -0.375, Rounding);
  // towards the eye a place stays where it is
  const glm::dvec2 toEye = optics::PlaceOnSlice(place, -place, 3.0, 10.0, 7.0);
  check.Near("towards the eye", glm::length(toEye - place), 0.0, Rounding);
  // two steps are one
  const glm::dvec2 half = optics::PlaceOnSlice(place, slope, 1.0, 10.0, 9.0);
  const glm::dvec2 twice = optics::PlaceOnSlice(half, slope, 2.0, 9.0, 7.0);
  const glm::dvec2 once = optics::PlaceOnSlice(place, slope, 3.0, 10.0, 7.0);
  check.Near("straight", glm::length(twice - once), 0.0, Rounding);
}
}

int TestVisibility(int, char*[])
{
  Check check;
  CheckConeDirections(check);
  CheckBalance(check);
  CheckDisk(check);
  CheckTransmittance(check);
  CheckOwnVisibility(check);
  CheckPlaces(check);
  return check.ExitCode();
}
