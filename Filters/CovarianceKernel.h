// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The inner loops of vtkAmbientCovarianceFilter: one row of voxels, one pattern of samples for all.

#ifndef CovarianceKernel_h
#define CovarianceKernel_h

#include <cstddef>

namespace volumeoptics
{
// The loops read and write up to this many numbers beyond the end of a row.
const int KernelPadding = 16;

// Per voxel of the row, one array each. A voxel without a normal has a basis of zeros.
struct CovarianceRow
{
  int Count;
  float Tolerance;       // half width of the accepted scalars
  const float* Scalars;  // of the voxels themselves; NaN for no value
  const float* Theta[3]; // the tangent basis in world axes
  const float* Phi[2];   // its z is 0
  float* ThetaTheta;     // sums of C, lengths in radii
  float* ThetaPhi;
  float* PhiPhi;
  float* Accepted; // number of accepted samples
};

// Offsets are in numbers from the voxel's own scalar.
struct NearestSample
{
  std::ptrdiff_t Offset;
  float World[3]; // in radii
};

struct LinearSample
{
  std::ptrdiff_t Offsets[8]; // of the corners
  float Weights[8];
  float World[3];
};

// Two passes: which samples are accepted and where their centroid is; then C about the centroid of
// the projected samples with the exact weight max(0, 1 - d^2), so that C is never negative.
// [Ament2015] eqs 18-25. Instruction set chosen at run time (Highway).
void AccumulateNearest(const CovarianceRow& row, const NearestSample* samples, std::size_t count);
void AccumulateLinear(const CovarianceRow& row, const LinearSample* samples, std::size_t count);

// Name of the instruction set in use.
const char* KernelInstructionSet();
}

#endif
