// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The filters of images under MPI: the pieces of any number of processes are bit for bit the whole, with
// the ghost layers that a filter asks for, the scalar range and the histogram of all; also where there are
// more processes than slices or cells.

#include "../Cxx/FilterTesting.h"
#include "OwnedExtent.h"
#include "Processes.h"
#include "vtkAmbientCovarianceFilter.h"
#include "vtkGradientAlignedHistogram.h"
#include "vtkPrincipalCurvatureFilter.h"
#include "vtkSobelNormalFilter.h"

#include "vtkCallbackCommand.h"
#include "vtkExecutive.h"
#include "vtkExtentTranslator.h"
#include "vtkFloatingPointExceptions.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkTrivialProducer.h"

#include <algorithm>

namespace
{
using Image = vtkSmartPointer<vtkImageData>;

struct Scene
{
  std::string Name;
  Image Whole;
};

Scene MakeScene(const std::string& name, const std::array<int, 6>& extent)
{
  testing::Geometry geometry;
  geometry.Extent = extent;
  geometry.Spacing = glm::dvec3(1.0, 1.3, 2.1);
  geometry.Direction = testing::Rotation();
  return { name, testing::MakeImage(geometry, [](const glm::dvec3& p) {
            const double value =
              std::sin(0.3 * p.x) + std::cos(0.2 * p.y + 0.25 * p.z) + 0.2 * testing::Noise(p);
            return testing::Noise(p, 1.0) < 0.002 ? std::nan("") : value;
          }) };
}

// The cells of a process's piece, without ghosts. An axis of one point counts where the whole has one.
double NumberOfOwnCells(vtkImageData* piece, vtkImageData* whole)
{
  const volumeoptics::Extent owned = volumeoptics::OwnedExtent(piece);
  double cells = volumeoptics::IsEmpty(owned) ? 0.0 : 1.0;
  int dimensions[3];
  whole->GetDimensions(dimensions);
  for (int axis = 0; axis < 3; ++axis)
  {
    const int length = owned[2 * axis + 1] - owned[2 * axis];
    cells *= length == 0 && dimensions[axis] == 1 ? 1.0 : length;
  }
  return cells;
}

Image WholeOf(vtkOpticsImageFilter* filter, vtkImageData* image, int port = 0)
{
  filter->SetController(nullptr);
  filter->SetInputData(image);
  filter->Update();
  auto whole = Image::New();
  whole->ShallowCopy(filter->GetOutputDataObject(port));
  return whole;
}

class FilterTest
{
public:
  FilterTest(Processes& processes, testing::Report& report)
    : All(processes)
    , Result(report)
  {
  }

  void Pieces(vtkOpticsImageFilter* filter, const char* array, const Scene& scene, const std::string& name)
  {
    const Image whole = WholeOf(filter, scene.Whole);
    vtkNew<testing::RecordingSource> source;
    source->SetImage(scene.Whole);
    filter->SetInputConnection(source->GetOutputPort());
    filter->SetController(vtkMultiProcessController::GetGlobalController());
    for (int ghosts : { 0, 2 })
    {
      const std::string what = scene.Name + ", " + name + ", " + std::to_string(ghosts) + " ghost layers: ";
      filter->UpdatePiece(this->All.Rank(), this->All.Size(), ghosts);
      this->Compare(whole, filter->GetOutput(), array, what);
    }
  }

  void Compare(vtkImageData* whole, vtkImageData* piece, const char* array, const std::string& what)
  {
    const bool isEmpty = piece->GetNumberOfPoints() == 0;
    this->Result.CheckAtMost(
      isEmpty ? 0.0 : testing::CountDifferent(whole, piece, array), 0.0, what + "voxels that differ");
    this->Result.CheckAtMost(
      std::abs(this->All.Sum(NumberOfOwnCells(piece, whole)) - NumberOfOwnCells(whole, whole)), 0.0,
      what + "cells missing");
  }

  void Histogram(const Scene& scene, double factor)
  {
    vtkNew<vtkGradientAlignedHistogram> histogram;
    histogram->SetNumberOfBins(32);
    histogram->SetResolutionFactor(factor);
    const Image wholes[2] = { WholeOf(histogram, scene.Whole, 0), WholeOf(histogram, scene.Whole, 1) };
    vtkNew<testing::RecordingSource> source;
    source->SetImage(scene.Whole);
    histogram->SetInputConnection(source->GetOutputPort());
    histogram->SetController(vtkMultiProcessController::GetGlobalController());
    histogram->UpdatePiece(this->All.Rank(), this->All.Size(), 1);
    for (int port = 0; port < 2; ++port)
    {
      const std::string what = scene.Name + ", histogram " + std::to_string(port);
      auto* counts = vtkImageData::SafeDownCast(histogram->GetOutputDataObject(port));
      this->Result.CheckAtMost(
        testing::CountDifferent(wholes[port], counts, "Counts"), 0.0, what + ": bins that differ");
      this->Result.CheckAtMost(glm::distance(glm::dvec3(counts->GetOrigin()[0], counts->GetOrigin()[1], 0.0),
                                 glm::dvec3(wholes[port]->GetOrigin()[0], wholes[port]->GetOrigin()[1], 0.0)),
        0.0, what + ": origins apart");
    }
    histogram->ResultOnAllProcessesOff();
    histogram->UpdatePiece(this->All.Rank(), this->All.Size(), 1);
    this->Result.Check((histogram->GetOutput()->GetNumberOfPoints() > 0) == (this->All.Rank() == 0),
      scene.Name + ": the first process alone has the histogram");
    if (this->All.Size() > 1)
    {
      long long largest = 0;
      for (const auto& request : source->Requests)
      {
        largest += request == WholeExtent(scene);
      }
      this->Result.Check(largest == 0 || scene.Name != "block", "the histogram asks for the whole");
    }
  }

private:
  static std::array<int, 6> WholeExtent(const Scene& scene)
  {
    std::array<int, 6> extent;
    scene.Whole->GetExtent(extent.data());
    return extent;
  }

  Processes& All;
  testing::Report& Result;
};

void CheckFilters(FilterTest& test, const Scene& scene)
{
  for (const double factor : { 1.0, 0.6 })
  {
    const std::string at = " at " + std::to_string(factor);
    vtkNew<vtkSobelNormalFilter> sobel;
    sobel->SetResolutionFactor(factor);
    sobel->SetSmoothing(1.0);
    test.Pieces(sobel, "Normals", scene, "Sobel" + at);
    test.Pieces(sobel, "GradientMagnitude", scene, "Sobel" + at);
    vtkNew<vtkPrincipalCurvatureFilter> curvature;
    curvature->SetResolutionFactor(factor);
    test.Pieces(curvature, "AmbientCovariance", scene, "curvature" + at);
    vtkNew<vtkAmbientCovarianceFilter> covariance;
    covariance->SetResolutionFactor(factor);
    covariance->SetRadius(3.0);
    covariance->SetNumberOfSamples(40);
    covariance->SetFilterStandardDeviation(0.5);
    test.Pieces(covariance, "AmbientCovariance", scene, "covariance" + at);
    covariance->SetSamplingPatternToPerBlock();
    covariance->SetScalarRange(-2.0, 2.0);
    test.Pieces(covariance, "AmbientCovariance", scene, "covariance per block" + at);
    test.Histogram(scene, factor);
  }
}

// A chain: the covariance by the normals of another filter.
void CheckNormalsInput(Processes& all, FilterTest& test, const Scene& scene)
{
  vtkNew<vtkSobelNormalFilter> sobel;
  vtkNew<vtkAmbientCovarianceFilter> covariance;
  covariance->SetRadius(3.0);
  covariance->SetNormalsConnection(sobel->GetOutputPort());
  sobel->SetInputData(scene.Whole);
  const Image whole = WholeOf(covariance, scene.Whole);
  vtkNew<testing::RecordingSource> source;
  source->SetImage(scene.Whole);
  sobel->SetInputConnection(source->GetOutputPort());
  covariance->SetInputConnection(source->GetOutputPort());
  covariance->SetController(vtkMultiProcessController::GetGlobalController());
  covariance->UpdatePiece(all.Rank(), all.Size(), 1);
  test.Compare(whole, covariance->GetOutput(), "AmbientCovariance", "normals from another filter: ");
}

// The piece of a program that has no more of the volume than this.
Image MakePiece(Processes& all, vtkImageData* whole, int ghosts)
{
  int extent[6], own[6];
  vtkNew<vtkExtentTranslator> translator;
  translator->PieceToExtentThreadSafe(
    all.Rank(), all.Size(), 0, whole->GetExtent(), own, vtkExtentTranslator::BLOCK_MODE, 0);
  translator->PieceToExtentThreadSafe(
    all.Rank(), all.Size(), ghosts, whole->GetExtent(), extent, vtkExtentTranslator::BLOCK_MODE, 0);
  auto piece = Image::New();
  piece->ShallowCopy(whole);
  piece->Crop(extent);
  piece->GenerateGhostArray(own);
  return piece;
}

int CountWarnings(vtkAlgorithm* filter, const std::function<void()>& update)
{
  int warnings = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&warnings);
  count->SetCallback([](vtkObject*, unsigned long, void* client, void*) { ++*static_cast<int*>(client); });
  filter->AddObserver(vtkCommand::WarningEvent, count);
  filter->AddObserver(vtkCommand::ErrorEvent, count);
  vtkNew<vtkCallbackCommand> silence; // of the executive, which repeats that there was an error
  silence->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, silence);
  update();
  filter->GetExecutive()->RemoveObserver(silence);
  filter->RemoveObserver(count);
  return warnings;
}

// Pieces that the pipeline cannot make larger: with enough ghost layers all is well, with fewer it is said.
void CheckFixedPieces(Processes& all, FilterTest& test, const Scene& scene, testing::Report& report)
{
  vtkNew<vtkAmbientCovarianceFilter> covariance;
  covariance->SetRadius(3.0);
  const Image whole = WholeOf(covariance, scene.Whole);
  covariance->SetController(vtkMultiProcessController::GetGlobalController());
  for (int ghosts : { 4, 1 })
  {
    const Image piece = MakePiece(all, scene.Whole, ghosts);
    vtkNew<vtkTrivialProducer> producer;
    producer->SetOutput(piece);
    producer->SetWholeExtent(scene.Whole->GetExtent());
    covariance->SetInputConnection(producer->GetOutputPort());
    const int warnings =
      CountWarnings(covariance, [&] { covariance->UpdatePiece(all.Rank(), all.Size(), 0); });
    const bool isEnough = ghosts == 4 || all.Size() == 1;
    report.Check(warnings == (isEnough ? 0 : 1), std::to_string(ghosts) + " ghost layers: warnings");
    if (isEnough)
    {
      test.Compare(whole, covariance->GetOutput(), "AmbientCovariance", "fixed pieces: ");
    }
  }
  vtkNew<vtkGradientAlignedHistogram> histogram;
  const Image counts = WholeOf(histogram, scene.Whole);
  histogram->SetController(vtkMultiProcessController::GetGlobalController());
  const Image piece = MakePiece(all, scene.Whole, 2);
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(piece);
  producer->SetWholeExtent(scene.Whole->GetExtent());
  histogram->SetInputConnection(producer->GetOutputPort());
  histogram->UpdatePiece(all.Rank(), all.Size(), 0);
  report.CheckAtMost(
    testing::CountDifferent(counts, histogram->GetOutput(), "Counts"), 0.0, "fixed pieces: bins that differ");
}

// One process has the whole volume, the others nothing, as with readers that know no pieces.
void CheckOneProcessHasAll(Processes& all, FilterTest& test, const Scene& scene)
{
  vtkNew<vtkAmbientCovarianceFilter> covariance;
  covariance->SetRadius(3.0);
  const Image whole = WholeOf(covariance, scene.Whole);
  vtkNew<vtkImageData> nothing;
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(all.Rank() == all.Size() - 1 ? scene.Whole.Get() : nothing.Get());
  producer->SetWholeExtent(scene.Whole->GetExtent());
  covariance->SetInputConnection(producer->GetOutputPort());
  covariance->SetController(vtkMultiProcessController::GetGlobalController());
  covariance->UpdatePiece(all.Rank(), all.Size(), 0);
  test.Compare(whole, covariance->GetOutput(), "AmbientCovariance", "one process has all: ");
}

// Blocks, of which each process has another number, are volumes of their own.
void CheckBlocks(Processes& all, const Scene& scene, testing::Report& report)
{
  vtkNew<vtkAmbientCovarianceFilter> covariance;
  covariance->SetRadius(3.0);
  const Image whole = WholeOf(covariance, scene.Whole);
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (int block = 0; block <= all.Rank(); ++block)
  {
    blocks->SetBlock(block, scene.Whole);
  }
  covariance->SetInputDataObject(blocks);
  covariance->SetController(vtkMultiProcessController::GetGlobalController());
  covariance->UpdatePiece(all.Rank(), all.Size(), 0);
  auto* output = vtkMultiBlockDataSet::SafeDownCast(covariance->GetOutputDataObject(0));
  report.Check(output != nullptr, "blocks give blocks");
  for (int block = 0; output && block <= all.Rank(); ++block)
  {
    auto* image = vtkImageData::SafeDownCast(output->GetBlock(block));
    report.CheckAtMost(image ? testing::CountDifferent(whole, image, "AmbientCovariance") : 1.0, 0.0,
      "block " + std::to_string(block) + ": voxels that differ");
  }
}

// A process without the array fails in words, and no other one waits for it.
void CheckMissingArray(Processes& all, const Scene& scene, testing::Report& report)
{
  vtkNew<vtkImageData> piece;
  piece->DeepCopy(scene.Whole);
  if (all.Rank() == 0)
  {
    piece->GetPointData()->Initialize();
  }
  vtkNew<vtkGradientAlignedHistogram> histogram;
  histogram->SetInputData(piece);
  vtkNew<vtkAmbientCovarianceFilter> covariance;
  covariance->SetInputData(piece);
  const auto update = [&](vtkAlgorithm* filter) {
    return CountWarnings(filter, [&] { filter->UpdatePiece(all.Rank(), all.Size(), 0); });
  };
  report.Check(update(histogram) == 1, "every process says that there is no histogram");
  report.Check(histogram->GetOutput()->GetNumberOfPoints() == 0, "no histogram");
  report.Check(update(covariance) == (all.Rank() == 0), "the process without the array says so");
}
}

int main(int argc, char* argv[])
{
  Processes all(argc, argv);
  vtkFloatingPointExceptions::Disable(); // comparisons with NaN are meant
  testing::Report report;
  FilterTest test(all, report);
  const Scene block = MakeScene("block", { -5, 20, 3, 27, -7, 16 });
  for (const Scene& scene : { block, MakeScene("three slices", { 0, 8, 0, 7, 0, 2 }),
         MakeScene("one slice", { 0, 8, 2, 9, 4, 4 }), MakeScene("one cell", { 0, 1, 0, 1, 0, 1 }) })
  {
    CheckFilters(test, scene);
  }
  CheckNormalsInput(all, test, block);
  CheckFixedPieces(all, test, block, report);
  CheckOneProcessHasAll(all, test, block);
  CheckBlocks(all, block, report);
  CheckMissingArray(all, block, report);
  return all.ExitCode(report.ExitCode());
}
