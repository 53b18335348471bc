// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PairCounts.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace volumeoptics
{
namespace
{
const double HomogeneousShare = 1.0 / 32.0; // of the range
}

bool PairCounts::IsUsable(vtkImageData* histogram)
{
  vtkDataArray* values = histogram ? histogram->GetPointData()->GetScalars() : nullptr;
  return values && values->GetNumberOfTuples() > 0 &&
    histogram->GetDimensions()[0] == histogram->GetDimensions()[1];
}

PairCounts::PairCounts(vtkImageData* histogram)
  : Bins(histogram->GetDimensions()[0])
  , Counts(static_cast<std::size_t>(Bins) * Bins)
{
  vtkDataArray* values = histogram->GetPointData()->GetScalars();
  for (int row = 0; row < this->Bins; ++row)
  {
    for (int column = 0; column < this->Bins; ++column)
    {
      const double count = values->GetComponent(column + static_cast<vtkIdType>(row) * this->Bins, 0);
      this->Counts[std::min(row, column) * this->Bins + std::max(row, column)] +=
        count > 0.0 && std::isfinite(count) ? count : 0.0;
    }
  }
}

double PairCounts::Total() const
{
  return std::accumulate(this->Counts.begin(), this->Counts.end(), 0.0);
}

double PairCounts::HomogeneousWidth() const
{
  return HomogeneousShare * this->Bins;
}

std::vector<double> PairCounts::Diagonal() const
{
  std::vector<double> diagonal(this->Bins);
  this->ForEach([&](int upper, int lower, double count) {
    if (upper - lower <= this->HomogeneousWidth())
    {
      diagonal[(upper + lower) / 2] += count / 2.0;
      diagonal[(upper + lower + 1) / 2] += count / 2.0;
    }
  });
  return diagonal;
}

std::vector<double> Smoothed(const std::vector<double>& values, double deviation)
{
  const int reach = static_cast<int>(std::ceil(3.0 * deviation));
  const int count = static_cast<int>(values.size());
  std::vector<double> smoothed(values.size());
  for (int i = 0; i < count; ++i)
  {
    double weights = 0.0;
    for (int offset = -reach; offset <= reach; ++offset)
    {
      const double weight =
        offset == 0 ? 1.0 : std::exp(-0.5 * offset * offset / std::max(deviation * deviation, 1e-9));
      weights += weight;
      smoothed[i] += i + offset >= 0 && i + offset < count ? weight * values[i + offset] : 0.0;
    }
    smoothed[i] /= weights;
  }
  return smoothed;
}

}
