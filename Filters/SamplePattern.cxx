// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SamplePattern.h"

#include <algorithm>

namespace volumeoptics
{
namespace
{
// Steps of the sequence of Roberts in three dimensions: powers of 1/g, g^4 = g + 1.
const double Steps[3] = { 0.8191725133961645, 0.6710436067037893, 0.5497004779019703 };

double Fraction(double value)
{
  return value - std::floor(value);
}

double UnitNumber(std::uint64_t bits)
{
  return static_cast<double>(bits >> 11) / 9007199254740992.0;
}

SampleOffset OffsetOf(const Ball& ball, const glm::dvec3& voxels, bool interpolated)
{
  SampleOffset offset;
  glm::dvec3 place;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double corner = interpolated ? std::floor(voxels[axis]) : std::round(voxels[axis]);
    place[axis] = interpolated ? voxels[axis] : corner;
    offset.Voxel[axis] = static_cast<int>(corner);
    offset.Fraction[axis] = static_cast<float>(place[axis] - corner);
  }
  const glm::dvec3 world = WorldOffset(ball, place);
  std::copy(&world.x, &world.x + 3, offset.World);
  return offset;
}
}

glm::dvec3 VoxelsPerRadius(const Ball& ball)
{
  glm::dvec3 voxels;
  for (int axis = 0; axis < 3; ++axis)
  {
    const bool isFlat = ball.Grid.Whole[2 * axis] == ball.Grid.Whole[2 * axis + 1];
    voxels[axis] = isFlat ? 0.0 : ball.Radius / ball.Grid.Spacing[axis];
  }
  return voxels;
}

glm::dvec3 WorldOffset(const Ball& ball, const glm::dvec3& voxels)
{
  return ball.Grid.Direction * (voxels * ball.Grid.Spacing / ball.Radius);
}

std::vector<SampleOffset> MakePattern(const Ball& ball, int count, std::uint64_t key, bool interpolated)
{
  const glm::dvec3 voxelsPerRadius = VoxelsPerRadius(ball);
  const double shifts[3] = { UnitNumber(Mixed(key)), UnitNumber(Mixed(key + 1)), UnitNumber(Mixed(key + 2)) };
  std::vector<SampleOffset> pattern;
  pattern.reserve(count);
  for (int i = 0; i < count; ++i)
  {
    const glm::dvec3 point = PointInBall(Fraction(shifts[0] + i * Steps[0]),
      Fraction(shifts[1] + i * Steps[1]), Fraction(shifts[2] + i * Steps[2]));
    pattern.push_back(OffsetOf(ball, point * voxelsPerRadius, interpolated));
  }
  return pattern;
}

std::vector<SampleOffset> MakeExhaustivePattern(const Ball& ball)
{
  const glm::dvec3 reach = glm::floor(glm::abs(VoxelsPerRadius(ball)) + 1.0e-9);
  std::vector<SampleOffset> pattern;
  for (double z = -reach.z; z <= reach.z; ++z)
  {
    for (double y = -reach.y; y <= reach.y; ++y)
    {
      for (double x = -reach.x; x <= reach.x; ++x)
      {
        const glm::dvec3 world = WorldOffset(ball, glm::dvec3(x, y, z));
        if (glm::dot(world, world) <= 1.0 + 1.0e-9)
        {
          pattern.push_back(OffsetOf(ball, glm::dvec3(x, y, z), false));
        }
      }
    }
  }
  return pattern;
}
}
