// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Where the neighbourhood of a voxel is sampled: points of a ball in world space.

#ifndef SamplePattern_h
#define SamplePattern_h

#include "ImageGrid.h"

#include <cmath>
#include <cstdint>
#include <vector>

namespace volumeoptics
{
struct Ball
{
  const ImageGrid& Grid;
  double Radius; // world length, > 0
};

struct SampleOffset
{
  int Voxel[3];      // index offset of the sample; with fractions, of the corner below it
  float Fraction[3]; // towards the next voxel; 0 for nearest samples
  float World[3];    // offset in world axes, in radii
};

// A well mixed 64-bit number of a key (splitmix64).
inline std::uint64_t Mixed(std::uint64_t key)
{
  key += 0x9e3779b97f4a7c15ULL;
  key = (key ^ (key >> 30)) * 0xbf58476d1ce4e5b9ULL;
  key = (key ^ (key >> 27)) * 0x94d049bb133111ebULL;
  return key ^ (key >> 31);
}

inline std::uint64_t MixedPosition(std::uint64_t seed, int x, int y, int z)
{
  const std::uint64_t upper = Mixed(seed ^ static_cast<std::uint32_t>(z));
  return Mixed(Mixed(upper ^ static_cast<std::uint32_t>(y)) ^ static_cast<std::uint32_t>(x));
}

// Uniform in the unit ball for a, b, c uniform in [0, 1). [Ament2015] eqs 14-17.
template <typename Number>
glm::vec<3, Number> PointInBall(Number a, Number b, Number c)
{
  const Number distance = std::cbrt(a);
  const Number cosine = Number(1) - Number(2) * b;
  const Number sine = std::sqrt(std::max(Number(1) - cosine * cosine, Number(0)));
  const Number azimuth = Number(6.283185307179586) * c;
  return distance * glm::vec<3, Number>(sine * std::cos(azimuth), sine * std::sin(azimuth), cosine);
}

// Index offset per axis of a world offset of one radius; 0 along an axis of one voxel, where the
// ball becomes a disk.
glm::dvec3 VoxelsPerRadius(const Ball& ball);

// World offset in radii of an index offset.
glm::dvec3 WorldOffset(const Ball& ball, const glm::dvec3& voxels);

// `count` points of low discrepancy, shifted by a number that the key gives. interpolated: at their
// exact places, to be interpolated; else moved to the nearest voxels.
std::vector<SampleOffset> MakePattern(const Ball& ball, int count, std::uint64_t key, bool interpolated);

// Every voxel of the ball, the centre included.
std::vector<SampleOffset> MakeExhaustivePattern(const Ball& ball);
}

#endif
