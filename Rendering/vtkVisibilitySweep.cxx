// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkVisibilitySweep.h"

#include "FrameAbort.h"
#include "ParameterRange.h"
#include "SweepGrid.h"
#include "SweepProgram.h"
#include "SweepRegions.h"
#include "SweepTarget.h"

#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>

vtkStandardNewMacro(vtkVisibilitySweep);

namespace
{
const char* const AlgorithmNames[] = { "DirectionSweep", "Disk", "DiskSolidAngle" };
const int PartsOfSweep = 16; // between which a frame can be aborted

double DrawnPart(const std::vector<SweepRectangle>& regions, const SweepGrid& grid)
{
  double drawn = 0.0;
  for (const SweepRectangle& region : regions)
  {
    drawn +=
      region.IsEmpty() ? 0.0 : 1.0 * (region.End[0] - region.Begin[0]) * (region.End[1] - region.Begin[1]);
  }
  return drawn / (1.0 * grid.GetSize()[0] * grid.GetSize()[1] * grid.GetSize()[2]);
}
}

class vtkVisibilitySweep::Implementation
{
public:
  // What a sweep is made of.
  struct Stamp
  {
    vtkMTimeType Knobs;
    vtkMTimeType Target;
    std::vector<char> Values;
    SweepGrid Grid;
    std::vector<std::pair<const void*, vtkMTimeType>> Times;
    vtkMTimeType Opacity;
    std::vector<SweepRectangle> Regions;

    bool operator==(const Stamp& other) const
    {
      return this->Knobs == other.Knobs && this->Target == other.Target && this->Values == other.Values &&
        this->Grid == other.Grid && this->Times == other.Times && this->Opacity == other.Opacity &&
        this->Regions == other.Regions;
    }
  };

  // False: the frame was given up in between.
  bool DrawSlices(vtkOpenGLRenderWindow* window, const SweepGrid& grid,
    const std::vector<SweepRectangle>& regions, SweepTarget& target, vtkShaderProgram* program);

  SweepProgram Program;
  SweepTarget Target;
  Stamp Last = {};
  // of a volume in blocks: the opacity of all froxels
  SweepProgram BlockProgram;
  SweepTarget Opacity;
  vtkTimeStamp OpacityTime;
};

//------------------------------------------------------------------------------
bool vtkVisibilitySweep::Implementation::DrawSlices(vtkOpenGLRenderWindow* window, const SweepGrid& grid,
  const std::vector<SweepRectangle>& regions, SweepTarget& target, vtkShaderProgram* program)
{
  const int slices = grid.GetSize()[2];
  const int slicesOfPart = (slices + PartsOfSweep - 1) / PartsOfSweep;
  bool isWanted = true;
  target.Begin();
  for (int slice = 0; slice < slices; ++slice)
  {
    isWanted = slice % slicesOfPart != 0 || !IsFrameAborted(window);
    if (!isWanted)
    {
      break;
    }
    const double depth = grid.GetDepth(slice);
    const double before = slice > 0 ? grid.GetDepth(slice - 1) : depth;
    const double reach = 0.5 * grid.GetSliceDistance();
    const double depths[3] = { depth, depth - reach, depth + reach };
    const double widths[3] = { grid.GetWidth(depths[0]), grid.GetWidth(depths[1]), grid.GetWidth(depths[2]) };
    program->SetUniformi("in_sweepSlice", slice);
    program->SetUniform3f("in_sweepDepths", depths);
    program->SetUniform3f("in_sweepWidths", widths);
    // what is in front of the grid hides all of it
    program->SetUniformf("in_sweepGeometryFront", slice > 0 ? static_cast<float>(depths[1]) : -VTK_FLOAT_MAX);
    program->SetUniformf("in_sweepWidth", static_cast<float>(grid.GetWidth(depth)));
    program->SetUniformf("in_sweepOtherWidth", static_cast<float>(grid.GetWidth(before)));
    target.DrawSlice(slice, regions[slice], program);
  }
  target.End();
  return isWanted;
}

//------------------------------------------------------------------------------
vtkVisibilitySweep::vtkVisibilitySweep()
  : Internals(new Implementation)
{
}

//------------------------------------------------------------------------------
vtkVisibilitySweep::~vtkVisibilitySweep() = default;

//------------------------------------------------------------------------------
void vtkVisibilitySweep::SetConeAngle(double degrees)
{
  volumeoptics::SetWithinRange(this, "ConeAngle", degrees, 0.0, 80.0, this->ConeAngle);
}

//------------------------------------------------------------------------------
void vtkVisibilitySweep::SetAlgorithm(int algorithm)
{
  volumeoptics::SetChoice(this, "Algorithm", algorithm, AlgorithmNames, this->Algorithm);
}

//------------------------------------------------------------------------------
const char* vtkVisibilitySweep::GetAlgorithmAsString()
{
  return AlgorithmNames[this->Algorithm];
}

//------------------------------------------------------------------------------
void vtkVisibilitySweep::SetNumberOfDirections(int directions)
{
  if (directions != 1 && directions != 4 && directions != 8 &&
    directions != SweepProgram::LargestNumberOfDirections)
  {
    vtkWarningMacro(<< "NumberOfDirections " << directions << " is not set: choose 1, 4, 8 or 16.");
    return;
  }
  if (this->NumberOfDirections != directions)
  {
    this->NumberOfDirections = directions;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkVisibilitySweep::SetDiskSize(int size)
{
  volumeoptics::SetWithinRange(this, "DiskSize", size, 1, 32, this->DiskSize);
}

//------------------------------------------------------------------------------
void vtkVisibilitySweep::SetPrecision(int bits)
{
  volumeoptics::SetPrecision(this, "Precision", bits, this->Precision);
}

//------------------------------------------------------------------------------
void vtkVisibilitySweep::SetViewerDistance(double distance)
{
  volumeoptics::SetWithinRange(this, "ViewerDistance", distance, 0.0, VTK_DOUBLE_MAX, this->ViewerDistance);
}

//------------------------------------------------------------------------------
int vtkVisibilitySweep::GetNumberOfChannels() const
{
  return this->Algorithm == DirectionSweep ? this->NumberOfDirections : 1;
}

//------------------------------------------------------------------------------
bool vtkVisibilitySweep::IsByDirection() const
{
  return this->KeepDirections && this->Algorithm == DirectionSweep;
}

//------------------------------------------------------------------------------
bool vtkVisibilitySweep::Sweep(const Volume& volume, const SweepGrid& grid)
{
  std::copy(grid.GetSize(), grid.GetSize() + 3, this->GridSize);
  const SweepTarget::Format format = { { this->GridSize[0], this->GridSize[1], this->GridSize[2] },
    this->GetNumberOfChannels(), this->Precision, this->IsByDirection() };
  if (grid.IsEmpty() || !this->Internals->Target.Allocate(volume.Window, format))
  {
    return false;
  }
  if (volume.FillsBlock)
  {
    return this->FillBlock(volume, grid);
  }
  const SweepProgram::Kind kind = { this->GetNumberOfChannels(), this->Algorithm != DirectionSweep,
    grid.GetIsPerspective() && this->ViewerDistance > 0.0, volume.Geometry != nullptr,
    grid.GetIsPerspective() && this->IsByDirection(), this->IsByDirection(), false, volume.IsInBlocks };
  vtkShaderProgram* program = this->Internals->Program.Use(volume.Window, volume.Ray, kind);
  if (program)
  {
    this->Draw(volume, grid, program);
  }
  volume.Window->GetShaderCache()->ReadyShaderProgram(volume.Ray);
  return program != nullptr;
}

//------------------------------------------------------------------------------
std::vector<SweepRectangle> vtkVisibilitySweep::FindRegions(const Volume& volume, const SweepGrid& grid)
{
  SweepContents contents = {};
  std::copy(volume.Box, volume.Box + 24, contents.Corners);
  contents.IsHiddenOutside = volume.Geometry != nullptr;
  contents.LookAlong = volume.LookAlong;
  contents.LookAside = volume.LookAside;
  contents.Cone = { vtkMath::RadiansFromDegrees(this->ConeAngle), this->IsByDirection(),
    this->ViewerDistance };
  return volume.SkipsEmptySpace ? FindSweepRegions(grid, contents) : WholeSweep(grid);
}

//------------------------------------------------------------------------------
bool vtkVisibilitySweep::FillBlock(const Volume& volume, const SweepGrid& grid)
{
  SweepTarget& opacity = this->Internals->Opacity;
  const SweepTarget::Format format = { { this->GridSize[0], this->GridSize[1], this->GridSize[2] }, 1, 32,
    false };
  const SweepProgram::Kind kind = { 1, false, false, false, false, false, true, false };
  vtkShaderProgram* program = opacity.Allocate(volume.Window, format)
    ? this->Internals->BlockProgram.Use(volume.Window, volume.Ray, kind)
    : nullptr;
  if (program)
  {
    this->SetUniforms(volume, grid, program);
    program->SetUniformi("in_sweepBlock", volume.Block);
    this->Internals->DrawSlices(volume.Window, grid, WholeSweep(grid), opacity, program);
    this->Internals->OpacityTime.Modified();
  }
  volume.Window->GetShaderCache()->ReadyShaderProgram(volume.Ray);
  return program != nullptr;
}

//------------------------------------------------------------------------------
void vtkVisibilitySweep::Draw(const Volume& volume, const SweepGrid& grid, vtkShaderProgram* program)
{
  const Implementation::Stamp stamp = { this->GetMTime(), this->Internals->Target.GetTime(),
    this->Internals->Program.GetValues(), grid, volume.Times,
    volume.IsInBlocks ? this->Internals->OpacityTime.GetMTime() : 0, this->FindRegions(volume, grid) };
  if (stamp == this->Internals->Last)
  {
    return;
  }
  this->SetUniforms(volume, grid, program);
  this->SetGeometry(volume, grid, program);
  TermTexture& opacity = this->Internals->Opacity.GetVisibility();
  if (volume.IsInBlocks)
  {
    opacity.Bind("in_sweepOpacity", program);
  }
  const bool isWhole =
    this->Internals->DrawSlices(volume.Window, grid, stamp.Regions, this->Internals->Target, program);
  opacity.Unbind();
  if (volume.Geometry)
  {
    volume.Geometry->Deactivate();
  }
  this->SweepCount += isWhole ? 1 : 0;
  this->DrawnFraction = DrawnPart(stamp.Regions, grid);
  this->Internals->Last = isWhole ? stamp : Implementation::Stamp();
}

//------------------------------------------------------------------------------
vtkTextureObject* vtkVisibilitySweep::GetTexture()
{
  TermTexture& texture = this->Internals->Target.GetVisibility();
  return texture ? texture.operator->() : nullptr;
}

//------------------------------------------------------------------------------
int vtkVisibilitySweep::GetProgramLinkCount()
{
  return this->Internals->Program.GetLinkCount();
}

//------------------------------------------------------------------------------
std::string vtkVisibilitySweep::GetFragmentShader()
{
  return this->Internals->Program.GetFragmentShader();
}

//------------------------------------------------------------------------------
std::size_t vtkVisibilitySweep::GetMemorySize() const
{
  return this->Internals->Target.GetMemorySize() + this->Internals->Opacity.GetMemorySize();
}

//------------------------------------------------------------------------------
void vtkVisibilitySweep::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internals->Program.Release();
  this->Internals->Target.Release(window);
  this->Internals->BlockProgram.Release();
  this->Internals->Opacity.Release(window);
}

//------------------------------------------------------------------------------
void vtkVisibilitySweep::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ConeAngle: " << this->ConeAngle << "\n";
  os << indent << "Algorithm: " << this->GetAlgorithmAsString() << "\n";
  os << indent << "NumberOfDirections: " << this->NumberOfDirections << "\n";
  os << indent << "DiskSize: " << this->DiskSize << "\n";
  os << indent << "TrueDistances: " << (this->TrueDistances ? "on" : "off") << "\n";
  os << indent << "Precision: " << this->Precision << "\n";
  os << indent << "ViewerDistance: " << this->ViewerDistance << "\n";
  os << indent << "KeepDirections: " << (this->KeepDirections ? "on" : "off") << "\n";
  os << indent << "SweepCount: " << this->SweepCount << "\n";
  os << indent << "DrawnFraction: " << this->DrawnFraction << "\n";
  os << indent << "GridSize: " << this->GridSize[0] << ' ' << this->GridSize[1] << ' ' << this->GridSize[2]
     << "\n";
}
