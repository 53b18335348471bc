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

NearestSample MakeNearest(const VoxelBox<float>& scalars, const SampleOffset& offset)
{
  return { scalars.Offset(offset.Voxel[0], offset.Voxel[1], offset.Voxel[2]),
    { offset.World[0], offset.World[1], offset.World[2] } };
}

// Corners of weight 0 read what another corner reads, so that no missing value gets in.
LinearSample MakeLinear(const VoxelBox<float>& scalars, const SampleOffset& offset)
{
  LinearSample sample;
  std::copy(offset.World, offset.World + 3, sample.World);
  for (int corner = 0; corner < 8; ++corner)
  {
    float weight = 1.0f;
    int place[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const bool isNext = corner >> axis & 1;
      const float fraction = offset.Fraction[axis];
      weight *= isNext ? fraction : 1.0f - fraction;
      place[axis] = offset.Voxel[axis] + (isNext && fraction > 0.0f ? 1 : 0);
    }
    sample.Offsets[corner] = scalars.Offset(place[0], place[1], place[2]);
    sample.Weights[corner] = weight;
  }
  return sample;
}

// Without a branch: at the volume's border each sample of a pattern is asked for each row.
bool IsInside(const Extent& box, const SampleOffset& offset, int y, int z)
{
  const int firstY = y + offset.Voxel[1];
  const int firstZ = z + offset.Voxel[2];
  const int lastY = firstY + (offset.Fraction[1] > 0.0f ? 1 : 0);
  const int lastZ = firstZ + (offset.Fraction[2] > 0.0f ? 1 : 0);
  return int(firstY >= box[2]) & int(lastY <= box[3]) & int(firstZ >= box[4]) & int(lastZ <= box[5]);
}

// Samples in a row of memory.
template <typename Sample>
struct SampleRange
{
  const Sample* First;
  std::size_t Count;
};

// A pattern in terms of the kernel.
template <typename Sample>
class KernelSamples
{
public:
  template <typename Make>
  KernelSamples(const VoxelBox<float>& scalars, const std::vector<SampleOffset>& pattern, Make make)
    : Pattern(pattern)
    , Scalars(scalars)
  {
    this->All.reserve(pattern.size());
    for (const SampleOffset& offset : pattern)
    {
      this->All.push_back(make(scalars, offset));
      for (int axis = 1; axis < 3; ++axis)
      {
        this->Reach[axis] = std::max(this->Reach[axis], std::abs(offset.Voxel[axis]) + 1);
      }
    }
  }

  // Those for a row, valid until the next call: samples outside the volume in y or z are left out.
  SampleRange<Sample> ForRow(int y, int z)
  {
    const Extent& box = this->Scalars.GetBox();
    if (y - this->Reach[1] >= box[2] && y + this->Reach[1] <= box[3] && z - this->Reach[2] >= box[4] &&
      z + this->Reach[2] <= box[5])
    {
      return { this->All.data(), this->All.size() };
    }
    this->Some.resize(this->All.size());
    std::size_t count = 0;
    for (std::size_t i = 0; i < this->All.size(); ++i)
    {
      this->Some[count] = this->All[i];
      count += IsInside(box, this->Pattern[i], y, z);
    }
    return { this->Some.data(), count };
  }

private:
  const std::vector<SampleOffset>& Pattern;
  const VoxelBox<float>& Scalars;
  std::vector<Sample> All;
  std::vector<Sample> Some;
  int Reach[3] = { 0, 0, 0 };
};

// The rows of a box of one pattern.
template <typename Sample, typename Accumulate>
void AccumulateBox(KernelSamples<Sample> samples, const VoxelBox<float>& scalars, const Extent& box,
  int firstX, double tolerance, CovarianceRows* rows, Accumulate accumulate)
{
  for (int z = box[4]; z <= box[5]; ++z)
  {
    for (int y = box[2]; y <= box[3]; ++y, ++rows)
    {
      const SampleRange<Sample> used = samples.ForRow(y, z);
      const CovarianceRow row =
        rows->GetRow(box[0] - firstX, box[1] - firstX, scalars.At(box[0], y, z), tolerance);
      accumulate(row, used.First, used.Count);
    }
  }
}
}

CovarianceRows::CovarianceRows(int length)
{
  for (std::vector<float>& numbers : this->Numbers)
  {
    numbers.assign(length + KernelPadding, 0.0f);
  }
}

void CovarianceRows::SetNormals(const glm::dvec3* normals, int count)
{
  for (int voxel = 0; voxel < count; ++voxel)
  {
    if (normals[voxel] == glm::dvec3(0.0))
    {
      continue;
    }
    const optics::TangentBasis basis = optics::SphericalBasis(normals[voxel]);
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Numbers[axis][voxel] = static_cast<float>(basis.theta[axis]);
    }
    this->Numbers[3][voxel] = static_cast<float>(basis.phi.x);
    this->Numbers[4][voxel] = static_cast<float>(basis.phi.y);
  }
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
  : Settings(settings)
  , Neighbourhood{ grid, settings.Radius }
{
  if (settings.Pattern == Sampling::Exhaustive)
  {
    this->Fixed = MakeExhaustivePattern(this->Neighbourhood);
  }
  else if (settings.Pattern == Sampling::Shared)
  {
    this->Fixed =
      MakePattern(this->Neighbourhood, settings.NumberOfSamples, Mixed(settings.Seed), settings.Interpolated);
  }
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

std::vector<SampleOffset> CovarianceSampler::BlockPattern(const Extent& box) const
{
  const std::uint64_t key =
    MixedPosition(Mixed(this->Settings.Seed), BlockOf(box[0]), BlockOf(box[2]), BlockOf(box[4]));
  return MakePattern(this->Neighbourhood, this->Settings.NumberOfSamples, key, this->Settings.Interpolated);
}

void CovarianceSampler::SampleBox(const VoxelBox<float>& scalars, const std::vector<SampleOffset>& pattern,
  const Extent& box, int firstX, CovarianceRows* rows) const
{
  const double tolerance = this->Settings.Tolerance;
  if (this->Settings.Interpolated && this->Settings.Pattern != Sampling::Exhaustive)
  {
    AccumulateBox(KernelSamples<LinearSample>(scalars, pattern, MakeLinear), scalars, box, firstX, tolerance,
      rows, AccumulateLinear);
  }
  else
  {
    AccumulateBox(KernelSamples<NearestSample>(scalars, pattern, MakeNearest), scalars, box, firstX,
      tolerance, rows, AccumulateNearest);
  }
}

void CovarianceSampler::SampleVoxels(
  const VoxelBox<float>& scalars, const Extent& tile, CovarianceRows* rows) const
{
  const LiteralSampling literal(this->Neighbourhood, scalars, this->Settings);
  for (int z = tile[4]; z <= tile[5]; ++z)
  {
    for (int y = tile[2]; y <= tile[3]; ++y, ++rows)
    {
      CovarianceRow row =
        rows->GetRow(0, tile[1] - tile[0], scalars.At(tile[0], y, z), this->Settings.Tolerance);
      for (int x = tile[0]; x <= tile[1]; ++x)
      {
        literal.Accumulate(row, x - tile[0], x, y, z);
      }
    }
  }
}

void CovarianceSampler::SampleTile(
  const VoxelBox<float>& scalars, const Extent& tile, std::vector<CovarianceRows>& rows) const
{
  if (this->Settings.Pattern == Sampling::PerVoxel)
  {
    this->SampleVoxels(scalars, tile, rows.data());
    return;
  }
  if (this->Settings.Pattern != Sampling::PerBlock)
  {
    this->SampleBox(scalars, this->Fixed, tile, tile[0], rows.data());
    return;
  }
  // From left to right: the kernel's last lanes may write beyond a block.
  Extent box = tile;
  for (box[0] = tile[0]; box[0] <= tile[1]; box[0] = box[1] + 1)
  {
    box[1] = std::min((BlockOf(box[0]) + 1) * BlockSize - 1, tile[1]);
    this->SampleBox(scalars, this->BlockPattern(box), box, tile[0], rows.data());
  }
}
}
