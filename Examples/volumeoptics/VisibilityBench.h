// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Directional occlusion by the mapper and by the reference's algorithms against the cone integral by rays, and
// what it adds to a frame.

#ifndef VisibilityBench_h
#define VisibilityBench_h

#include "PictureSettings.h"

#include "FroxelSweep.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

class VolumeScene;

// How the mapper finds visibility; Quality overrides the rest unless it is "custom".
struct VisibilityKnobs
{
  int GridSize = 128;
  double SliceDistance = 1.0; // in sides of a froxel
  int Samples = 8;
  int GatherSamples = 4;
  std::string Algorithm = "sweep"; // as VisibilitySettings
  int DiskSize = 5;
  int Precision = 16;
  std::string Quality = "custom";
};

// Of radiance where the volume is white and ambient light 1: the visibility of samples, each weighted by its
// contribution to the pixel.
struct PictureError
{
  double Mean = 0.0; // absolute, over all pixels by their opacity
  double Maximum = 0.0;
};

// What a frame is timed with and without occlusion.
struct FrameKind
{
  bool IsLit = false; // by a light, as VTK does it (ShadeOn); else by ambient light alone
  bool SkipsEmptySpace = false;
};

struct FrameCost
{
  double Seconds = 0.0;        // with occlusion
  double SecondsWithout = 0.0; // the same frame without
  double KiB = 0.0;

  double Ratio() const { return this->Seconds / this->SecondsWithout; }
};

class VisibilityBench
{
public:
  struct Options
  {
    std::string Field = "marschner-lobb"; // see GalleryField()
    std::string Cranium;                  // file
    int Size = 64;                        // of the pictures that are compared
    int FrameSize = 512;                  // of the frames that are timed
    int Rays = 128;                       // of the truth
    bool Headless = false;
  };

  explicit VisibilityBench(const Options& options);
  ~VisibilityBench();

  PictureError Judge(double angle, const VisibilityKnobs& knobs);
  // Frames with and without take turns, so that a noisy machine slows both. Medians.
  FrameCost Time(double angle, const VisibilityKnobs& knobs, const FrameKind& kind = {});

  // Of the reference's algorithms, in double: at the picture's samples, and of its pixels.
  struct AlgorithmError
  {
    reference::VisibilityError Samples;
    PictureError Pixels;
  };
  AlgorithmError JudgeAlgorithm(
    double angle, int size, double sliceDistance, reference::SweepSettings settings);
  // What the noise of the truth's rays is, by another seed; and how far the cone about the slices' normal is
  // from that about the direction to the eye.
  AlgorithmError NoiseOfTruth(double angle);
  AlgorithmError AxisOfCone(double angle);

  // Where frames are drawn by the processor, times are its own, of all threads; else they are the clock's.
  bool IsSoftware() const { return this->Software; }

private:
  void Stage(VolumeScene& scene, int size, double angle, const VisibilityKnobs& knobs,
    const FrameKind& kind = {}) const;
  const std::vector<double>& Truth(double angle);
  std::vector<double> Rays(double angle, unsigned seed, const reference::Vector* axis = nullptr) const;
  AlgorithmError Compare(const std::vector<double>& values, double angle);
  PictureError ComparePixels(const std::vector<double>& radiance, double angle);
  double FrameSeconds(VolumeScene& scene) const;

  Options Setup;
  bool Software = false;
  std::unique_ptr<VolumeScene> Pictures, WithOcclusion, Without;
  reference::Scene World;
  std::unique_ptr<reference::Occluders> Things;
  std::vector<reference::ShownPoint> Points;
  std::vector<double> Opacity;                  // of the pixels, by their points
  std::map<double, std::vector<double>> Truths; // by angle
};

#endif
