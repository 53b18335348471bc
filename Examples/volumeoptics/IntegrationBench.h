// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Frames of the Marschner-Lobb signal by the four ways to classify it, their times, and their errors
// against the double-precision ray caster.

#ifndef IntegrationBench_h
#define IntegrationBench_h

#include "PictureSettings.h"
#include "VolumeFile.h"

#include "RayCaster.h"

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

class VolumeScene;

constexpr double AcceptedError = 1.0 / 255.0; // root mean square

// A transfer function for both spaces.
struct BenchFunction
{
  std::string Name;
  TransferFunction Function;
};

// One broad triangle.
BenchFunction SmoothFunction();
// 16 triangles, each of this width and of the same opacity in data space; the range is 1.
BenchFunction SpikyFunction(double width);

struct BenchTable
{
  int Size = 256;
  int Bits = 32;
};

struct BenchFrame
{
  double Step = 1.0; // voxels
  double FrameSeconds = 0.0;
  double TableSeconds = 0.0; // to build the table; 0 if there is none
  double TableKiB = 0.0;
  double RootMeanSquare = 0.0, Maximum = 0.0;

  double Seconds() const { return this->FrameSeconds + this->TableSeconds; }
};

class IntegrationBench
{
public:
  IntegrationBench(int size, bool headless);
  ~IntegrationBench();

  // Frames of a post-classified and a pre-integrated scene take turns, so that a noisy machine slows both.
  std::pair<BenchFrame, BenchFrame> MeasurePair(
    const BenchFunction& function, const std::string& space, double step, const BenchTable& table);
  BenchFrame Measure(const BenchFunction& function, const std::string& space,
    const std::string& classification, double step, const BenchTable& table = {});
  // Where frames are drawn by the processor, times are its own, of all threads; else they are the clock's.
  bool IsSoftware() const { return this->Software; }

private:
  VolumeScene& Stage(const BenchFunction& function, const std::string& space,
    const std::string& classification, double step, const BenchTable& table);
  const reference::Image& Truth(const BenchFunction& function, const std::string& space);
  // The first frame of these settings, which may link a program and build a table.
  BenchFrame Judge(const BenchFunction& function, const std::string& space, const std::string& classification,
    double step, const BenchTable& table);
  double Now() const;
  double FrameSeconds(VolumeScene& scene) const;
  double TableSeconds(const BenchFunction& function, const std::string& space, int size) const;

  int Size;
  bool Headless;
  bool Software = false;
  Volume Data;
  std::map<std::string, std::unique_ptr<VolumeScene>> Scenes; // by space and classification
  std::map<std::string, reference::Image> Truths;             // by function and space
};

#endif
