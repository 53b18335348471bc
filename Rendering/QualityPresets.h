// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef QualityPresets_h
#define QualityPresets_h

// Points on the curves of docs/accuracy.md, in the order of QualityType.
struct QualityPreset
{
  double StepInVoxels;
  double ResolutionFactor;
  int Bits;
  int Samples;
  double FilterStandardDeviation; // voxels
  int VisibilityGridSize;
  int VisibilitySamples;
  int VisibilityGatherSamples;
  int VisibilityPrecision;
};
const QualityPreset QualityPresets[] = { {}, { 1.0, 0.5, 8, 100, 1.0, 64, 4, 0, 16 },
  { 0.5, 1.0, 8, 1000, 1.0, 96, 8, 4, 16 }, { 0.25, 1.0, 16, 4096, 0.0, 128, 16, 6, 16 } };

#endif
