// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PictureOptions.h"

#include "Lighting.h"
#include "Progress.h"
#include "UserError.h"

#include <vtkNamedColors.h>
#include <vtkNew.h>

#include <cstdio>
#include <cstdlib>

namespace
{
const char* const FunctionFormat = R"(
Transfer function (JSON), values in the data's units, opacity per unitDistance of world length:
  {"opacity": [[200, 0.0], [400, 0.9]], "color": [[200, 0.9, 0.8, 0.7], [3000, 1, 1, 1]],
   "unitDistance": 1.0, "shade": true, "ambient": 0.1, "diffuse": 0.7, "specular": 0.4,
   "specularPower": 20, "isolate": -400, "integration": "data", "classification": "pre-integrated",
   "unitInterval": 10, "isosurfaces": [[300, 0.9, 0.8, 0.7, 0.5], [-300, 0.2]], "silhouette": "exact",
   "transmittedLight": "diffuse"}
Only opacity and color are required. "isolate" keeps the largest region above a value. In data space
opacity is per unitInterval of the data's values; the options of the same name go before the file.
Presets cranium, bone, muscle and skin expect CT in Hounsfield units.)";

CLI::Validator IsColor()
{
  return CLI::Validator(
    [](const std::string& text) {
      vtkNew<vtkNamedColors> colors;
      return colors->ColorExists(text) ||
          (text.size() == 7 && text[0] == '#' &&
            text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos)
        ? std::string()
        : "'" + text + "' is neither a colour's name nor #rrggbb";
    },
    "COLOR");
}

std::array<double, 3> ReadColor(const std::string& text)
{
  vtkNew<vtkNamedColors> colors;
  const vtkColor4ub color = text[0] == '#' ? colors->HTMLColorToRGBA(text) : colors->GetColor4ub(text);
  return { color[0] / 255.0, color[1] / 255.0, color[2] / 255.0 };
}

void AddOptics(CLI::App& command, OpticsSettings& optics)
{
  const auto group = "Reflectance";
  command.add_option("--model", optics.Model, "Reflectance model")
    ->check(CLI::IsMember({ "vtk", "none", "blinn-phong", "ward", "lafortune" }))
    ->capture_default_str()
    ->group(group);
  command
    .add_option("--glossiness", optics.Glossiness,
      "Exponent in [0.01, 1e5] (Blinn-Phong, Lafortune; default 30) or roughness in [1e-4, 1] (Ward; "
      "default 0.2)")
    ->check(CLI::Range(1e-4, 1e5))
    ->group(group);
  command
    .add_option("--anisotropy", optics.Anisotropy,
      "Exponent of the eigenvalues' ratio, 0 is isotropic (Ward, Lafortune; default 10)")
    ->check(CLI::Range(0.0, 1e4))
    ->group(group);
  command
    .add_option("--scattering", optics.Scattering,
      "Mean cosine g of the Henyey-Greenstein phase function (not by model vtk)")
    ->check(CLI::Range(-1.0, 1.0))
    ->capture_default_str()
    ->group(group);
  command.add_option("--frame-source", optics.FrameSource, "Where the tangent frame comes from")
    ->check(CLI::IsMember({ "covariance", "curvature" }))
    ->capture_default_str()
    ->group(group);
}

void AddAmbient(CLI::App& command, AmbientSettings& ambient)
{
  const auto group = "Ambient region (Ward, Lafortune)";
  command.add_option("--radius", ambient.Radius, "Radius in voxels")
    ->check(CLI::Range(0.5, 256.0))
    ->capture_default_str()
    ->group(group);
  command.add_option("--samples", ambient.Samples, "Samples per voxel")
    ->check(CLI::Range(3, 65536))
    ->capture_default_str()
    ->group(group);
  command
    .add_option(
      "--sampling", ambient.Pattern, "Pattern of the samples; exhaustive: all voxels, without noise")
    ->check(CLI::IsMember({ "shared", "per-block", "per-voxel", "exhaustive" }))
    ->capture_default_str()
    ->group(group);
  command
    .add_option("--filter", ambient.FilterStandardDeviation,
      "Standard deviation of a Gaussian filter of the covariance, in voxels")
    ->check(CLI::Range(0.0, 100.0))
    ->capture_default_str()
    ->group(group);
  command
    .add_option("--tolerance", ambient.Tolerance,
      "Half width of the interval of similar values, as a fraction of the scalar range")
    ->check(CLI::Range(0.0, 1.0))
    ->capture_default_str()
    ->group(group);
  command
    .add_option("--resolution-factor", ambient.ResolutionFactor,
      "Resolution of normals and covariance relative to the data")
    ->check(CLI::Range(0.0625, 1.0))
    ->capture_default_str()
    ->group(group);
  command.add_option("--precision", ambient.Precision, "Bits per stored number")
    ->check(CLI::IsMember({ 8, 16, 32 }))
    ->capture_default_str()
    ->group(group);
}

void AddLighting(CLI::App& command, PictureOptions& options)
{
  const auto group = "Lighting transfer function";
  LightingSettings& lighting = options.Picture.Lighting;
  options.AddLightingFile(command)->group(group);
  command.add_option("--light-scale", lighting.Scale, "Factor of all light by a lighting transfer function")
    ->check(CLI::Range(0.0, 1.0e4))
    ->capture_default_str()
    ->group(group);
  command
    .add_option("--gradient-step", lighting.StepLength,
      "Distance of the two samples along the gradient, in voxels of the finest spacing")
    ->check(CLI::Range(0.01, 100.0))
    ->capture_default_str()
    ->group(group);
  command
    .add_flag("--hybrid-normals", lighting.HybridNormals, "Light from the side of the lower opacity alone")
    ->group(group);
}

void AddVisibility(CLI::App& command, PictureOptions& options)
{
  const auto group = "Occlusion and shadows";
  VisibilitySettings& visibility = options.Picture.Visibility;
  const CLI::Range halfAngle(0.0, 80.0);
  command
    .add_option("--occlusion", visibility.OcclusionAngle,
      "Ambient light out of a cone about the line of sight, past what lies in front; half angle in degrees")
    ->check(halfAngle)
    ->group(group);
  command.add_option("--ambient-color", options.AmbientColorText, "Colour of ambient light, name or #rrggbb")
    ->check(IsColor())
    ->capture_default_str()
    ->group(group);
  CLI::Option* shadows =
    command.add_flag("--shadows", visibility.Shadows, "Shadows of all lights in the volume")->group(group);
  command
    .add_option("--shadow-angle", visibility.ShadowAngle,
      "Half angle under which lights appear, degrees; above 0: soft shadows")
    ->check(halfAngle)
    ->capture_default_str()
    ->needs(shadows)
    ->group(group);
}

void AddView(CLI::App& command, PictureOptions& options)
{
  const auto group = "View";
  PictureSettings& picture = options.Picture;
  CameraSettings& camera = picture.Camera;
  command
    .add_option("--camera", options.CameraValues,
      "Azimuth, elevation, roll in degrees from the front, and zoom, e.g. 35,10,0,1.2")
    ->delimiter(',')
    ->expected(1, 4)
    ->group(group);
  const auto point = [&](const char* name, std::vector<double>& where, const char* text) {
    command.add_option(name, where, text)->delimiter(',')->expected(3)->group(group);
  };
  point("--position", camera.Position, "Camera in world coordinates x,y,z, instead of --camera");
  point("--focal", camera.FocalPoint, "Focal point x,y,z; default the volume's centre");
  point("--up", camera.ViewUp, "View up x,y,z; default 0,0,1");
  command.add_option("--size", options.SizeText, "Width x height in pixels")
    ->check(CLI::Validator(
      [](const std::string& text) {
        int width = 0, height = 0, read = 0;
        const bool valid = std::sscanf(text.c_str(), "%dx%d%n", &width, &height, &read) == 2 &&
          read == static_cast<int>(text.size()) && width > 0 && height > 0 && width <= 16384 &&
          height <= 16384;
        return valid ? "" : "'" + text + "' is not WIDTHxHEIGHT of 1 to 16384 pixels, e.g. 1024x768";
      },
      "WxH"))
    ->capture_default_str()
    ->group(group);
  command
    .add_option("--light", options.LightValues,
      "Azimuth, elevation of the light in degrees from the camera's axis; default 0,0")
    ->delimiter(',')
    ->expected(2)
    ->group(group);
  command
    .add_option("--step", picture.Step, "Step along the ray, world length; default half the mean spacing")
    ->check(CLI::PositiveNumber)
    ->group(group);
  command.add_option("--background", options.BackgroundText, "Name (white, black, slategray ...) or #rrggbb")
    ->check(IsColor())
    ->capture_default_str()
    ->group(group);
}
}

// Frames without visible noise at the default scale of the anisotropy.
PictureOptions::PictureOptions()
{
  this->Picture.Ambient.Samples = 300;
  this->Picture.Ambient.FilterStandardDeviation = 1.5;
}

void PictureOptions::AddTo(CLI::App& command)
{
  command
    .add_option(
      "FILE", this->File, "Volume: .vti .mhd .mha .nrrd .nii .nii.gz .vtk .dcm, DICOM folder, .inv3")
    ->required();
  command.add_option("--transfer-function", this->FunctionFile, "JSON file, see below")
    ->group("Classification");
  command
    .add_option("--preset", this->PresetName,
      "Built-in transfer function; without one: from the histogram (.inv3: cranium)")
    ->check(CLI::IsMember(PresetNames()))
    ->excludes("--transfer-function")
    ->group("Classification");
  this->Integration.AddTo(command);
  AddOptics(command, this->Picture.Optics);
  AddAmbient(command, this->Picture.Ambient);
  AddLighting(command, *this);
  AddVisibility(command, *this);
  AddView(command, *this);
  command.add_option("--quality", this->Picture.Quality, "Preset of time against accuracy")
    ->check(CLI::IsMember({ "custom", "draft", "balanced", "reference" }))
    ->capture_default_str();
  command.footer(FunctionFormat);
}

CLI::Option* PictureOptions::AddLightingFile(CLI::App& command)
{
  return command.add_option("--lighting", this->LightingFile,
    "Lighting transfer function (JSON): light by pairs of scalars along the gradient");
}

void PictureOptions::AddVisibilityTo(CLI::App& command)
{
  AddVisibility(command, *this);
}

void PictureOptions::AddViewTo(CLI::App& command)
{
  AddView(command, *this);
}

void PictureOptions::CompleteView()
{
  std::sscanf(this->SizeText.c_str(), "%dx%d", &this->Picture.Size[0], &this->Picture.Size[1]);
  CameraSettings& camera = this->Picture.Camera;
  double* const cameraValues[] = { &camera.Azimuth, &camera.Elevation, &camera.Roll, &camera.Zoom };
  for (std::size_t i = 0; i < this->CameraValues.size(); ++i)
  {
    *cameraValues[i] = this->CameraValues[i];
  }
  if (this->LightValues.size() == 2)
  {
    this->Picture.Lights[0].Azimuth = this->LightValues[0];
    this->Picture.Lights[0].Elevation = this->LightValues[1];
  }
  this->Picture.Background = ReadColor(this->BackgroundText);
  this->Picture.Visibility.AmbientColor = ReadColor(this->AmbientColorText);
}

void PictureOptions::Check() const
{
  const TransferFunction& function = this->Picture.Function;
  CheckIntegration(function.Integration, function.Shade);
  if (this->Picture.Visibility.Shadows && !function.Shade)
  {
    throw UserError("Shadows need lights. Set \"shade\": true in the transfer function.");
  }
}

Volume PictureOptions::Load()
{
  this->CompleteView();
  if (!this->FunctionFile.empty())
  {
    this->Picture.Function = ReadTransferFunction(this->FunctionFile);
  }
  if (!this->LightingFile.empty())
  {
    this->Picture.Lighting.Function = ReadLighting(this->LightingFile);
  }
  Volume volume;
  {
    const Progress reading("Reading " + this->File);
    volume = ReadVolume(this->File);
  }
  const bool project = this->File.size() > 5 && this->File.substr(this->File.size() - 5) == ".inv3";
  if (this->FunctionFile.empty())
  {
    const std::string preset = this->PresetName.empty() && project ? "cranium" : this->PresetName;
    this->Picture.Function = preset.empty() ? FromData(volume.Image) : Preset(preset);
  }
  this->Integration.Replace(this->Picture.Function.Integration);
  this->Check();
  if (this->Picture.Function.HasIsolate)
  {
    const Progress isolating("Isolating the largest region");
    volume.Image = IsolateLargestRegion(volume.Image, this->Picture.Function.Isolate);
  }
  return volume;
}
