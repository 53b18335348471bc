// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkVisibilitySweep.h"

#include "FrameAbort.h"
#include "Optics.h"
#include "ParameterRange.h"
#include "SweepGrid.h"
#include "SweepProgram.h"
#include "SweepTarget.h"

#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkVisibilitySweep);

namespace
{
const char* const AlgorithmNames[] = { "DirectionSweep", "Disk", "DiskSolidAngle" };
const int LargestNumberOfDirections = 16;
const int PartsOfSweep = 16; // between which a frame can be aborted

// OpenGL reads columns.
void SetMatrix(vtkShaderProgram* program, const char* name, const double matrix[16])
{
  float columns[16];
  for (int i = 0; i < 16; ++i)
  {
    columns[4 * (i % 4) + i / 4] = static_cast<float>(matrix[i]);
  }
  program->SetUniformMatrix4x4(name, columns);
}

void SetVector(vtkShaderProgram* program, const char* name, double x, double y, double z, double w)
{
  const float vector[4] = { static_cast<float>(x), static_cast<float>(y), static_cast<float>(z),
    static_cast<float>(w) };
  program->SetUniform4f(name, vector);
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

    bool operator==(const Stamp& other) const
    {
      return this->Knobs == other.Knobs && this->Target == other.Target && this->Values == other.Values &&
        this->Grid == other.Grid && this->Times == other.Times && this->Opacity == other.Opacity;
    }
  };

  // False: the frame was given up in between.
  bool DrawSlices(
    vtkOpenGLRenderWindow* window, const SweepGrid& grid, SweepTarget& target, vtkShaderProgram* program);

  SweepProgram Program;
  SweepTarget Target;
  Stamp Last = {};
  // of a volume in blocks: the opacity of all froxels
  SweepProgram BlockProgram;
  SweepTarget Opacity;
  vtkTimeStamp OpacityTime;
};

//------------------------------------------------------------------------------
bool vtkVisibilitySweep::Implementation::DrawSlices(
  vtkOpenGLRenderWindow* window, const SweepGrid& grid, SweepTarget& target, vtkShaderProgram* program)
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
    target.DrawSlice(slice, program);
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
  if (directions != 1 && directions != 4 && directions != 8 && directions != LargestNumberOfDirections)
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
    this->Internals->DrawSlices(volume.Window, grid, opacity, program);
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
    volume.IsInBlocks ? this->Internals->OpacityTime.GetMTime() : 0 };
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
  const bool isWhole = this->Internals->DrawSlices(volume.Window, grid, this->Internals->Target, program);
  opacity.Unbind();
  if (volume.Geometry)
  {
    volume.Geometry->Deactivate();
  }
  this->SweepCount += isWhole ? 1 : 0;
  this->Internals->Last = isWhole ? stamp : Implementation::Stamp();
}

//------------------------------------------------------------------------------
void vtkVisibilitySweep::SetUniforms(const Volume& volume, const SweepGrid& grid, vtkShaderProgram* program)
{
  double worldToTexture[16];
  double viewToTexture[16];
  double dataToTexture[16];
  vtkMatrix4x4::Invert(volume.TextureToWorld, worldToTexture);
  vtkMatrix4x4::Invert(grid.GetWorldToView(), viewToTexture);
  vtkMatrix4x4::Multiply4x4(worldToTexture, viewToTexture, viewToTexture);
  vtkMatrix4x4::Multiply4x4(worldToTexture, volume.DataToWorld, dataToTexture);
  double viewToWorld[16];
  vtkMatrix4x4::Invert(grid.GetWorldToView(), viewToWorld);
  SetMatrix(program, "in_sweepToTexture", viewToTexture);
  SetMatrix(program, "in_sweepToWorld", viewToWorld);
  SetMatrix(program, "in_sweepDataToTexture", dataToTexture);

  const double* window = grid.GetWindow();
  const double sides[2] = { window[1] - window[0], window[3] - window[2] };
  SetVector(program, "in_sweepWindow", window[0], window[2], sides[0], sides[1]);
  SetVector(program, "in_sweepWindowCode", 1.0 / sides[0], 1.0 / sides[1], -window[0] / sides[0],
    -window[2] / sides[1]);
  const float froxel[2] = { 1.0F / static_cast<float>(grid.GetSize()[0]),
    1.0F / static_cast<float>(grid.GetSize()[1]) };
  program->SetUniform2f("in_sweepFroxel", froxel);
  program->SetUniformf("in_sweepSliceDistance", static_cast<float>(grid.GetSliceDistance()));
  this->SetConeUniforms(volume, grid, program);
}

//------------------------------------------------------------------------------
// Ways are measured in the data's coordinates, as VTK measures the steps of the ray: the volume's matrix may
// scale unevenly.
void vtkVisibilitySweep::SetConeUniforms(
  const Volume& volume, const SweepGrid& grid, vtkShaderProgram* program)
{
  double worldToData[16];
  double viewToData[16];
  vtkMatrix4x4::Invert(volume.DataToWorld, worldToData);
  vtkMatrix4x4::Invert(grid.GetWorldToView(), viewToData);
  vtkMatrix4x4::Multiply4x4(worldToData, viewToData, viewToData);
  const double axis = std::sqrt(
    viewToData[2] * viewToData[2] + viewToData[6] * viewToData[6] + viewToData[10] * viewToData[10]);
  const double steps = axis * grid.GetSliceDistance() / volume.StepLength;
  program->SetUniformf("in_sweepStepsOfSlice", static_cast<float>(steps));
  float columns[9];
  for (int i = 0; i < 9; ++i)
  {
    columns[i] = static_cast<float>(viewToData[4 * (i % 3) + i / 3] / axis);
  }
  program->SetUniformMatrix3x3("in_sweepToSlices", columns);
  program->SetUniformf("in_sweepViewerDistance", static_cast<float>(this->ViewerDistance));
  this->Algorithm == DirectionSweep ? this->SetDirections(viewToData, axis, program) : this->SetDisk(program);
}

//------------------------------------------------------------------------------
void vtkVisibilitySweep::SetDirections(const double viewToData[16], double axis, vtkShaderProgram* program)
{
  const double cosine = std::cos(vtkMath::RadiansFromDegrees(this->ConeAngle));
  float slopes[LargestNumberOfDirections][2] = {};
  float lengths[LargestNumberOfDirections] = {};
  for (int i = 0; i < this->NumberOfDirections; ++i)
  {
    const optics::ConeRay ray = optics::ConeDirection(i, this->NumberOfDirections, cosine);
    double way[4] = { ray.slope.x, ray.slope.y, -1.0, 0.0 };
    vtkMatrix4x4::MultiplyPoint(viewToData, way, way);
    slopes[i][0] = static_cast<float>(ray.slope.x);
    slopes[i][1] = static_cast<float>(ray.slope.y);
    lengths[i] = static_cast<float>(vtkMath::Norm(way) / axis);
  }
  program->SetUniform2fv("in_sweepSlopes", LargestNumberOfDirections, slopes);
  program->SetUniform1fv("in_sweepLengths", LargestNumberOfDirections, lengths);
}

//------------------------------------------------------------------------------
void vtkVisibilitySweep::SetGeometry(const Volume& volume, const SweepGrid& grid, vtkShaderProgram* program)
{
  if (volume.Geometry)
  {
    volume.Geometry->Activate();
    program->SetUniformi("in_sweepGeometry", volume.Geometry->GetTextureUnit());
    const double range[3] = { volume.GeometryRange[0], volume.GeometryRange[1],
      grid.GetIsPerspective() ? 1.0 : 0.0 };
    program->SetUniform3f("in_sweepGeometryRange", range);
  }
}

//------------------------------------------------------------------------------
void vtkVisibilitySweep::SetDisk(vtkShaderProgram* program)
{
  program->SetUniformi("in_sweepDiskSize", this->DiskSize);
  program->SetUniformf("in_sweepTrueDistances", this->TrueDistances ? 1.0F : 0.0F);
  program->SetUniformf("in_sweepSolidAngles", this->Algorithm == DiskSolidAngle ? 1.0F : 0.0F);
  program->SetUniformf(
    "in_sweepConeTangent", static_cast<float>(std::tan(vtkMath::RadiansFromDegrees(this->ConeAngle))));
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
  os << indent << "GridSize: " << this->GridSize[0] << ' ' << this->GridSize[1] << ' ' << this->GridSize[2]
     << "\n";
}
