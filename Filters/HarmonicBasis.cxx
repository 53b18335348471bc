// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HarmonicBasis.h"

#include "Optics.h"

#include <algorithm>

namespace volumeoptics
{
HarmonicBasis::HarmonicBasis(int maximumOrder, bool evenOnly)
  : MaximumOrder(maximumOrder)
  , Sectoral(maximumOrder + 1, 1.0)
{
  for (int l = 0; l <= maximumOrder; l += evenOnly ? 2 : 1)
  {
    for (int m = -l; m <= l; ++m)
    {
      this->Degrees.push_back(l);
      this->Indices.push_back(l * (l + 1) + m);
    }
  }
  for (int m = 0; m <= maximumOrder; ++m)
  {
    this->Sectoral[m] = m > 0 ? optics::SectoralFactor(m) : 1.0;
    this->Steps.push_back({ 0.0, 0.0, this->PlaceOf(m, m), this->PlaceOf(m, -m) });
    for (int l = m + 1; l <= maximumOrder; ++l)
    {
      this->Steps.push_back({ optics::LegendreGain(l, m), optics::LegendreLoss(l, m), this->PlaceOf(l, m),
        this->PlaceOf(l, -m) });
    }
  }
}

int HarmonicBasis::PlaceOf(int l, int m) const
{
  const auto found = std::find(this->Indices.begin(), this->Indices.end(), l * (l + 1) + m);
  return found == this->Indices.end() ? -1 : static_cast<int>(found - this->Indices.begin());
}

void HarmonicBasis::Evaluate(const glm::dvec3& direction, double* values) const
{
  const Step* step = this->Steps.data();
  glm::dvec2 azimuth(optics::ConstantHarmonic, 0.0);
  for (int m = 0; m <= this->MaximumOrder; ++m)
  {
    azimuth = m > 0 ? this->Sectoral[m] * optics::NextAzimuth(azimuth, direction) : azimuth;
    double value = 1.0, before = 0.0;
    for (int l = m; l <= this->MaximumOrder; ++l, ++step)
    {
      if (l > m)
      {
        const double next = optics::NextLegendre(value, before, direction.z, step->Gain, step->Loss);
        before = value;
        value = next;
      }
      if (step->Cosine >= 0)
      {
        values[step->Sine] = value * azimuth.y;
        values[step->Cosine] = value * azimuth.x;
      }
    }
  }
}

std::vector<double> HarmonicBasis::Weighted(const std::vector<WeightedDirection>& directions) const
{
  std::vector<double> weighted(directions.size() * this->GetCount());
  double* row = weighted.data();
  for (const WeightedDirection& node : directions)
  {
    this->Evaluate(node.Direction, row);
    std::transform(row, row + this->GetCount(), row, [&](double value) { return value * node.Weight; });
    row += this->GetCount();
  }
  return weighted;
}
}
