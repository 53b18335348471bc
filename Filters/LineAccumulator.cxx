// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LineAccumulator.h"

#include "Batches.h"
#include "ProcessGroup.h"

#include "vtkSMPThreadLocal.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace volumeoptics
{
namespace
{
const long long SegmentsOfUnit = 8192;
}

void LineFaults::Add(const LineFaults& other)
{
  this->NotFinite += other.NotFinite;
  this->NotPositive += other.NotPositive;
  this->TooThick += other.TooThick;
}

LineAccumulator::LineAccumulator(const LineAccumulatorSettings& settings)
  : Settings(settings)
  , Counts(settings.Grid.NumberOfBricks() + 1, 0)
{
}

void LineAccumulator::SetProjection(int type, std::unique_ptr<CylinderProjection> projection)
{
  TypeSums& sums = this->Types[type];
  sums.Projection = std::move(projection);
  sums.Bricks.resize(this->Settings.Grid.NumberOfBricks());
}

bool LineAccumulator::Add(const LineInput& input, Batches& batches, double progressAtEnd)
{
  const long long count = input.GetNumberOfSegments();
  const double start = batches.GetProgress();
  for (long long first = 0; first < count; first += SegmentsOfPortion)
  {
    const long long last = std::min(first + SegmentsOfPortion, count);
    const double length = progressAtEnd - start;
    if (!this->AddPortion(
          input, first, last, batches, start + length * first / count, start + length * last / count))
    {
      return false;
    }
  }
  return true;
}

bool LineAccumulator::AddPortion(
  const LineInput& input, long long first, long long last, Batches& batches, double from, double to)
{
  std::vector<Portion> portions((last - first + SegmentsOfUnit - 1) / SegmentsOfUnit);
  const bool isClipped =
    batches.Run(static_cast<long long>(portions.size()), (from + to) / 2.0, [&](long long unit) {
      const long long begin = first + unit * SegmentsOfUnit;
      this->Clip(input, begin, std::min(begin + SegmentsOfUnit, last), portions[unit]);
    });
  if (!isClipped)
  {
    return false;
  }
  this->Partition(portions);
  vtkSMPThreadLocal<Workspace> workspaces;
  return batches.Run(static_cast<long long>(this->Ranges.size()), to,
    [&](long long range) { this->SumBrick(range, workspaces.Local()); });
}

void LineAccumulator::Clip(const LineInput& input, long long first, long long last, Portion& portion) const
{
  portion.Parts.reserve(2 * (last - first));
  portion.Bricks.reserve(2 * (last - first));
  input.ForEachSegment(first, last, [&](const LineSegment& segment) { this->AddPart(segment, portion); });
}

void LineAccumulator::AddPart(const LineSegment& segment, Portion& portion) const
{
  const LineGrid& grid = this->Settings.Grid;
  const glm::dvec3 way = segment.End - segment.Begin;
  const double length = glm::length(way);
  if (!std::isfinite(length) || !std::isfinite(segment.Radius) || segment.Type < 0)
  {
    ++portion.Faults.NotFinite;
    return;
  }
  if (segment.Radius <= 0.0)
  {
    ++portion.Faults.NotPositive;
    return;
  }
  portion.Faults.TooThick += segment.Radius > grid.SmallestEdge();
  if (length == 0.0)
  {
    return;
  }
  const double weight = 2.0 * std::min(segment.Radius, grid.SmallestEdge()) * length;
  const glm::vec3 tangent(way / length), color(segment.Color);
  Part part{ { tangent.x, tangent.y, tangent.z }, 0.0F, { color.x, color.y, color.z }, 0,
    static_cast<unsigned char>(segment.Type) };
  const std::size_t before = portion.Parts.size();
  GridTraversal(grid, segment.Begin, segment.End).ForEachVoxel([&](const glm::ivec3& voxel, double share) {
    part.Weight = static_cast<float>(weight * share);
    part.Place = static_cast<unsigned short>(grid.PlaceInBrick(voxel));
    portion.Parts.push_back(part);
    portion.Bricks.push_back(static_cast<unsigned int>(grid.BrickOf(voxel)));
  });
  if (portion.Parts.size() > before)
  {
    portion.Colors[segment.Type].Add(segment.Color);
  }
}

// By counting: parts of a brick stay in the order of their segments.
void LineAccumulator::Partition(std::vector<Portion>& portions)
{
  std::fill(this->Counts.begin(), this->Counts.end(), 0);
  for (const Portion& portion : portions)
  {
    this->Faults.Add(portion.Faults);
    for (const auto& [type, colors] : portion.Colors)
    {
      this->Types[type].Colors.Add(colors);
    }
    for (unsigned int brick : portion.Bricks)
    {
      ++this->Counts[brick];
    }
  }
  this->Ranges.clear();
  std::size_t sum = 0;
  for (std::size_t brick = 0; brick < this->Counts.size(); ++brick)
  {
    const std::size_t count = this->Counts[brick];
    if (count > 0)
    {
      this->Ranges.push_back({ static_cast<unsigned int>(brick), sum, sum + count });
    }
    this->Counts[brick] = sum;
    sum += count;
  }
  this->Parts.resize(sum);
  for (Portion& portion : portions)
  {
    for (std::size_t i = 0; i < portion.Parts.size(); ++i)
    {
      this->Parts[this->Counts[portion.Bricks[i]]++] = portion.Parts[i];
    }
    portion = Portion();
  }
}

void LineAccumulator::SumBrick(std::size_t range, Workspace& work)
{
  const int places = this->Settings.Grid.VoxelsOfBrick();
  const std::size_t size =
    static_cast<std::size_t>(this->Settings.Basis->GetCount()) * this->Settings.Channels;
  work.Slots.resize(places);
  work.Values.resize(places * size);
  for (auto& [number, type] : this->Types)
  {
    std::fill(work.Slots.begin(), work.Slots.end(), static_cast<short>(-1));
    work.Places.clear();
    this->SumType(type, number, range, work);
    if (work.Places.empty())
    {
      continue;
    }
    std::unique_ptr<LineSums>& kept = type.Bricks[this->Ranges[range].Brick];
    if (!kept)
    {
      kept = std::make_unique<LineSums>();
      kept->Slots.assign(places, -1);
    }
    for (std::size_t i = 0; i < work.Places.size(); ++i)
    {
      float* to = kept->At(work.Places[i], size);
      std::transform(&work.Values[i * size], &work.Values[i * size] + size, to, to,
        [](double added, float sum) { return static_cast<float>(sum + added); });
    }
  }
}

void LineAccumulator::SumType(TypeSums& type, int number, std::size_t range, Workspace& work) const
{
  const HarmonicBasis& basis = *this->Settings.Basis;
  const std::size_t size = static_cast<std::size_t>(basis.GetCount()) * this->Settings.Channels;
  double values[HarmonicBasis::LargestCount];
  glm::dvec3 last(0.0);
  for (std::size_t i = this->Ranges[range].First; i < this->Ranges[range].Last; ++i)
  {
    const Part& part = this->Parts[i];
    if (part.Type != number)
    {
      continue;
    }
    short& slot = work.Slots[part.Place];
    if (slot < 0)
    {
      slot = static_cast<short>(work.Places.size());
      work.Places.push_back(part.Place);
      std::fill_n(&work.Values[slot * size], size, 0.0);
    }
    const ProjectedSegment segment{ { part.Tangent[0], part.Tangent[1], part.Tangent[2] },
      { part.Color[0], part.Color[1], part.Color[2] }, part.Weight };
    if (segment.Tangent != last)
    {
      basis.Evaluate(segment.Tangent, values);
      last = segment.Tangent;
    }
    type.Projection->Add(segment, values, &work.Values[slot * size]);
  }
}

std::set<int> LineAccumulator::GetTypes() const
{
  std::set<int> types;
  for (const auto& type : this->Types)
  {
    types.insert(type.first);
  }
  return types;
}

std::size_t LineAccumulator::SizeOfVoxel() const
{
  return static_cast<std::size_t>(this->Settings.Basis->GetCount()) * this->Settings.Channels;
}

// Numbers the bricks that one of the processes has something of.
std::vector<long long> LineAccumulator::NumberBricks(
  const ProcessGroup& processes, std::vector<int>& brickIndices) const
{
  const long long count = this->Settings.Grid.NumberOfBricks();
  std::vector<unsigned char> isOccupied(count);
  for (long long brick = 0; brick < count; ++brick)
  {
    isOccupied[brick] = std::any_of(
      this->Types.begin(), this->Types.end(), [&](const auto& type) { return !!type.second.Bricks[brick]; });
  }
  processes.Largest(isOccupied);
  brickIndices.assign(count, -1);
  std::vector<long long> occupied;
  for (long long brick = 0; brick < count; ++brick)
  {
    if (isOccupied[brick])
    {
      brickIndices[brick] = static_cast<int>(occupied.size());
      occupied.push_back(brick);
    }
  }
  return occupied;
}

void LineAccumulator::MakeSets(
  const ProcessGroup& processes, std::size_t occupied, std::vector<LineTypeBricks>& bricks)
{
  for (auto& type : this->Types)
  {
    bricks.emplace_back();
    bricks.back().Type = type.first;
    bricks.back().Channels = this->Settings.Channels;
    bricks.back().Bricks.resize(occupied);
    LineBounds& colors = type.second.Colors;
    processes.Least(&colors.Least.x, 3);
    processes.Largest(&colors.Largest.x, 3);
    if (!colors.IsEmpty())
    {
      bricks.back().ColorRange = type.second.Projection->ColorRange(colors.Least, colors.Largest);
    }
  }
}

bool LineAccumulator::Finish(Batches& batches, double progressAtEnd, const ProcessGroup& processes,
  std::vector<int>& brickIndices, std::vector<LineTypeBricks>& bricks)
{
  const std::vector<long long> occupied = this->NumberBricks(processes, brickIndices);
  this->MakeSets(processes, occupied.size(), bricks);
  if (processes.IsShared())
  {
    return this->FinishTogether(batches, progressAtEnd, processes, occupied, bricks);
  }
  return batches.Run(static_cast<long long>(occupied.size()), progressAtEnd, [&](long long i) {
    std::size_t set = 0;
    for (auto& type : this->Types)
    {
      LineBrick& brick = bricks[set++].Bricks[i];
      if (std::unique_ptr<LineSums>& sums = type.second.Bricks[occupied[i]])
      {
        this->Compress(*sums, brick);
        sums.reset();
      }
    }
  });
}

void LineAccumulator::Compress(const LineSums& sums, LineBrick& brick) const
{
  const std::size_t size =
    static_cast<std::size_t>(this->Settings.Basis->GetCount()) * this->Settings.Channels;
  for (std::size_t place = 0; place < sums.Slots.size(); ++place)
  {
    if (sums.Slots[place] >= 0)
    {
      brick.Places.push_back(static_cast<unsigned short>(place));
      this->CompressVoxel(&sums.Values[sums.Slots[place] * size], brick);
    }
  }
}

// Of each harmonic: its share of the energy of colour, area or product, the largest of these.
void LineAccumulator::ShareEnergy(const float* sums, double* shares) const
{
  const int channels = this->Settings.Channels, count = this->Settings.Basis->GetCount();
  const auto energyOf = [&](int harmonic, int first, int last) {
    const float* values = sums + harmonic * channels;
    return std::inner_product(values + first, values + last, values + first, 0.0);
  };
  const int groups[4] = { 0, AreaChannel, ProductChannel, channels };
  std::fill_n(shares, count, 0.0);
  for (int group = 0; group < channels - 2; ++group)
  {
    double whole = 0.0;
    for (int i = 0; i < count; ++i)
    {
      whole += energyOf(i, groups[group], groups[group + 1]);
    }
    for (int i = 0; i < count && whole > 0.0; ++i)
    {
      shares[i] = std::max(shares[i], energyOf(i, groups[group], groups[group + 1]) / whole);
    }
  }
}

// Leaves the smallest coefficients out, as long as each of colour, area and product loses at most the
// tolerance of its energy; and those that are 0. The mean area stays.
void LineAccumulator::CompressVoxel(const float* sums, LineBrick& brick) const
{
  const HarmonicBasis& basis = *this->Settings.Basis;
  const int channels = this->Settings.Channels, count = basis.GetCount();
  double shares[HarmonicBasis::LargestCount];
  this->ShareEnergy(sums, shares);
  shares[0] = 2.0;
  int order[HarmonicBasis::LargestCount];
  std::iota(order, order + count, 0);
  std::sort(order, order + count,
    [&](int a, int b) { return shares[a] < shares[b] || (shares[a] == shares[b] && a < b); });
  double dropped = 0.0;
  int first = 0;
  while (first < count && dropped + shares[order[first]] <= this->Settings.CoefficientTolerance)
  {
    dropped += shares[order[first++]];
  }
  std::sort(order + first, order + count);
  const float scale = static_cast<float>(4.0 / this->Settings.Grid.Surface());
  for (int i = first; i < count; ++i)
  {
    brick.Harmonics.push_back(static_cast<unsigned char>(basis.GetIndex(order[i])));
    for (int c = 0; c < channels; ++c)
    {
      brick.Values.push_back(sums[order[i] * channels + c] * scale);
    }
  }
  brick.Counts.push_back(count - first);
}
}
