// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The numbers of vtkPreIntegratedTable.

#ifndef PreIntegration_h
#define PreIntegration_h

#include "TransferFunctionStretches.h"

#include <vector>

namespace volumeoptics
{
// Larger attenuations, which only an extreme unit interval makes, count as this: a float holds it, and its
// products with lengths.
constexpr double LargestAttenuation = 1.0e30;

// Writes a table of size x size entries of {colour, mean attenuation}, see vtkPreIntegratedTable. All rows
// together make the table; they may be written from any number of threads.
class PreIntegration
{
public:
  PreIntegration(const TransferFunctions& functions, int size);

  // Data space.
  void WriteRow(int row, float* table) const;
  // Physical space, segments of the given length.
  void WriteRow(int row, double length, float* table) const;

  std::vector<float> Cumulative() const;
  std::vector<float> DepthsBehind() const;

private:
  float* EntryOf(int front, int back, float* table) const;
  void MakeHalfCells();
  void MakeBlocks();
  Stretch AroundEntry(int entry) const;
  bool EndsPeak(std::size_t stretch) const;
  int EntryAt(double place) const;
  Slab Segment(int first, int last, double scale) const;

  int Size;
  std::vector<PlacedStretch> Stretches;
  std::vector<Slab> Cells;                  // between neighbouring entries
  std::vector<std::vector<Stretch>> Blocks; // of 1, 2, 4, ... half cells
};
}

#endif
