// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// At least 20 progress events from the calling thread, rising from 0 to 1; an abort is honoured
// within 0.2 s at 256^3, whatever the sampling.

#include "FilterTesting.h"
#include "vtkAmbientCovarianceFilter.h"
#include "vtkCallbackCommand.h"
#include "vtkGradientAlignedHistogram.h"
#include "vtkPrincipalCurvatureFilter.h"
#include "vtkSobelNormalFilter.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <thread>

namespace
{
// Sanitizers make a filter a few times slower.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
const double LongestWait = 0.8;
#else
const double LongestWait = 0.2;
#endif

struct Instant
{
  double Wall;
  double Processor; // of all threads
};

Instant Now()
{
  const auto wall = std::chrono::steady_clock::now().time_since_epoch();
  return { std::chrono::duration<double>(wall).count(), static_cast<double>(std::clock()) / CLOCKS_PER_SEC };
}

// Seconds, without those that other programs had the processors for.
double Since(const Instant& begin)
{
  const Instant now = Now();
  return std::min(now.Wall - begin.Wall, now.Processor - begin.Processor);
}

struct Watch
{
  int Events = 0;
  double Last = 0.0;
  bool Rises = true;
  bool OnOwnThread = true;
  std::thread::id Thread = std::this_thread::get_id();
  double AbortAt = 2.0; // progress
  bool IsAborted = false;
  Instant AbortTime = {};
  double AbortAfter = 1.0e9; // seconds from Start
  Instant Start = Now();
  Instant LastTime = Start;
  double LongestGap = 0.0; // between events: the longest wait for an abort from another thread
};

void OnProgress(vtkObject* caller, unsigned long, void* data, void*)
{
  auto* filter = vtkAlgorithm::SafeDownCast(caller);
  auto* watch = static_cast<Watch*>(data);
  const double progress = filter->GetProgress();
  ++watch->Events;
  watch->LongestGap = std::max(watch->LongestGap, Since(watch->LastTime));
  watch->LastTime = Now();
  watch->Rises = watch->Rises && progress >= watch->Last;
  watch->Last = progress;
  watch->OnOwnThread = watch->OnOwnThread && std::this_thread::get_id() == watch->Thread;
  const bool isTime = progress >= watch->AbortAt || Now().Wall - watch->Start.Wall > watch->AbortAfter;
  if (isTime && !watch->IsAborted)
  {
    watch->IsAborted = true;
    watch->AbortTime = Now();
    filter->AbortExecuteOn();
  }
}

void Observe(vtkAlgorithm* filter, Watch& watch)
{
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(OnProgress);
  command->SetClientData(&watch);
  filter->RemoveObservers(vtkCommand::ProgressEvent);
  filter->AddObserver(vtkCommand::ProgressEvent, command);
}

void CheckProgress(vtkOpticsImageFilter* filter, vtkImageData* image, testing::Report& report)
{
  const std::string name = filter->GetClassName();
  Watch watch;
  Observe(filter, watch);
  filter->SetInputData(image);
  filter->Update();
  report.CheckAtLeast(watch.Events, 20, name + ": progress events");
  report.Check(watch.Rises && watch.Last == 1.0, name + ": progress rises to 1");
  report.Check(watch.OnOwnThread, name + ": progress comes from the calling thread");
}

// The longest time between two events bounds the wait for an abort at any time.
void CheckAbort(
  vtkOpticsImageFilter* filter, vtkImageData* image, const std::string& setting, testing::Report& report)
{
  const std::string name = std::string(filter->GetClassName()) + " " + setting;
  Watch watch;
  watch.AbortAt = 0.3; // or, of a filter that is slow, after a while
  watch.AbortAfter = 0.3;
  Observe(filter, watch);
  filter->SetInputData(image);
  filter->Update();
  const double waited = Since(watch.AbortTime);
  report.Check(watch.IsAborted, name + ": was aborted");
  report.CheckAtMost(waited, LongestWait, name + ": seconds from the abort to the end");
  report.CheckAtMost(watch.LongestGap, LongestWait, name + ": longest seconds between looks at the abort");
  report.Check(filter->GetOutput()->GetPointData()->GetNumberOfArrays() == 0, name + ": no array is left");
  filter->AbortExecuteOff();
}
}

int TestFilterProgressAndAbort(int, char*[])
{
  testing::Report report;
  testing::Geometry small;
  small.Extent = { 0, 63, 0, 63, 0, 63 };
  const testing::Field field = [](const glm::dvec3& p) { return testing::Noise(p); };
  const auto smallImage = testing::MakeImage(small, field);
  vtkNew<vtkSobelNormalFilter> sobel;
  vtkNew<vtkAmbientCovarianceFilter> covariance;
  vtkNew<vtkPrincipalCurvatureFilter> curvature;
  CheckProgress(sobel, smallImage, report);
  CheckProgress(covariance, smallImage, report);
  CheckProgress(curvature, smallImage, report);
  vtkNew<vtkGradientAlignedHistogram> histogram;
  CheckProgress(histogram, smallImage, report);

  testing::Geometry large;
  large.Extent = { 0, 255, 0, 255, 0, 255 };
  const auto image = testing::MakeImage(large, [](const glm::dvec3& p) { return p.x * p.y - p.z; });
  CheckAbort(sobel, image, "", report);
  CheckAbort(curvature, image, "", report);
  CheckAbort(histogram, image, "", report);
  covariance->SetRadius(30.0);
  for (int pattern = vtkAmbientCovarianceFilter::Shared; pattern <= vtkAmbientCovarianceFilter::Exhaustive;
       ++pattern)
  {
    covariance->SetSamplingPattern(pattern);
    CheckAbort(covariance, image, covariance->GetSamplingPatternAsString(), report);
  }
  covariance->SetSamplingPatternToShared();
  covariance->SetNumberOfSamples(10000);
  covariance->SetSampleInterpolationToLinear();
  CheckAbort(covariance, image, "10000 linear samples", report);
  return report.ExitCode();
}
