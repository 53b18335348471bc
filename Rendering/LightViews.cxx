// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LightViews.h"

#include "vtkLight.h"
#include "vtkMath.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace
{
using Vector = glm::dvec3;

// Beyond 60 degrees from the axis froxels grow too long.
const double WidestPlace = std::tan(vtkMath::RadiansFromDegrees(60.0));

// So many times the box's size away, rays to a lamp are parallel to a thousandth of it, and single precision would no
// longer tell its slices apart.
const double FarthestDistance = 2000.0;

// A part of the box's size that is too near to a light to cast shadows.
const double NearestPart = 1.0e-3;

struct Box
{
  explicit Box(const double corners[24])
  {
    for (int i = 0; i < 8; ++i)
    {
      this->Corners[i] = Vector(corners[3 * i], corners[3 * i + 1], corners[3 * i + 2]);
      this->Center += 0.125 * this->Corners[i];
    }
    for (const Vector& corner : this->Corners)
    {
      this->Radius = std::max(this->Radius, glm::length(corner - this->Center));
    }
  }

  Vector Corners[8];
  Vector Center = Vector(0.0);
  double Radius = 0.0;
};

Vector ToVector(const double* point)
{
  return Vector(point[0], point[1], point[2]);
}

// Without a direction it is along z.
Vector UnitOrZ(const Vector& direction)
{
  const double length = glm::length(direction);
  return length > 0.0 ? direction / length : Vector(0.0, 0.0, 1.0);
}

SweepGrid::View MakeView(const Vector& origin, const Vector& axis, double window)
{
  Vector right, up;
  vtkMath::Perpendiculars(&axis[0], &right[0], &up[0], 0.0);
  SweepGrid::View view = {};
  const Vector rows[3] = { right, up, axis };
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      view.WorldToView[4 * row + column] = rows[row][column];
    }
    view.WorldToView[4 * row + 3] = -glm::dot(rows[row], origin);
  }
  view.WorldToView[15] = 1.0;
  for (int side = 0; side < 4; ++side)
  {
    view.Window[side] = side % 2 == 0 ? -window : window;
  }
  return view;
}

SweepGrid::View ParallelView(const Box& box, const Vector& axis)
{
  SweepGrid::View view = MakeView(box.Center, axis, box.Radius);
  view.Range[0] = -box.Radius;
  view.Range[1] = box.Radius;
  return view;
}

SweepGrid::View PerspectiveView(const Box& box, const Vector& position, const Vector& axis, double window)
{
  SweepGrid::View view = MakeView(position, axis, window);
  view.IsPerspective = true;
  view.Range[0] = NearestPart * box.Radius;
  view.Range[1] = glm::length(box.Center - position) + box.Radius;
  return view;
}

// Of the box, on either axis across the view; infinite where it is not all in front.
double FarthestPlace(const Box& box, const SweepGrid::View& view)
{
  double farthest = 0.0;
  for (const Vector& corner : box.Corners)
  {
    double place[3];
    for (int row = 0; row < 3; ++row)
    {
      const double* numbers = view.WorldToView + 4 * row;
      place[row] = glm::dot(ToVector(numbers), corner) + numbers[3];
    }
    const double across = std::max(std::abs(place[0]), std::abs(place[1]));
    farthest = place[2] > view.Range[0] ? std::max(farthest, across / place[2]) : VTK_DOUBLE_MAX;
  }
  return farthest;
}

std::vector<SweepGrid::View> CubeAround(const Box& box, const Vector& position)
{
  std::vector<SweepGrid::View> views;
  for (int side = 0; side < LargestNumberOfViews; ++side)
  {
    Vector axis(0.0);
    axis[side / 2] = side % 2 == 0 ? 1.0 : -1.0;
    views.push_back(PerspectiveView(box, position, axis, 1.0));
  }
  return views;
}

// A cone beyond 90 degrees is none, as in VTK.
double WindowOfCone(vtkLight* light)
{
  const double angle = light->GetConeAngle();
  return angle < 90.0 ? std::tan(vtkMath::RadiansFromDegrees(std::max(angle, 0.1))) : VTK_DOUBLE_MAX;
}
}

//------------------------------------------------------------------------------
std::vector<SweepGrid::View> ViewsOfLight(vtkLight* light, const double corners[24])
{
  const Box box(corners);
  const Vector position = ToVector(light->GetTransformedPosition());
  const Vector axis = UnitOrZ(ToVector(light->GetTransformedFocalPoint()) - position);
  if (!light->GetPositional())
  {
    return { ParallelView(box, axis) };
  }
  if (glm::length(box.Center - position) > FarthestDistance * box.Radius)
  {
    return { ParallelView(box, UnitOrZ(box.Center - position)) };
  }
  SweepGrid::View view = PerspectiveView(box, position, UnitOrZ(box.Center - position), 1.0);
  const double farthest = FarthestPlace(box, view);
  const double cone = WindowOfCone(light);
  if (cone <= WidestPlace && cone < farthest)
  {
    return { PerspectiveView(box, position, axis, cone) };
  }
  if (farthest > WidestPlace)
  {
    return CubeAround(box, position);
  }
  for (double& side : view.Window)
  {
    side *= farthest;
  }
  return { view };
}
