// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Row arithmetic of voxelization. Instruction set chosen at run time (Highway).

#ifndef LineKernel_h
#define LineKernel_h

namespace volumeoptics
{
// Four entries of a table, each [harmonic][body red, green, blue, 0, highlight red, green, blue, 0].
struct TableCorners
{
  const float* Entries[4];
  float Weights[4];
};
constexpr int ChannelsOfTable = 8;

// row[harmonic][4] += color * body + highlight, interpolated. color: red, green, blue, 0.
void AddInterpolated(const TableCorners& corners, const float color[4], int harmonics, float* row);

// sums += factor * row. count: a multiple of 4.
void AddScaled(const float* row, double factor, int count, double* sums);
}

#endif
