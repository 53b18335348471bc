// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// A frame as numbers: reduced, compared with another, written.

#ifndef FramePicture_h
#define FramePicture_h

#include <string>
#include <vector>

class vtkImageData;

struct FramePicture
{
  int Width = 0, Height = 0;
  std::vector<double> Values; // red, green, blue, in [0, 255]
};

FramePicture ToFramePicture(vtkImageData* frame);

// Means of factor x factor pixels.
FramePicture Reduced(const FramePicture& picture, int factor);

// PSNR in dB, over the pixels that either picture covers; the background is black. 99: equal.
double SignalToNoise(const FramePicture& a, const FramePicture& b);

void WritePng(const FramePicture& picture, const std::string& path);

#endif
