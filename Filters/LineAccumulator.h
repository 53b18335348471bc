// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Sums of segments' coefficients in voxels. Lines come in portions; a portion's segments are clipped to
// the voxels, partitioned by brick in one pass, and summed brick by brick in double. Between portions the
// sums of occupied voxels are kept in float, so that memory depends on the grid and not on the lines.

#ifndef LineAccumulator_h
#define LineAccumulator_h

#include "CylinderProjection.h"
#include "LineExchange.h"
#include "LineGrid.h"
#include "LineInput.h"
#include "LineVoxels.h"

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <vector>

namespace volumeoptics
{
class Batches;
class ProcessGroup;

// What was left out or changed.
struct LineFaults
{
  long long NotFinite = 0;   // points, radii, types
  long long NotPositive = 0; // radii
  long long TooThick = 0;    // radii above the smallest edge of a voxel
  void Add(const LineFaults& other);
};

struct LineAccumulatorSettings
{
  LineGrid Grid;
  const HarmonicBasis* Basis = nullptr;
  double CoefficientTolerance = 0.0;
  bool ExactProduct = true;
  bool OnAllProcesses = true; // or on the first one
};

class LineAccumulator
{
public:
  static constexpr long long SegmentsOfPortion = 1 << 20;

  explicit LineAccumulator(const LineAccumulatorSettings& settings);

  // Line types 0 to 255 must have theirs before they are added.
  void SetProjection(int type, std::unique_ptr<CylinderProjection> projection);
  bool HasProjection(int type) const { return this->Types.count(type) > 0; }
  // False on abort.
  bool Add(const LineInput& input, Batches& batches, double progressAtEnd);
  std::set<int> GetTypes() const;
  // Compresses the sums of all processes together, which must have the same types; false on abort. Sums are
  // gone then.
  bool Finish(Batches& batches, double progressAtEnd, const ProcessGroup& processes,
    std::vector<int>& brickIndices, std::vector<LineTypeBricks>& bricks);
  const LineFaults& GetFaults() const { return this->Faults; }

private:
  // A segment's part in one voxel.
  struct Part
  {
    float Tangent[3];
    float Weight;
    float Color[3];
    unsigned short Place;
    unsigned char Type;
  };
  struct Portion
  {
    std::vector<Part> Parts;
    std::vector<unsigned int> Bricks;
    LineFaults Faults;
    std::map<int, LineBounds> Colors;
  };
  struct TypeSums
  {
    std::unique_ptr<CylinderProjection> Projection;
    std::vector<std::unique_ptr<LineSums>> Bricks;
    LineBounds Colors;
  };
  struct Workspace
  {
    std::vector<short> Slots;
    std::vector<int> Places;
    std::vector<double> Values;
    SegmentRow Row;
  };

  struct BrickRange
  {
    unsigned int Brick;
    std::size_t First, Last;
  };
  struct SharedBrick
  {
    BrickLabel Label;
    LineSums Sums;
  };

  void Clip(const LineInput& input, long long first, long long last, Portion& portion) const;
  void AddPart(const LineSegment& segment, Portion& portion) const;
  bool AddPortion(
    const LineInput& input, long long first, long long last, Batches& batches, double from, double to);
  void Partition(std::vector<Portion>& portions);
  void SumBrick(std::size_t range, Workspace& work);
  void SumType(TypeSums& type, int number, std::size_t range, Workspace& work) const;
  void Compress(const LineSums& sums, LineBrick& brick) const;
  void ShareEnergy(const float* sums, double* shares) const;
  void MarkKept(const float* sums, bool* isKept) const;
  double DepthWeight(double weight) const;
  void CompressVoxel(const float* sums, LineBrick& brick) const;

  bool FinishTogether(Batches& batches, double progressAtEnd, const ProcessGroup& processes,
    const std::vector<long long>& occupied, std::vector<LineTypeBricks>& bricks);
  std::vector<SharedBrick> Collect(
    const ProcessGroup& processes, const std::vector<long long>& occupied, const BrickRange& range);
  std::vector<char> BytesFor(int owner, const ProcessGroup& processes, const std::vector<long long>& occupied,
    const BrickRange& range);
  std::size_t SizeOfVoxel() const;
  std::vector<long long> NumberBricks(const ProcessGroup& processes, std::vector<int>& brickIndices) const;
  void MakeSets(const ProcessGroup& processes, std::size_t occupied, std::vector<LineTypeBricks>& bricks);

  LineAccumulatorSettings Settings;
  std::map<int, TypeSums> Types;
  LineFaults Faults;
  // of the current portion, sorted by brick
  std::vector<BrickRange> Ranges;
  std::vector<Part> Parts;
  std::vector<std::size_t> Counts;
};
}

#endif
