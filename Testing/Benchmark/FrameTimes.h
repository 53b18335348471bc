// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// How long frames of a window take.

#ifndef FrameTimes_h
#define FrameTimes_h

#include "vtkRenderWindow.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <ctime>
#include <vector>

namespace
{
inline double Median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

class FrameTimes
{
public:
  // A frame, until all of it is drawn.
  void Draw(vtkRenderWindow* window)
  {
    const auto begin = std::chrono::steady_clock::now();
    const std::clock_t clockBegin = std::clock();
    window->Render();
    window->WaitForCompletion();
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
    this->Seconds.push_back(elapsed.count());
    this->ProcessorSeconds.push_back(static_cast<double>(std::clock() - clockBegin) / CLOCKS_PER_SEC);
  }

  double GetSeconds() const { return Median(this->Seconds); }
  double GetProcessorSeconds() const { return Median(this->ProcessorSeconds); }

  // The median of the ratios of processor times of frames drawn one after the other.
  double GetRatio(const FrameTimes& other) const
  {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < this->ProcessorSeconds.size(); ++i)
    {
      ratios.push_back(this->ProcessorSeconds[i] / other.ProcessorSeconds[i]);
    }
    return Median(ratios);
  }

private:
  std::vector<double> Seconds, ProcessorSeconds;
};
}

#endif
