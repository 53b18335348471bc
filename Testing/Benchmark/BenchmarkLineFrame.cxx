// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Frames of spirals as anisotropic voxels, as tubes and as lines, by the number of segments ([Schussman2004] Fig. 9).
// Ever finer segments of the same lines fill the same voxels, as do the same lines many times over: thinner, so that
// opacity is the same, or as thick, so that voxels are ever more opaque. More lines, of one radius, fill more voxels. All
// settings are drawn in turn, so that other programs on the machine slow all of them down; medians of each,
// ratios of medians. Writes CSV to standard output: real and processor time, as ms.
//
// BenchmarkLineFrame [rounds, 9] [largest number of segments of voxels, 1e7] [... of tubes and lines, 1e6]

#include "FrameTimes.h"
#include "vtkAnalyticLineSource.h"
#include "vtkAnisotropicLineVoxelizer.h"
#include "vtkHeadlessRenderWindow.h"
#include "vtkOpticsVolumeMapper.h"
#include "vtkOpticsVolumeProperty.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderer.h"
#include "vtkTubeFilter.h"
#include "vtkVolume.h"

#include <cstdlib>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace
{
const int PictureSize = 400;
const double Radius = 0.0005;
const vtkIdType LinesOfFineSegments = 500;

// One thing in one window.
struct Subject
{
  std::string Kind;
  vtkIdType Segments = 0, OccupiedVoxels = 0;
  vtkNew<vtkHeadlessRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  FrameTimes Times;

  Subject(const std::string& kind, vtkIdType segments)
    : Kind(kind)
    , Segments(segments)
  {
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(PictureSize, PictureSize);
    this->Window->AddRenderer(this->Renderer);
  }

  // From a camera that has moved.
  void Draw()
  {
    this->Renderer->GetActiveCamera()->Azimuth(7.0);
    this->Times.Draw(this->Window);
  }

  void PlaceCamera()
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(0.0, -4.0, 2.0);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetViewAngle(30.0);
    this->Renderer->ResetCameraClippingRange();
  }
};

using Subjects = std::vector<std::unique_ptr<Subject>>;

vtkSmartPointer<vtkPolyData> MakeSpirals(vtkIdType segments, vtkIdType segmentsPerLine)
{
  vtkNew<vtkAnalyticLineSource> source;
  source->SetNumberOfSegments(segments);
  source->SetSegmentsPerLine(static_cast<int>(segmentsPerLine));
  source->Update();
  return source->GetOutput();
}

vtkIdType SegmentsOf(vtkPolyData* lines)
{
  return lines->GetNumberOfPoints() - lines->GetNumberOfLines();
}

// copies: how many times over the lines are counted.
void AddVoxels(
  Subjects& all, const std::string& kind, vtkPolyData* lines, double radius = Radius, int copies = 1)
{
  all.push_back(std::make_unique<Subject>(kind, copies * SegmentsOf(lines)));
  vtkNew<vtkAnisotropicLineVoxelizer> voxelizer;
  voxelizer->SetInputData(lines);
  voxelizer->SetSampleDimensions(256, 256, 256);
  voxelizer->SetModelBounds(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0);
  voxelizer->SetRadius(radius);
  voxelizer->SetNumberOfPieces(copies); // data that stand alone are given for each piece
  voxelizer->Update();
  vtkDataArray* places = voxelizer->GetOutput()->GetFieldData()->GetArray("LineType0_Places");
  all.back()->OccupiedVoxels = places ? places->GetNumberOfTuples() : 0;
  vtkNew<vtkOpticsVolumeMapper> mapper;
  mapper->SetInputData(voxelizer->GetOutput());
  mapper->SetAutoAdjustSampleDistances(0);
  mapper->SetSampleDistance(1.0F / 256.0F); // half a voxel
  vtkNew<vtkOpticsVolumeProperty> property;
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->SetProperty(property);
  all.back()->Renderer->AddVolume(volume);
}

void AddGeometry(Subjects& all, const std::string& kind, vtkPolyData* lines)
{
  all.push_back(std::make_unique<Subject>(kind, SegmentsOf(lines)));
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(lines);
  mapper->ScalarVisibilityOff();
  if (kind == "tubes")
  {
    vtkNew<vtkTubeFilter> tubes;
    tubes->SetInputData(lines);
    tubes->SetRadius(Radius);
    tubes->SetNumberOfSides(6);
    mapper->SetInputConnection(tubes->GetOutputPort());
  }
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  all.back()->Renderer->AddActor(actor);
}

// In milliseconds.
using Time = double (FrameTimes::*)() const;

const Time Real = &FrameTimes::GetSeconds;
const Time Processor = &FrameTimes::GetProcessorSeconds;

double TimeOf(const Subject& subject, Time time)
{
  return 1000.0 * (subject.Times.*time)();
}

double DensestVoxels(const Subjects& all, Time time)
{
  double densest = 0.0;
  for (const auto& subject : all)
  {
    densest = subject->Kind == "voxels of more lines" ? TimeOf(*subject, time) : densest;
  }
  return densest;
}

// Where the straight line through the two largest of a kind meets the voxels' time; 0 if it falls.
double Crossover(const Subjects& all, const std::string& kind, Time time)
{
  std::vector<const Subject*> some;
  for (const auto& subject : all)
  {
    if (subject->Kind == kind)
    {
      some.push_back(subject.get());
    }
  }
  if (some.size() < 2)
  {
    return 0.0;
  }
  const Subject &few = *some[some.size() - 2], &many = *some.back();
  const double more = TimeOf(many, time) - TimeOf(few, time);
  const double slope = more / static_cast<double>(many.Segments - few.Segments);
  const double left = DensestVoxels(all, time) - TimeOf(many, time);
  return slope > 0.0 ? static_cast<double>(many.Segments) + left / slope : 0.0;
}

void Report(const Subjects& all)
{
  std::cout << "kind,segments,occupied voxels,real ms,processor ms,real over the densest voxels,processor "
               "over them\n";
  for (const auto& subject : all)
  {
    std::cout << subject->Kind << "," << subject->Segments << "," << subject->OccupiedVoxels << ","
              << TimeOf(*subject, Real) << "," << TimeOf(*subject, Processor) << ","
              << TimeOf(*subject, Real) / DensestVoxels(all, Real) << ","
              << TimeOf(*subject, Processor) / DensestVoxels(all, Processor) << "\n";
  }
  for (const char* kind : { "tubes", "lines" })
  {
    std::cout << "crossover with " << kind << " in real time," << Crossover(all, kind, Real) << "\n"
              << "crossover with " << kind << " in processor time," << Crossover(all, kind, Processor)
              << "\n";
  }
}
}

int main(int argc, char* argv[])
{
  const int rounds = argc > 1 ? std::atoi(argv[1]) : 9;
  const auto largest = static_cast<vtkIdType>(argc > 2 ? std::atof(argv[2]) : 1e7);
  const auto largestGeometry = static_cast<vtkIdType>(argc > 3 ? std::atof(argv[3]) : 1e6);
  Subjects all;
  const vtkIdType fewest = 100000;
  const vtkSmartPointer<vtkPolyData> few = MakeSpirals(fewest, 200);
  for (vtkIdType segments = fewest; segments <= largest; segments *= 10)
  {
    const int copies = static_cast<int>(segments / fewest);
    AddVoxels(all, "voxels of finer segments", MakeSpirals(segments, segments / LinesOfFineSegments));
    AddVoxels(all, "voxels of the same lines made thinner", few, Radius / copies, copies);
    AddVoxels(all, "voxels of the same lines as thick", few, Radius, copies);
    AddVoxels(all, "voxels of more lines", MakeSpirals(segments, 200));
  }
  for (vtkIdType segments = 10000; segments <= largestGeometry; segments *= 10)
  {
    const vtkSmartPointer<vtkPolyData> lines = MakeSpirals(segments, 200);
    AddGeometry(all, "tubes", lines);
    AddGeometry(all, "lines", lines);
  }
  for (const auto& subject : all)
  {
    subject->PlaceCamera();
    subject->Window->Render(); // compiles, uploads
  }
  for (int round = 0; round < rounds; ++round)
  {
    for (const auto& subject : all)
    {
      subject->Draw();
    }
  }
  Report(all);
  return 0;
}
