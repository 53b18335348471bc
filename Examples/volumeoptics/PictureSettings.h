// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// All that makes one picture of a volume; its JSON is the key of the gallery's cache.

#ifndef PictureSettings_h
#define PictureSettings_h

#include "TransferFunction.h"

#include <array>
#include <string>
#include <vector>

struct OpticsSettings
{
  std::string Model = "vtk"; // vtk, none, blinn-phong, ward, lafortune
  double Glossiness = -1.0;  // below 0: the model's default
  double Anisotropy = -1.0;  // below 0: the model's default
  double Scattering = 0.0;
  std::string FrameSource = "covariance";
};

struct AmbientSettings
{
  double Radius = 10.0;
  int Samples = 100;
  double Tolerance = 0.05;
  double ResolutionFactor = 1.0;
  double FilterStandardDeviation = 0.0;
  std::string Pattern = "shared"; // shared, per-block, per-voxel, exhaustive
  int Precision = 8;
};

struct CameraSettings
{
  double Azimuth = 0.0, Elevation = 0.0, Roll = 0.0, Zoom = 1.0;
  std::vector<double> Position, FocalPoint, ViewUp; // world; empty: found from the volume
};

struct LightSettings
{
  double Azimuth = 0.0, Elevation = 0.0; // degrees from the camera's axis
  double Intensity = 1.0;
  bool OneSided = false; // one such light makes all of them light only surfaces that face them
};

// A lighting transfer function, in place of the coefficients of Function.
struct LightingSettings
{
  std::string Function; // JSON text; empty: none
  double Scale = 1.0;
  double StepLength = 1.0; // of the finest spacing
  bool HybridNormals = false;
  std::string Rules; // of a classification by several samples, JSON text; empty: none
};

struct VisibilitySettings
{
  double OcclusionAngle = -1.0; // degrees; below 0: no occlusion
  std::array<double, 3> AmbientColor = { 1.0, 1.0, 1.0 };
  bool Shadows = false;
  double ShadowAngle = 0.0; // degrees
  // How it is found, unless the picture has a quality: see vtkOpticsVolumeMapper.
  std::string Algorithm = "sweep"; // sweep, disk, disk-solid-angle
  int GridSize = 128;
  double SliceDistance = 1.0; // in sides of a froxel
  int Samples = 8;            // directions
  int GatherSamples = 4;      // of each
  int DiskSize = 5;
};

// What is on the normal's side of the plane is kept.
struct ClippingSettings
{
  std::array<double, 3> Normal = { 0.0, 0.0, 1.0 };
  std::array<double, 3> Place = { 0.5, 0.5, 0.5 }; // in shares of the volume's bounds
};

struct PictureSettings
{
  OpticsSettings Optics;
  LightingSettings Lighting;
  VisibilitySettings Visibility;
  AmbientSettings Ambient;
  CameraSettings Camera;
  std::vector<LightSettings> Lights = { LightSettings{} };
  TransferFunction Function;
  std::vector<ClippingSettings> ClippingPlanes;
  std::array<int, 2> Size = { 1024, 1024 };
  std::array<double, 3> Background = { 1.0, 1.0, 1.0 };
  double Step = 0.0; // world length; 0: half of the mean spacing
  std::string Quality = "custom";
};

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(OpticsSettings, Model, Glossiness, Anisotropy, Scattering, FrameSource)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(
  AmbientSettings, Radius, Samples, Tolerance, ResolutionFactor, FilterStandardDeviation, Pattern, Precision)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(
  CameraSettings, Azimuth, Elevation, Roll, Zoom, Position, FocalPoint, ViewUp)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(LightingSettings, Function, Scale, StepLength, HybridNormals, Rules)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(VisibilitySettings, OcclusionAngle, AmbientColor, Shadows, ShadowAngle,
  Algorithm, GridSize, SliceDistance, Samples, GatherSamples, DiskSize)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ClippingSettings, Normal, Place)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(LightSettings, Azimuth, Elevation, Intensity, OneSided)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PictureSettings, Optics, Lighting, Visibility, Ambient, Camera, Lights,
  Function, ClippingPlanes, Size, Background, Step, Quality)

#endif
