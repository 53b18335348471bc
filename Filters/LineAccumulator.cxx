// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LineAccumulator.h"

#include "Batches.h"
#include "Optics.h"
#include "ProcessGroup.h"

#include "vtkSMPThreadLocal.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

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
    part.Weight = static_cast<float>(this->DepthWeight(weight * share));
    part.Place = static_cast<unsigned short>(grid.PlaceInBrick(voxel));
    portion.Parts.push_back(part);
    portion.Bricks.push_back(static_cast<unsigned int>(grid.BrickOf(voxel)));
  });
  if (portion.Parts.size() > before)
  {
    portion.Colors[segment.Type].Add(segment.Color);
  }
}

// What a part's area is worth in a sum of depths: [Schussman2004] eq. 7 multiplies 1 - q of its parts, so
// that their depths -ln(1 - q) add up, with the ratio to q of the mean over all directions. A part that
// covers the voxel is as deep as one that just does.
double LineAccumulator::DepthWeight(double weight) const
{
  const double quarterSurface = this->Settings.Grid.Surface() / 4.0;
  return this->Settings.ExactProduct ? optics::MeanDepthOfShare(std::min(weight / quarterSurface, 1.0)) *
      quarterSurface * 2.0 / optics::QuarterTurn
                                     : weight;
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
  const std::size_t size = this->SizeOfVoxel();
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
  const std::size_t size = this->SizeOfVoxel();
  work.Row.Tangent = glm::dvec3(0.0); // another type's lights
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
    type.Projection->SetSegment({ part.Tangent[0], part.Tangent[1], part.Tangent[2] },
      { part.Color[0], part.Color[1], part.Color[2] }, work.Row);
    type.Projection->Add(work.Row, part.Weight, &work.Values[slot * size]);
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
  return static_cast<std::size_t>(this->Settings.Basis->GetCount()) * LineChannels;
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
  const std::size_t size = this->SizeOfVoxel();
  for (std::size_t place = 0; place < sums.Slots.size(); ++place)
  {
    if (sums.Slots[place] >= 0)
    {
      brick.Places.push_back(static_cast<unsigned short>(place));
      this->CompressVoxel(&sums.Values[sums.Slots[place] * size], brick);
    }
  }
}

// Of each harmonic: its share of the energy of colour or area, the larger of these.
void LineAccumulator::ShareEnergy(const float* sums, double* shares) const
{
  const int count = this->Settings.Basis->GetCount();
  double colors[HarmonicBasis::LargestCount], areas[HarmonicBasis::LargestCount];
  double color = 0.0, area = 0.0;
  for (int i = 0; i < count; ++i)
  {
    const float* value = sums + LineChannels * i;
    colors[i] = 1.0 * value[0] * value[0] + 1.0 * value[1] * value[1] + 1.0 * value[2] * value[2];
    areas[i] = 1.0 * value[AreaChannel] * value[AreaChannel];
    color += colors[i];
    area += areas[i];
  }
  const double ofColor = color > 0.0 ? 1.0 / color : 0.0, ofArea = area > 0.0 ? 1.0 / area : 0.0;
  for (int i = 0; i < count; ++i)
  {
    shares[i] = std::max(colors[i] * ofColor, areas[i] * ofArea);
  }
}

// Leaves the smallest coefficients out, as long as each of colour and area loses at most the tolerance of
// its energy; and those that are 0. The mean area stays.
void LineAccumulator::MarkKept(const float* sums, bool* isKept) const
{
  const int count = this->Settings.Basis->GetCount();
  double shares[HarmonicBasis::LargestCount];
  this->ShareEnergy(sums, shares);
  std::fill_n(isKept, count, true);
  int small[HarmonicBasis::LargestCount], *last = small;
  for (int i = 1; i < count; ++i)
  {
    if (shares[i] <= this->Settings.CoefficientTolerance)
    {
      *last++ = i;
    }
  }
  std::sort(
    small, last, [&](int a, int b) { return shares[a] < shares[b] || (shares[a] == shares[b] && a < b); });
  double dropped = 0.0;
  for (const int* i = small; i < last && dropped + shares[*i] <= this->Settings.CoefficientTolerance; ++i)
  {
    dropped += shares[*i];
    isKept[*i] = false;
  }
}

void LineAccumulator::CompressVoxel(const float* sums, LineBrick& brick) const
{
  const HarmonicBasis& basis = *this->Settings.Basis;
  bool isKept[HarmonicBasis::LargestCount];
  this->MarkKept(sums, isKept);
  const float scale = static_cast<float>(4.0 / this->Settings.Grid.Surface());
  const std::size_t before = brick.Harmonics.size();
  for (int i = 0; i < basis.GetCount(); ++i)
  {
    if (isKept[i])
    {
      const float* value = sums + LineChannels * i;
      const float scaled[LineChannels] = { value[0] * scale, value[1] * scale, value[2] * scale,
        value[3] * scale };
      brick.Harmonics.push_back(static_cast<unsigned char>(basis.GetIndex(i)));
      brick.Values.insert(brick.Values.end(), scaled, scaled + LineChannels);
    }
  }
  brick.Counts.push_back(static_cast<int>(brick.Harmonics.size() - before));
}
}
