// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Visibility of a cone slice by slice, in double: the sweep of fixed directions, and the recursion over disks
// of [Schott2009]. What a froxel grid on the GPU is compared with, and how far the algorithms themselves are
// from the truth, without their arithmetic.

#ifndef FroxelSweep_h
#define FroxelSweep_h

#include "ConeIntegral.h"

#include <array>
#include <vector>

namespace reference
{
// Slices across an axis, from the open end on. Places are coordinates along right and up, divided by the
// distance from the origin along the axis (perspective) or not (parallel): those of a pixel are the same on all
// slices.
struct SliceFrame
{
  Vector origin; // the eye; a point on the axis where parallel
  Vector right, up;
  Vector away; // along the axis, from the open end
  bool isPerspective = false;
  glm::dvec2 lowest, highest; // places of the grid's borders
  double front = 0.0;         // distances of the first and last slice's outer sides
  double back = 1.0;

  double WidthAt(double distance) const { return this->isPerspective ? distance : 1.0; }
  Vector PointAt(const glm::dvec2& place, double distance) const;
  // x, y: place; z: distance.
  Vector ToPlace(const Vector& point) const;
};

// Of the camera of a scene, around all of its volume that is in front of the near plane. Where the camera is in
// the volume: as wide as the window.
SliceFrame FrameOfCamera(const Scene& scene);

// Columns, rows and slices of a grid with so many froxels along its longer side, whose slices are apart by
// sliceDistance sides of a froxel half-way through.
std::array<int, 3> FroxelsOf(const SliceFrame& frame, int size, double sliceDistance);

enum class SweepAlgorithm
{
  Directions = 0,  // fixed ones of equal solid angle
  Disk,            // [Schott2009]: the mean over the cone's base
  DiskBySolidAngle // weighted by the solid angle of the base's pieces
};

// What the cone's axis is, in perspective. A direction's rays are straight in the first two.
enum class SweepAxis
{
  SliceNormal = 0, // the same for all pixels: parallel rays
  Eye,  // rays of a direction meet in one point on the eye's plane: exact on one slice, the middle one
  Pixel // the direction to the eye, another one at each place: rays bend a little
};

// What of its own slice takes light from a sample.
enum class OwnOpacity
{
  None = 0,  // as published: too bright by a slice
  HalfSlice, // known at the froxels
  AlongRay, // what the eye's ray meets from the slice in front on, as the mapper takes it where it does not gather
  Gathered // of each direction what its ray meets, as the mapper gathers it
};

struct SweepSettings
{
  SweepAlgorithm algorithm = SweepAlgorithm::Directions;
  SweepAxis axis = SweepAxis::SliceNormal;
  double angle = 60.0;       // half angle in degrees
  int samples = 8;           // directions, or points along a side of the disk's grid
  bool trueDistances = true; // of the disk: Algorithm 2, else 3
  OwnOpacity own = OwnOpacity::HalfSlice;
  int gatherSamples = 4;                       // of a direction's ray
  std::array<int, 3> froxels = { 64, 64, 64 }; // columns, rows, slices
};

class FroxelSweep
{
public:
  FroxelSweep(const Occluders& occluders, const SliceFrame& frame, const SweepSettings& settings);

  // Of a froxel.
  double Value(int column, int row, int slice) const
  {
    return this->Values[(static_cast<std::size_t>(slice) * this->Settings.froxels[1] + row) *
        this->Settings.froxels[0] +
      column];
  }
  Vector Center(int column, int row, int slice) const;
  // Interpolated between the centres of froxels, as a linear texture that is clamped to its edge; with
  // OwnOpacity::AlongRay what reaches the slice in front.
  double At(const Vector& point) const;
  std::vector<double> At(const Occluders& occluders, const std::vector<ShownPoint>& points) const;

private:
  struct Channel;
  using Layer = std::vector<double>; // of one channel

  std::vector<Channel> ChannelsOf() const;
  double SliceDistance() const { return (this->Frame.back - this->Frame.front) / this->Settings.froxels[2]; }
  double DistanceOf(int slice) const;
  glm::dvec2 PlaceOf(int column, int row) const;
  double Fetch(const Layer& layer, const glm::dvec2& place) const;
  double Interpolate(const Layer& values, const Vector& point, double ahead) const;
  double Gather(const Occluders& occluders, const std::vector<Channel>& channels, const Vector& point) const;
  glm::dvec2 SlopeAt(const glm::dvec2& place, const Channel& channel, int slice) const;
  void SweepRow(int slice, int row, const std::vector<double>& depths, const std::vector<Channel>& channels,
    const std::vector<Layer>& former, std::vector<Layer>& next);

  SliceFrame Frame;
  SweepSettings Settings;
  std::vector<double> Values;
  std::vector<Layer> Reaching; // the middle of each froxel, by direction; where it is gathered
};
}

#endif
