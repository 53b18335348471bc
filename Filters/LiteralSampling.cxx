// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LiteralSampling.h"

#include "CovarianceSampler.h"

#include <algorithm>

namespace volumeoptics
{
namespace
{
float UnitNumber(std::uint64_t bits, int which)
{
  return static_cast<float>(bits >> (21 * which) & 0x1fffff) / 2097152.0f;
}

struct Moments
{
  float ThetaTheta = 0.0f;
  float ThetaPhi = 0.0f;
  float PhiPhi = 0.0f;
};

Moments MomentsAboutCentroid(const std::vector<glm::vec2>& points)
{
  glm::vec2 mean(0.0f);
  for (const glm::vec2& point : points)
  {
    mean += point;
  }
  mean /= std::max(static_cast<float>(points.size()), 1.0f);
  Moments moments;
  for (const glm::vec2& point : points)
  {
    const glm::vec2 p = point - mean;
    const float weight = std::max(1.0f - glm::dot(p, p), 0.0f);
    moments.ThetaTheta += weight * p.x * p.x;
    moments.ThetaPhi += weight * p.x * p.y;
    moments.PhiPhi += weight * p.y * p.y;
  }
  return moments;
}
}

LiteralSampling::LiteralSampling(
  const Ball& ball, const VoxelBox<float>& scalars, const CovarianceSettings& settings)
  : Scalars(scalars)
  , Settings(settings)
  // Rounding must not carry a point out of the ball, whose voxels are all that a piece requests.
  , VoxelsPerRadius(volumeoptics::VoxelsPerRadius(ball) * (1.0 - 1.0e-6))
{
  for (int axis = 0; axis < 3; ++axis)
  {
    glm::dvec3 unit(0.0);
    unit[axis] = 1.0;
    this->WorldOfVoxels[axis] = glm::vec3(WorldOffset(ball, unit));
  }
}

float LiteralSampling::Interpolated(const glm::ivec3& corner, const glm::vec3& fraction) const
{
  float sum = 0.0f;
  for (int i = 0; i < 8; ++i)
  {
    float weight = 1.0f;
    glm::ivec3 place = corner;
    for (int axis = 0; axis < 3; ++axis)
    {
      const bool isNext = i >> axis & 1;
      weight *= isNext ? fraction[axis] : 1.0f - fraction[axis];
      place[axis] += isNext && fraction[axis] > 0.0f ? 1 : 0;
    }
    if (!this->Scalars.HasRow(place.y, place.z))
    {
      return NoValue<float>();
    }
    sum += weight * *this->Scalars.At(place.x, place.y, place.z);
  }
  return sum;
}

LiteralSampling::Found LiteralSampling::Sample(const glm::vec3& voxels, int x, int y, int z) const
{
  const glm::vec3 corner = this->Settings.Interpolated ? glm::floor(voxels) : glm::floor(voxels + 0.5f);
  const glm::ivec3 index = glm::ivec3(x, y, z) + glm::ivec3(corner);
  if (this->Settings.Interpolated)
  {
    return { this->Interpolated(index, voxels - corner), voxels };
  }
  const bool isInside = this->Scalars.HasRow(index.y, index.z);
  return { isInside ? *this->Scalars.At(index.x, index.y, index.z) : NoValue<float>(), corner };
}

void LiteralSampling::Accumulate(CovarianceRow& row, int voxel, int x, int y, int z) const
{
  const glm::vec3 theta(row.Theta[0][voxel], row.Theta[1][voxel], row.Theta[2][voxel]);
  const glm::vec3 phi(row.Phi[0][voxel], row.Phi[1][voxel], 0.0f);
  static thread_local std::vector<glm::vec2> accepted;
  accepted.clear();
  const bool hasNormal = phi != glm::vec3(0.0f);
  const float centre = row.Scalars[voxel];
  std::uint64_t state = MixedPosition(Mixed(this->Settings.Seed), x, y, z);
  for (int i = 0; hasNormal && i < this->Settings.NumberOfSamples; ++i)
  {
    const std::uint64_t bits = Mixed(state++);
    const glm::vec3 point = PointInBall(UnitNumber(bits, 0), UnitNumber(bits, 1), UnitNumber(bits, 2));
    const Found found = this->Sample(point * this->VoxelsPerRadius, x, y, z);
    if (std::abs(found.Scalar - centre) <= row.Tolerance) // false for NaN
    {
      const glm::vec3 world = this->WorldOfVoxels * found.Offset;
      accepted.push_back(glm::vec2(glm::dot(world, theta), glm::dot(world, phi)));
    }
  }
  const Moments moments = MomentsAboutCentroid(accepted);
  row.Accepted[voxel] = static_cast<float>(accepted.size());
  row.ThetaTheta[voxel] = moments.ThetaTheta;
  row.ThetaPhi[voxel] = moments.ThetaPhi;
  row.PhiPhi[voxel] = moments.PhiPhi;
}
}
