// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CovarianceSampler.h"

#include "LiteralSampling.h"
#include "Optics.h"

#include <algorithm>

namespace volumeoptics
{
namespace
{
int BlockOf(int index)
{
  const int size = CovarianceSampler::BlockSize;
  return index >= 0 ? index / size : -((-index + size - 1) / size);
}

// The rows that nearest samples read, those outside the volume left out.
std::vector<NearestSample> NearestSamples(
  const VoxelBox<float>& scalars, const std::vector<SampleOffset>& pattern, int x, int y, int z)
{
  std::vector<NearestSample> samples;
  samples.reserve(pattern.size());
  for (const SampleOffset& offset : pattern)
  {
    const int rowY = y + offset.Voxel[1];
    const int rowZ = z + offset.Voxel[2];
    if (scalars.HasRow(rowY, rowZ))
    {
      samples.push_back({ scalars.At(x + offset.Voxel[0], rowY, rowZ),
        { offset.World[0], offset.World[1], offset.World[2] } });
    }
  }
  return samples;
}

// Corners of weight 0 read what another corner reads, so that no missing value gets in.
bool AddCorners(
  const VoxelBox<float>& scalars, const SampleOffset& offset, int x, int y, int z, LinearSample& sample)
{
  for (int corner = 0; corner < 8; ++corner)
  {
    float weight = 1.0f;
    int place[3] = { x, y, z };
    for (int axis = 0; axis < 3; ++axis)
    {
      const bool isNext = corner >> axis & 1;
      const float fraction = offset.Fraction[axis];
      weight *= isNext ? fraction : 1.0f - fraction;
      place[axis] += offset.Voxel[axis] + (isNext && fraction > 0.0f ? 1 : 0);
    }
    if (!scalars.HasRow(place[1], place[2]))
    {
      return false;
    }
    sample.Scalars[corner] = scalars.At(place[0], place[1], place[2]);
    sample.Weights[corner] = weight;
  }
  return true;
}

std::vector<LinearSample> LinearSamples(
  const VoxelBox<float>& scalars, const std::vector<SampleOffset>& pattern, int x, int y, int z)
{
  std::vector<LinearSample> samples;
  samples.reserve(pattern.size());
  for (const SampleOffset& offset : pattern)
  {
    LinearSample sample;
    if (AddCorners(scalars, offset, x, y, z, sample))
    {
      std::copy(offset.World, offset.World + 3, sample.World);
      samples.push_back(sample);
    }
  }
  return samples;
}
}

CovarianceRows::CovarianceRows(int length)
{
  for (std::vector<float>& numbers : this->Numbers)
  {
    numbers.assign(length + KernelPadding, 0.0f);
  }
}

void CovarianceRows::SetNormal(int voxel, const glm::dvec3& normal)
{
  if (normal == glm::dvec3(0.0))
  {
    return;
  }
  const optics::TangentBasis basis = optics::SphericalBasis(normal);
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Numbers[axis][voxel] = static_cast<float>(basis.theta[axis]);
  }
  this->Numbers[3][voxel] = static_cast<float>(basis.phi.x);
  this->Numbers[4][voxel] = static_cast<float>(basis.phi.y);
}

CovarianceRow CovarianceRows::GetRow(int first, int last, const float* scalars, double tolerance)
{
  auto numbers = [this, first](int i) { return this->Numbers[i].data() + first; };
  return { last - first + 1, static_cast<float>(tolerance), scalars, { numbers(0), numbers(1), numbers(2) },
    { numbers(3), numbers(4) }, numbers(5), numbers(6), numbers(7), numbers(8) };
}

glm::dvec3 CovarianceRows::GetTangentCovariance(int voxel) const
{
  return { this->Numbers[5][voxel], this->Numbers[6][voxel], this->Numbers[7][voxel] };
}

CovarianceSampler::CovarianceSampler(const ImageGrid& grid, const CovarianceSettings& settings)
  : Grid(grid)
  , Settings(settings)
  , Neighbourhood{ grid, settings.Radius }
{
  if (settings.Pattern == Sampling::Exhaustive)
  {
    this->Fixed = MakeExhaustivePattern(this->Neighbourhood);
  }
  else if (settings.Pattern == Sampling::Shared)
  {
    this->Fixed = MakePattern(this->Neighbourhood, settings.NumberOfSamples,
      Mixed(settings.Seed), settings.Interpolated);
  }
}

Halo CovarianceSampler::GetReach(const ImageGrid& grid, double radius, bool)
{
  // The corners of an interpolated sample lie within the ceiling of its distance, and so does the
  // voxel nearest to it.
  return CoveringHalo(grid, radius);
}

int CovarianceSampler::GetPadding() const
{
  const glm::dvec3 voxels = glm::abs(VoxelsPerRadius(this->Neighbourhood));
  return static_cast<int>(std::ceil(voxels.x)) + 1 + KernelPadding;
}

double CovarianceSampler::GetWorkPerVoxel() const
{
  const double slowness = this->Settings.Interpolated ? 3.0 : 1.0;
  switch (this->Settings.Pattern)
  {
    case Sampling::Exhaustive:
      return this->Fixed.size();
    case Sampling::PerVoxel:
      return this->Settings.NumberOfSamples * 60.0;
    default:
      return this->Settings.NumberOfSamples * slowness;
  }
}

std::vector<SampleOffset> CovarianceSampler::GetPattern(int x, int y, int z) const
{
  if (this->Settings.Pattern != Sampling::PerBlock)
  {
    return this->Fixed;
  }
  const std::uint64_t key = MixedPosition(Mixed(this->Settings.Seed), BlockOf(x), BlockOf(y), BlockOf(z));
  return MakePattern(
    this->Neighbourhood, this->Settings.NumberOfSamples, key, this->Settings.Interpolated);
}

void CovarianceSampler::SampleSegment(const VoxelBox<float>& scalars,
  const std::vector<SampleOffset>& pattern, int x0, int x1, int y, int z, CovarianceRows& rows,
  int firstX) const
{
  const CovarianceRow row =
    rows.GetRow(x0 - firstX, x1 - firstX, scalars.At(x0, y, z), this->Settings.Tolerance);
  if (this->Settings.Interpolated && this->Settings.Pattern != Sampling::Exhaustive)
  {
    const std::vector<LinearSample> samples = LinearSamples(scalars, pattern, x0, y, z);
    AccumulateLinear(row, samples.data(), samples.size());
  }
  else
  {
    const std::vector<NearestSample> samples = NearestSamples(scalars, pattern, x0, y, z);
    AccumulateNearest(row, samples.data(), samples.size());
  }
}

void CovarianceSampler::SampleVoxels(
  const VoxelBox<float>& scalars, int x0, int x1, int y, int z, CovarianceRows& rows) const
{
  const LiteralSampling literal(this->Neighbourhood, scalars, this->Settings);
  CovarianceRow row = rows.GetRow(0, x1 - x0, scalars.At(x0, y, z), this->Settings.Tolerance);
  for (int x = x0; x <= x1; ++x)
  {
    literal.Accumulate(row, x - x0, x, y, z);
  }
}

void CovarianceSampler::SampleTile(
  const VoxelBox<float>& scalars, const Extent& tile, std::vector<CovarianceRows>& rows) const
{
  const bool isPerBlock = this->Settings.Pattern == Sampling::PerBlock;
  for (int x0 = tile[0]; x0 <= tile[1];)
  {
    const int x1 = isPerBlock ? std::min((BlockOf(x0) + 1) * BlockSize - 1, tile[1]) : tile[1];
    const std::vector<SampleOffset> own =
      isPerBlock ? this->GetPattern(x0, tile[2], tile[4]) : std::vector<SampleOffset>();
    std::size_t row = 0;
    for (int z = tile[4]; z <= tile[5]; ++z)
    {
      for (int y = tile[2]; y <= tile[3]; ++y, ++row)
      {
        if (this->Settings.Pattern == Sampling::PerVoxel)
        {
          this->SampleVoxels(scalars, x0, x1, y, z, rows[row]);
        }
        else
        {
          this->SampleSegment(
            scalars, isPerBlock ? own : this->Fixed, x0, x1, y, z, rows[row], tile[0]);
        }
      }
    }
    x0 = x1 + 1;
  }
}
}
