// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The counts of a histogram of pairs along the gradient, at its bins' numbers.

#ifndef PairCounts_h
#define PairCounts_h

#include <cstddef>
#include <vector>

class vtkImageData;

namespace volumeoptics
{
// Counts with S1 >= S2: a pair below the diagonal counts as the one above.
class PairCounts
{
public:
  explicit PairCounts(vtkImageData* histogram); // must be usable

  static bool IsUsable(vtkImageData* histogram); // square, with counts

  int GetBins() const { return this->Bins; }
  double Total() const;

  // Pairs at most as far apart still are of one material.
  double HomogeneousWidth() const;

  // Counts near the diagonal by the middle of their pair.
  std::vector<double> Diagonal() const;

  // visit(upper bin, lower bin, count) of all counts above 0.
  template <typename Visit>
  void ForEach(const Visit& visit) const
  {
    for (int lower = 0; lower < this->Bins; ++lower)
    {
      for (int upper = lower; upper < this->Bins; ++upper)
      {
        const double count = this->Counts[lower * this->Bins + upper];
        if (count > 0.0)
        {
          visit(upper, lower, count);
        }
      }
    }
  }

private:
  int Bins;
  std::vector<double> Counts;
};

// With a Gaussian of a standard deviation; 0 beyond the ends.
std::vector<double> Smoothed(const std::vector<double>& values, double deviation);
}

#endif
