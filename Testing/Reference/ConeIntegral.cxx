// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ConeIntegral.h"

#include "LightingTransfer.h"
#include "Optics.h"
#include "RayCaster.h"
#include "SegmentRay.h"
#include "Shading.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace reference
{
namespace
{
constexpr double TwoPi = 6.283185307179586;
// A face belongs to the volume, whatever rounding says.
constexpr double Slack = 1.0e-9;
// Of a ray 6e-6 is left.
constexpr double OpaqueEnough = 12.0;

// The splitmix64 generator: the same numbers everywhere, and for any number of threads.
class RandomNumbers
{
public:
  explicit RandomNumbers(std::uint64_t seed)
    : State(seed)
  {
  }

  double Next()
  {
    this->State += 0x9E3779B97F4A7C15ULL;
    std::uint64_t z = this->State;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    return static_cast<double>((z ^ (z >> 31)) >> 11) / 9007199254740992.0;
  }

private:
  std::uint64_t State;
};

// Of a point, by the bits of its coordinates.
std::uint64_t NumberOf(const Vector& point)
{
  std::uint64_t number = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    std::uint64_t bits;
    std::memcpy(&bits, &point[axis], sizeof(bits));
    number = (number ^ bits) * 0x100000001B3ULL;
  }
  return number;
}

struct Basis
{
  explicit Basis(const Vector& axis)
  {
    const Vector aside = std::abs(axis.z) < 0.9 ? Vector(0.0, 0.0, 1.0) : Vector(1.0, 0.0, 0.0);
    this->first = glm::normalize(glm::cross(axis, aside));
    this->second = glm::cross(axis, this->first);
  }
  Vector first, second;
};

Scene WithoutLight(const Scene& scene, double step)
{
  Scene unlit = scene;
  unlit.shade = false;
  unlit.visibility = nullptr;
  unlit.silhouette = Silhouette::Off;
  unlit.terminatesEarly = false;
  unlit.step = step > 0.0 ? step : scene.step;
  unlit.firstSample = 0.5;
  return unlit;
}

void AppendPointsOfRay(
  const Scene& scene, const Ray& ray, int pixel, double leastWeight, std::vector<ShownPoint>& points)
{
  Sample sample;
  sample.entry = ray.origin + ray.inside.entry * ray.direction;
  sample.toViewer = -ray.direction;
  double transparency = 1.0;
  const double steps = (ray.inside.exit - ray.inside.entry) / scene.step + 1.0e-9;
  for (double at = scene.firstSample; at <= steps; at += 1.0)
  {
    sample.position = sample.entry + at * scene.step * ray.direction;
    sample.scalar = scene.field->Value(sample.position);
    const double opacity = ClassifiedAt(scene, sample).opacity;
    if (transparency * opacity > leastWeight)
    {
      points.push_back({ sample.position, sample.toViewer, transparency * opacity, pixel });
    }
    transparency *= 1.0 - opacity;
    if (scene.terminatesEarly && 1.0 - transparency > EarlyTerminationOpacity)
    {
      break;
    }
  }
}
}

//------------------------------------------------------------------------------
Occluders::Occluders(const Scene& scene, double step)
  : Unlit(WithoutLight(scene, step))
{
}

//------------------------------------------------------------------------------
double Occluders::ExtinctionAt(const Vector& point) const
{
  const Vector index = this->Unlit.grid.ToIndex(point);
  for (int axis = 0; axis < 3; ++axis)
  {
    if (index[axis] < -Slack || index[axis] > this->Unlit.grid.points[axis] - 1 + Slack)
    {
      return 0.0;
    }
  }
  const double opacity = this->Unlit.Opacity(this->Unlit.field->Value(point));
  const double depth = opacity < 1.0 ? optics::OpticalDepth(opacity) : optics::OpaqueDepth;
  return depth / this->Unlit.unitDistance;
}

//------------------------------------------------------------------------------
double Occluders::DepthByPoints(const Vector& origin, const Vector& direction, const Interval& inside) const
{
  const double length = inside.exit - inside.entry;
  const int steps = std::max(1, static_cast<int>(std::ceil(length / this->Unlit.step)));
  const double step = length / steps;
  double depth = 0.0;
  for (int i = 0; i < steps && depth < OpaqueEnough; ++i)
  {
    depth += step * this->ExtinctionAt(origin + (inside.entry + (i + 0.5) * step) * direction);
  }
  return depth;
}

//------------------------------------------------------------------------------
double Occluders::Transmittance(const Vector& point, const Vector& direction, double distance) const
{
  Ray ray;
  ray.origin = point;
  ray.direction = direction;
  ray.inside = Intersect(this->Unlit.grid, point, direction);
  ray.inside.entry = std::max(ray.inside.entry, 0.0);
  ray.inside.exit = std::min(ray.inside.exit, distance);
  if (!(ray.inside.exit > ray.inside.entry))
  {
    return 1.0;
  }
  return GoesBySegments(this->Unlit) ? 1.0 - IntegrateSegments(this->Unlit, ray).a
                                     : std::exp(-this->DepthByPoints(point, direction, ray.inside));
}

//------------------------------------------------------------------------------
std::vector<Vector> ConeDirections(const Vector& axis, const ConeRays& rays, std::uint64_t pointNumber)
{
  RandomNumbers random(rays.seed * 0x2545F4914F6CDD1DULL + pointNumber);
  const double turn = TwoPi * random.Next();
  const double coneVersine = 1.0 - std::cos(glm::radians(rays.angle));
  const Basis basis(axis);
  std::vector<Vector> directions;
  directions.reserve(rays.count);
  for (int i = 0; i < rays.count; ++i)
  {
    const double versine = coneVersine * (i + random.Next()) / rays.count;
    const double sine = std::sqrt(std::max(versine * (2.0 - versine), 0.0));
    const double azimuth = turn + i * (TwoPi * 0.6180339887498949);
    directions.push_back(
      (1.0 - versine) * axis + sine * (std::cos(azimuth) * basis.first + std::sin(azimuth) * basis.second));
  }
  return directions;
}

//------------------------------------------------------------------------------
double ConeVisibility(
  const Occluders& occluders, const Vector& point, const Vector& axis, const ConeRays& rays)
{
  double sum = 0.0;
  for (const Vector& direction : ConeDirections(axis, rays, NumberOf(point)))
  {
    sum += occluders.Transmittance(point, direction);
  }
  return sum / rays.count;
}

//------------------------------------------------------------------------------
std::vector<ShownPoint> ShownPoints(const Scene& scene, double leastWeight)
{
  std::vector<ShownPoint> points;
  for (int y = 0; y < scene.camera.height; ++y)
  {
    for (int x = 0; x < scene.camera.width; ++x)
    {
      AppendPointsOfRay(
        scene, RayThrough(scene, x + 0.5, y + 0.5), y * scene.camera.width + x, leastWeight, points);
    }
  }
  return points;
}

//------------------------------------------------------------------------------
std::vector<double> VisibilityAt(
  const Occluders& occluders, const std::vector<ShownPoint>& points, const ConeRays& rays, const Vector* axis)
{
  std::vector<double> values(points.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(points.size()), 64, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      values[i] = ConeVisibility(occluders, points[i].position, axis ? *axis : points[i].toViewer, rays);
    }
  });
  return values;
}

//------------------------------------------------------------------------------
std::vector<double> MeanOfPixels(
  const std::vector<ShownPoint>& points, const std::vector<double>& values, int pixels)
{
  std::vector<double> means(pixels, 0.0), weights(pixels, 0.0);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    means[points[i].pixel] += points[i].weight * values[i];
    weights[points[i].pixel] += points[i].weight;
  }
  for (int i = 0; i < pixels; ++i)
  {
    means[i] = weights[i] > 0.0 ? means[i] / weights[i] : -1.0;
  }
  return means;
}

//------------------------------------------------------------------------------
VisibilityError CompareVisibility(
  const std::vector<ShownPoint>& points, const std::vector<double>& values, const std::vector<double>& truth)
{
  VisibilityError error;
  double weights = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const double off = values[i] - truth[i];
    weights += points[i].weight;
    error.mean += points[i].weight * std::abs(off);
    error.rootMeanSquare += points[i].weight * off * off;
    error.bias += points[i].weight * off;
    error.maximum = std::max(error.maximum, std::abs(off));
  }
  weights = std::max(weights, 1.0e-300);
  error.mean /= weights;
  error.rootMeanSquare = std::sqrt(error.rootMeanSquare / weights);
  error.bias /= weights;
  return error;
}
}
