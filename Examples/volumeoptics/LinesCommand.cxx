// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// volumeoptics lines: one picture of millions of lines, as anisotropic voxels.

#include "Commands.h"
#include "LineColors.h"
#include "LineFile.h"
#include "LineScene.h"
#include "PictureOptions.h"
#include "Progress.h"
#include "ReadingGuard.h"
#include "UserError.h"

#include "vtkAnalyticLineSource.h"

#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkImageData.h>
#include <vtkNamedColors.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <map>
#include <memory>

namespace
{
struct LinesOptions : PictureOptions
{
  LineSettings Lines;
  std::string Output = "out.png";
  std::string VoxelFile;
  std::string ColorText = "white";
  std::vector<double> WorldLight;
  vtkIdType Spirals = 0;
  bool ColorsByDirection = false;
  double OpacityScale = 1.0;
  LineRenderer Renderer = LineRenderer::Mapper;
};

vtkSmartPointer<vtkPolyData> MakeLines(const LinesOptions& options)
{
  if (options.Spirals <= 0)
  {
    return ReadLines(options.File);
  }
  vtkNew<vtkAnalyticLineSource> source;
  source->SetNumberOfSegments(options.Spirals);
  source->Update();
  return source->GetOutput();
}

void CheckArray(vtkPolyData* lines, const std::string& name)
{
  if (!name.empty() && !lines->GetPointData()->HasArray(name.c_str()) &&
    !lines->GetCellData()->HasArray(name.c_str()))
  {
    std::string names;
    for (vtkFieldData* data :
      { static_cast<vtkFieldData*>(lines->GetPointData()), static_cast<vtkFieldData*>(lines->GetCellData()) })
    {
      for (int i = 0; i < data->GetNumberOfArrays(); ++i)
      {
        names +=
          std::string(names.empty() ? "" : ", ") + (data->GetArrayName(i) ? data->GetArrayName(i) : "");
      }
    }
    throw UserError(
      "The lines have no array '" + name + "'. They have: " + (names.empty() ? "none" : names) + ".");
  }
}

vtkSmartPointer<vtkImageData> MakeVoxels(LinesOptions& options)
{
  const vtkSmartPointer<vtkPolyData> lines = MakeLines(options);
  if (options.ColorsByDirection)
  {
    options.Lines.ColorArray = ColorByDirection(lines);
  }
  CheckArray(lines, options.Lines.ColorArray);
  CheckArray(lines, options.Lines.RadiusArray);
  vtkNew<vtkNamedColors> colors;
  const vtkColor4ub color = options.ColorText[0] == '#' ? colors->HTMLColorToRGBA(options.ColorText)
                                                        : colors->GetColor4ub(options.ColorText);
  for (int i = 0; i < 3; ++i)
  {
    options.Lines.Color[i] = color[i] / 255.0;
  }
  std::copy(options.WorldLight.begin(), options.WorldLight.end(), options.Lines.WorldLight);
  vtkNew<vtkAnisotropicLineVoxelizer> voxelizer;
  voxelizer->SetInputData(lines);
  double bounds[6];
  lines->GetBounds(bounds);
  SetUpVoxelizer(options.Lines, options.Picture.Lights[0], bounds, voxelizer);
  Progress making("Voxelizing " + std::to_string(lines->GetNumberOfLines()) + " lines");
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&making);
  command->SetCallback([](vtkObject* caller, unsigned long, void* data, void*) {
    static_cast<Progress*>(data)->Update(vtkAlgorithm::SafeDownCast(caller)->GetProgress());
  });
  voxelizer->AddObserver(vtkCommand::ProgressEvent, command);
  const VtkMessages messages;
  voxelizer->Update();
  if (!messages.GetError().empty())
  {
    throw UserError("The lines cannot be voxelized: " + messages.GetError() + ".");
  }
  return voxelizer->GetOutput();
}

void Draw(LinesOptions& options)
{
  options.CompleteView();
  if (options.File.empty() && options.Spirals <= 0)
  {
    throw UserError("There is nothing to draw. Name a FILE, or draw --spirals 100000.");
  }
  const vtkSmartPointer<vtkImageData> voxels =
    IsVoxelFile(options.File) ? ReadVoxels(options.File) : MakeVoxels(options);
  LineScene scene(voxels, options.Picture, OffScreenWindow(options.Headless), options.Renderer);
  scene.LightAs(voxels);
  scene.SetRadiusScale(0, options.Lines.RadiusScale);
  scene.SetOpacityScale(0, options.OpacityScale);
  const double seconds = scene.Render();
  scene.GetScene().WritePng(options.Output);
  if (!options.VoxelFile.empty())
  {
    WriteVoxels(voxels, options.VoxelFile);
  }
  Progress::Say(options.Output + ": voxels of " + std::to_string(voxels->GetActualMemorySize() / 1024) +
    " MiB, frame with set-up " + TimeText(seconds));
}

void AddMaterial(CLI::App& command, LinesOptions& options)
{
  const auto group = "Material";
  command.add_option("--color", options.ColorText, "Colour of the lines, a name or #rrggbb")
    ->capture_default_str()
    ->group(group);
  command.add_option("--color-array", options.Lines.ColorArray, "Array of points or cells to colour by")
    ->group(group);
  command
    .add_flag("--color-by-direction", options.ColorsByDirection,
      "Red, green and blue by the direction along x, y and z, as of tractography")
    ->excludes("--color-array")
    ->group(group);
  const std::pair<const char*, double*> shares[] = { { "--ambient", &options.Lines.Ambient },
    { "--diffuse", &options.Lines.Diffuse }, { "--specular", &options.Lines.Specular } };
  for (const auto& [name, share] : shares)
  {
    command.add_option(name, *share, "Coefficient")
      ->check(CLI::Range(0.0, 10.0))
      ->capture_default_str()
      ->group(group);
  }
  command.add_option("--specular-power", options.Lines.SpecularPower, "Exponent of the highlight")
    ->check(CLI::Range(1.0, 1000.0))
    ->capture_default_str()
    ->group(group);
  command
    .add_option("--world-light", options.WorldLight,
      "Direction x,y,z to a light fixed in the world, instead of --light; voxels of a file keep theirs")
    ->delimiter(',')
    ->expected(3)
    ->group(group);
}

void AddVoxels(CLI::App& command, LinesOptions& options)
{
  const auto group = "Voxels";
  command.add_option("--grid", options.Lines.Grid, "Voxels along the longest side")
    ->check(CLI::Range(3, 2048))
    ->capture_default_str()
    ->group(group);
  command.add_option("--order", options.Lines.Order, "Degree of the spherical harmonics")
    ->check(CLI::Range(0, 12))
    ->capture_default_str()
    ->group(group);
  command.add_option("--radius", options.Lines.Radius, "Radius in world units; default a tenth of a voxel")
    ->check(CLI::PositiveNumber)
    ->group(group);
  command.add_option("--radius-array", options.Lines.RadiusArray, "Array of points or cells with radii")
    ->group(group);
  command.add_option("--radius-scale", options.Lines.RadiusScale, "Factor of the radius of what is drawn")
    ->check(CLI::Range(0.0, 1e6))
    ->capture_default_str()
    ->group(group);
  command.add_option("--opacity-scale", options.OpacityScale, "Factor of the opacity of what is drawn")
    ->check(CLI::Range(0.0, 1.0))
    ->capture_default_str()
    ->group(group);
  command
    .add_option(
      "--tolerance", options.Lines.Tolerance, "Share of a voxel's energy that dropped coefficients may have")
    ->check(CLI::Range(0.0, 1.0))
    ->capture_default_str()
    ->group(group);
  command
    .add_option("--voxels", options.VoxelFile, "Write the voxels, too (.vti, to be drawn instead of lines)")
    ->group(group);
}
}

void AddLinesCommand(CLI::App& program)
{
  const auto options = std::make_shared<LinesOptions>();
  CLI::App* command = program.add_subcommand("lines", "Draw lines as anisotropic voxels into a PNG file");
  command->add_option("FILE", options->File, "Lines: .vtp or .vtk with vtkPolyData; or voxels: .vti");
  const std::map<std::string, LineRenderer> renderers = { { "mapper", LineRenderer::Mapper },
    { "evaluator", LineRenderer::Evaluator } };
  command
    ->add_option("--renderer", options->Renderer,
      "What evaluates the voxels: mapper (on the GPU, the default) or evaluator (a filter, for any mapper)")
    ->transform(CLI::CheckedTransformer(renderers, CLI::ignore_case));
  command
    ->add_option("--spirals", options->Spirals, "Draw vortex spirals of so many segments instead of a file")
    ->check(CLI::PositiveNumber)
    ->excludes("FILE");
  AddVoxels(*command, *options);
  AddMaterial(*command, *options);
  options->BackgroundText = "black";
  options->AddVisibilityTo(*command);
  options->AddViewTo(*command);
  command->add_option("-o,--output", options->Output, "Picture to write (PNG)")->capture_default_str();
  command->add_flag("--headless", options->Headless, "Use no X server (the default without DISPLAY)");
  command->callback([options] { Draw(*options); });
}
