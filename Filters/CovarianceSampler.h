// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Covariance of the neighbourhood of each voxel of a row, by any of the sampling patterns.

#ifndef CovarianceSampler_h
#define CovarianceSampler_h

#include "CovarianceKernel.h"
#include "SamplePattern.h"
#include "VoxelBox.h"

namespace volumeoptics
{
enum class Sampling
{
  Shared,
  PerBlock,
  PerVoxel,
  Exhaustive
};

struct CovarianceSettings
{
  double Radius;    // world length
  double Tolerance; // half width, of the scalars' unit
  int NumberOfSamples;
  Sampling Pattern;
  bool Interpolated;
  int Seed;
};

// C in the tangent basis of each voxel of a row, lengths in radii, with room for the kernel.
class CovarianceRows
{
public:
  explicit CovarianceRows(int length);

  // Of the first voxels of the row: unit or 0.
  void SetNormals(const glm::dvec3* normals, int count);
  CovarianceRow GetRow(int first, int last, const float* scalars, double tolerance);

  float GetAccepted(int voxel) const { return this->Numbers[8][voxel]; }
  glm::dvec3 GetTangentCovariance(int voxel) const; // theta theta, theta phi, phi phi

private:
  std::vector<float> Numbers[9];
};

class CovarianceSampler
{
public:
  // Patterns change from block to block of this many voxels a side (PerBlock).
  static const int BlockSize = 16;

  CovarianceSampler(const ImageGrid& grid, const CovarianceSettings& settings);

  // Room that the scalars need at the ends of their rows.
  int GetPadding() const;
  // Samples of a voxel, in units of the time that one of a row pattern takes.
  double GetWorkPerVoxel() const;

  // All rows of a tile that lies within one block in y and z.
  void SampleTile(
    const VoxelBox<float>& scalars, const Extent& tile, std::vector<CovarianceRows>& rows) const;

private:
  std::vector<SampleOffset> BlockPattern(const Extent& box) const;
  void SampleBox(const VoxelBox<float>& scalars, const std::vector<SampleOffset>& pattern, const Extent& box,
    int firstX, CovarianceRows* rows) const;
  void SampleVoxels(const VoxelBox<float>& scalars, const Extent& tile, CovarianceRows* rows) const;

  CovarianceSettings Settings;
  Ball Neighbourhood;
  std::vector<SampleOffset> Fixed; // Shared, Exhaustive
};
}

#endif
