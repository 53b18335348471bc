// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LightShadow.h"

namespace reference
{
namespace
{
Vector MiddleOf(const Grid& grid)
{
  Vector middle = grid.corner;
  for (int axis = 0; axis < 3; ++axis)
  {
    middle += 0.5 * grid.Length(axis) * grid.directions[axis];
  }
  return middle;
}

// The direction from one point to another, and how far it is; along z where they are one.
struct Way
{
  Way(const Vector& from, const Vector& to)
    : length(glm::length(to - from))
    , direction(length > 0.0 ? (to - from) / length : Vector(0.0, 0.0, 1.0))
  {
  }
  double length;
  Vector direction;
};
}

//------------------------------------------------------------------------------
LightShadow::LightShadow(const Scene& scene, double angle, double step, int rays)
  : Volume(scene, step)
{
  this->Rays.angle = angle;
  this->Rays.count = angle > 0.0 ? rays : 1;
}

//------------------------------------------------------------------------------
double LightShadow::operator()(const Light& light, const Vector& point) const
{
  const double share =
    light.positional ? this->ShareOfPositional(light, point) : this->ShareOfDirectional(light, point);
  return 1.0 - light.shadowAttenuation * (1.0 - share);
}

//------------------------------------------------------------------------------
double LightShadow::ShareOfDirectional(const Light& light, const Vector& point) const
{
  return ConeVisibility(this->Volume, point, light.toLight, this->Rays);
}

//------------------------------------------------------------------------------
double LightShadow::ShareOfPositional(const Light& light, const Vector& point) const
{
  const Vector middle = MiddleOf(this->Volume.GetScene().grid);
  const Way axis(middle, light.position);
  double sum = 0.0;
  for (const Vector& direction : ConeDirections(axis.direction, this->Rays, 0))
  {
    const double length = axis.length / glm::dot(direction, axis.direction);
    const Way way(point, middle + length * direction);
    sum += this->Volume.Transmittance(point, way.direction, way.length);
  }
  return sum / this->Rays.count;
}
}
