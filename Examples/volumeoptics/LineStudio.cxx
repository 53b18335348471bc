// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LineStudio.h"

#include "LineTubes.h"
#include "RingFlow.h"

#include "vtkAnalyticLineSource.h"
#include "vtkOpticsVolumeMapper.h"

#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTimerLog.h>

#include <algorithm>

namespace
{
bool HasTypes(const LinePicture& lines)
{
  return lines.Source == "ring";
}

LineSettings SettingsOf(const LinePicture& lines)
{
  LineSettings settings;
  settings.Grid = lines.Grid;
  settings.Radius = lines.Radius;
  const std::array<double, 3> red = { 1.0, 0.35, 0.2 }, blue = { 0.35, 0.6, 1.0 };
  const std::array<double, 3>& color = HasTypes(lines) ? blue : red;
  std::copy(color.begin(), color.end(), settings.Color);
  std::copy(lines.WorldLight.begin(), lines.WorldLight.end(), settings.WorldLight);
  return settings;
}

vtkSmartPointer<vtkImageData> Voxelize(vtkPolyData* data, const LinePicture& lines)
{
  vtkNew<vtkAnisotropicLineVoxelizer> voxelizer;
  const LineSettings settings = SettingsOf(lines);
  const double* bounds = lines.Block.empty() ? data->GetBounds() : lines.Block.data();
  SetUpVoxelizer(settings, LightSettings(), bounds, voxelizer);
  if (HasTypes(lines))
  {
    vtkNew<vtkProperty> orange;
    orange->DeepCopy(voxelizer->GetMaterial(0));
    orange->SetAmbientColor(1.0, 0.55, 0.15);
    orange->SetDiffuseColor(1.0, 0.55, 0.15);
    voxelizer->SetMaterial(1, orange);
    voxelizer->SetSpecularPower(1, settings.SpecularPower);
    voxelizer->SetLineTypeArray("LineType");
  }
  voxelizer->SetInputData(data);
  voxelizer->Update();
  return voxelizer->GetOutput();
}
}

vtkPolyData* LineStudio::LinesOf(const LinePicture& lines)
{
  const nlohmann::json key = { lines.Source, lines.Segments };
  if (key != this->LineKey)
  {
    this->Lines = nullptr; // before the next are made
    if (lines.Source == "ring")
    {
      this->Lines = TraceRingFlow(lines.Segments);
    }
    else
    {
      vtkNew<vtkAnalyticLineSource> source;
      source->SetNumberOfSegments(lines.Segments);
      source->Update();
      this->Lines = source->GetOutput();
    }
    this->LineKey = key;
  }
  return this->Lines;
}

vtkImageData* LineStudio::VoxelsOf(const LinePicture& lines)
{
  const nlohmann::json key = { lines.Source, lines.Segments, lines.Radius, lines.Grid, lines.WorldLight };
  if (key != this->VoxelKey)
  {
    vtkPolyData* data = this->LinesOf(lines);
    const double start = vtkTimerLog::GetUniversalTime();
    this->Voxels = nullptr;
    LinePicture whole = lines;
    whole.Block.clear();
    this->Voxels = Voxelize(data, whole);
    this->VoxelSeconds = vtkTimerLog::GetUniversalTime() - start;
    this->VoxelKey = key;
  }
  return this->Voxels;
}

// The scene of the voxels gives the tubes camera and light, too.
LineStudio::Result LineStudio::Draw(
  const LinePicture& lines, const PictureSettings& picture, const std::string& path)
{
  vtkImageData* voxels = this->VoxelsOf(lines);
  LineScene scene(voxels, picture, this->Kind);
  scene.LightAs(voxels);
  Result result;
  if (lines.AsTubes)
  {
    const TubeFrame tubes = DrawTubes(this->LinesOf(lines), SettingsOf(lines), scene.GetScene(), 6);
    result.FrameSeconds = tubes.Seconds;
    ::WritePng(tubes.Frame, path);
  }
  else
  {
    for (int type : { 0, 1 })
    {
      scene.SetRadiusScale(type, lines.RadiusScales[type]);
      scene.SetOpacityScale(type, lines.OpacityScale);
    }
    if (!lines.Block.empty())
    {
      scene.GetScene().GetMapper()->SetLineBlockInputData(Voxelize(this->LinesOf(lines), lines));
    }
    scene.Render();
    scene.GetScene().GetRenderer()->GetActiveCamera()->Azimuth(1e-6); // evaluates again
    result.FrameSeconds = scene.Render();
    result.VoxelSeconds = this->VoxelSeconds;
    scene.GetScene().WritePng(path);
  }
  result.Renderer = scene.GetScene().GetRendererName();
  return result;
}
