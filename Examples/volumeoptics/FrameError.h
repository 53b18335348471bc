// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// How far the tangent frames of one estimate are from those of another, at points between the voxels,
// where a ray samples them.

#ifndef FrameError_h
#define FrameError_h

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <array>

// Normals and codes of one estimate, on one grid.
struct FrameImage
{
  vtkSmartPointer<vtkImageData> Normals; // array Normals
  vtkSmartPointer<vtkImageData> Code;    // array AmbientCovariance
  int Storage = 0;                       // vtkAnisotropyFilter::StorageType
};

struct FrameError
{
  static constexpr int NumberOfBins = 10;

  double MeanAngle = 0.0;   // degrees between the major axes, weighted by the truth's strength
  double BadFraction = 0.0; // of the points, more than 10 degrees off
  double StrengthRms = 0.0; // of |a| = (l2 - l1)/(l2 + l1)
  std::array<double, NumberOfBins> AngleByPole{}; // mean angle by |n.z|, bin i from i/10
};

FrameError CompareFrames(const FrameImage& estimate, const FrameImage& truth);

#endif
