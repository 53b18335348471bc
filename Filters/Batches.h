// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Parallel work that reports progress and can be aborted.

#ifndef Batches_h
#define Batches_h

#include <functional>

class vtkAlgorithm;

namespace volumeoptics
{
// Runs units of work on all threads (vtkSMPTools), in batches of about 30 ms: between two of them
// the calling thread reports progress, and looks for AbortExecute. The results don't depend on the
// batches.
class Batches
{
public:
  explicit Batches(vtkAlgorithm* algorithm)
    : Algorithm(algorithm)
  {
  }

  // Reports progress from the last stage's end up to `progressAtEnd`. False if aborted.
  bool Run(long long count, double progressAtEnd, const std::function<void(long long)>& work);
  double GetProgress() const { return this->Progress; }

private:
  vtkAlgorithm* Algorithm;
  double Progress = 0.0;
};
}

#endif
