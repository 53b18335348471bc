// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Batches.h"

#include "vtkAlgorithm.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <chrono>

namespace volumeoptics
{
namespace
{
const double BatchSeconds = 0.03;
const long long LeastNumberOfBatches = 25;

double Seconds()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}
}

bool Batches::Run(long long count, double progressAtEnd, const std::function<void(long long)>& work)
{
  const double progressAtStart = this->Progress;
  const long long threads = std::max(vtkSMPTools::GetEstimatedNumberOfThreads(), 1);
  const long long largest = std::max(count / LeastNumberOfBatches, 1LL);
  long long size = std::min(threads, largest);
  for (long long done = 0; done < count && !this->Algorithm->GetAbortExecute();)
  {
    const long long end = std::min(done + size, count);
    const double start = Seconds();
    auto batch = [&work](vtkIdType first, vtkIdType last) {
      for (vtkIdType unit = first; unit < last; ++unit)
      {
        work(unit);
      }
    };
    vtkSMPTools::For(done, end, 1, batch);
    const double perUnit = std::max(Seconds() - start, 1.0e-7) / (end - done);
    done = end;
    this->Progress = progressAtStart + (progressAtEnd - progressAtStart) * done / count;
    this->Algorithm->UpdateProgress(this->Progress);
    const double wanted = std::min(BatchSeconds / perUnit, 4.0 * size);
    size = std::clamp(static_cast<long long>(wanted), std::min(threads, largest), largest);
  }
  this->Progress = progressAtEnd;
  return !this->Algorithm->GetAbortExecute();
}
}
