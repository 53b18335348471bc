// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CylinderProjection.h"

#include "Batches.h"
#include "Optics.h"
#include "SphereDirections.h"

#include <algorithm>
#include <cmath>

namespace volumeoptics
{
namespace
{
const double FullTurn = 4.0 * optics::QuarterTurn;
const int ChannelsOfTable = 6;
// The exact product's share of one segment ends here: its depth would be infinite at 1.
const double LargestShare = 0.95;
const int ProductIntervals = 128;

// Directions up to their sign on a square: the upper half of the octahedron.
glm::dvec2 SquareOf(const glm::dvec3& direction)
{
  const glm::dvec3 upper = direction.z < 0.0 ? -direction : direction;
  const double sum = std::abs(upper.x) + std::abs(upper.y) + upper.z;
  return glm::dvec2(upper.x + upper.y, upper.x - upper.y) / sum;
}

glm::dvec3 DirectionOf(const glm::dvec2& square)
{
  const double x = (square.x + square.y) / 2.0, y = (square.x - square.y) / 2.0;
  return glm::normalize(glm::dvec3(x, y, 1.0 - std::abs(x) - std::abs(y)));
}

// Tangents along each side of the table, and rows of directions to the viewer: as many as keep
// interpolation and quadrature below the truncation (TestLineVoxelSegments).
int SizeOfTable(int order)
{
  return 21 + 4 * order;
}

int RowsOfTable(int order)
{
  return 16 + order;
}

// Harmonics of the radiance times sine, weighted for the integral.
std::vector<double> WeightBasis(const HarmonicBasis& basis, const std::vector<WeightedDirection>& directions)
{
  std::vector<double> weighted(directions.size() * basis.GetCount());
  for (std::size_t i = 0; i < directions.size(); ++i)
  {
    double* row = &weighted[i * basis.GetCount()];
    basis.Evaluate(directions[i].Direction, row);
    std::transform(
      row, row + basis.GetCount(), row, [&](double value) { return value * directions[i].Weight; });
  }
  return weighted;
}
}

void CylinderProjection::AddRadiance(const glm::dvec3& tangent, const glm::dvec3& toViewer,
  bool withHeadlights, glm::dvec3& body, glm::dvec3& highlight) const
{
  for (const LineLight& light : this->Settings.Lights)
  {
    if (withHeadlights || light.Kind != LineLight::Headlight)
    {
      const glm::dvec3 toLight = DirectionToLight(light, toViewer, this->Settings.ViewUp);
      const LineMaterial& material = this->Settings.Material;
      const CylinderRadiance radiance =
        RadianceOfCylinder(tangent, toViewer, toLight, material.Exponent, this->Table);
      body += material.Diffuse * light.Diffuse * radiance.Diffuse;
      highlight += material.Specular * light.Specular * radiance.Specular;
    }
  }
}

// Each light's mean is largest where light and viewer stand across the tangent.
std::array<double, 6> CylinderProjection::ColorRange(const glm::dvec3& least, const glm::dvec3& largest) const
{
  const LineMaterial& material = this->Settings.Material;
  const double lobe = optics::WallisIntegral(material.Exponent + 1.0) / 2.0;
  glm::dvec3 body = material.Ambient, highlight(0.0);
  for (const LineLight& light : this->Settings.Lights)
  {
    body += material.Diffuse * light.Diffuse * (optics::QuarterTurn / 2.0);
    highlight += material.Specular * light.Specular * lobe;
  }
  const glm::dvec3 low = least * material.Ambient, high = largest * body + highlight;
  return { low.x, low.y, low.z, high.x, high.y, high.z };
}

double CylinderProjection::ProductOverArea(double q)
{
  const double share = std::min(q, LargestShare);
  return share > 1e-9 ? optics::OpticalDepth(share) / share : 1.0;
}

AnalyticProjection::AnalyticProjection(const ProjectionSettings& settings)
  : CylinderProjection(settings)
{
  const LineMaterial& material = settings.Material;
  glm::dvec3 diffuse(0.0), specular(0.0);
  for (const LineLight& light : settings.Lights)
  {
    const bool isHeadlight = light.Kind == LineLight::Headlight;
    diffuse += isHeadlight ? light.Diffuse : glm::dvec3(0.0);
    specular += isHeadlight ? light.Specular : glm::dvec3(0.0);
    this->TableSize = isHeadlight ? this->TableSize : SizeOfTable(settings.Basis->GetMaximumOrder());
  }
  const double peak = optics::WallisIntegral(material.Exponent + 1.0) / 2.0;
  for (int l = 0; l <= settings.Basis->GetMaximumOrder(); ++l)
  {
    const double area = FullTurn * optics::SineMoment(l, 1.0);
    const double lambert = FullTurn * optics::QuarterTurn / 2.0 * optics::SineMoment(l, 2.0);
    const double lobe = FullTurn * peak * optics::SineMoment(l, material.Exponent + 1.0);
    this->Degrees.push_back({ material.Ambient * area + material.Diffuse * diffuse * lambert,
      material.Specular * specular * lobe, area });
  }
  if (settings.QuarterSurface > 0.0)
  {
    this->PrepareProduct();
  }
}

// -ln(1 - q sine)/q as a series of powers of the sine.
void AnalyticProjection::PrepareProduct()
{
  const int order = this->Settings.Basis->GetMaximumOrder();
  const int terms = 400; // .95^400 = 1e-9
  this->Products.assign((ProductIntervals + 2) * (order + 1), 0.0);
  for (int l = 0; l <= order; l += 2)
  {
    for (int n = 1; n <= terms; ++n)
    {
      const double moment = FullTurn * optics::SineMoment(l, n) / n;
      for (int i = 0; i <= ProductIntervals + 1; ++i)
      {
        const double q = LargestShare * std::min(i, ProductIntervals) / ProductIntervals;
        this->Products[i * (order + 1) + l] += moment * std::pow(q, n - 1);
      }
    }
  }
}

bool AnalyticProjection::Prepare(Batches& batches, double progressAtEnd)
{
  if (this->TableSize == 0)
  {
    return true;
  }
  const std::vector<WeightedDirection> directions =
    GaussDirections(RowsOfTable(this->Settings.Basis->GetMaximumOrder()));
  const HarmonicBasis& basis = *this->Settings.Basis;
  const std::vector<double> weighted = WeightBasis(basis, directions);
  const int count = basis.GetCount();
  const int places = this->TableSize * this->TableSize;
  this->Tangents.assign(static_cast<std::size_t>(places) * count * ChannelsOfTable, 0.0F);
  return batches.Run(places, progressAtEnd, [&](long long place) {
    const glm::dvec2 index(place % this->TableSize, place / this->TableSize);
    const glm::dvec3 tangent = DirectionOf(index * (2.0 / (this->TableSize - 1)) - 1.0);
    std::vector<double> sums(count * ChannelsOfTable, 0.0);
    for (std::size_t i = 0; i < directions.size(); ++i)
    {
      glm::dvec3 light[2] = { glm::dvec3(0.0), glm::dvec3(0.0) };
      const double sine = glm::length(glm::cross(tangent, directions[i].Direction));
      this->AddRadiance(tangent, directions[i].Direction, false, light[0], light[1]);
      const double values[ChannelsOfTable] = { light[0].x * sine, light[0].y * sine, light[0].z * sine,
        light[1].x * sine, light[1].y * sine, light[1].z * sine };
      for (int j = 0; j < count; ++j)
      {
        for (int c = 0; c < ChannelsOfTable; ++c)
        {
          sums[j * ChannelsOfTable + c] += weighted[i * count + j] * values[c];
        }
      }
    }
    std::copy(sums.begin(), sums.end(), this->Tangents.begin() + place * sums.size());
  });
}

void AnalyticProjection::Add(const ProjectedSegment& segment, const double* basis, double* sums) const
{
  const HarmonicBasis& all = *this->Settings.Basis;
  const int channels = this->GetChannels();
  double factors[HarmonicBasis::LargestOrder + 1][4];
  for (int l = 0; l <= all.GetMaximumOrder(); l += 2)
  {
    const Zonal& zonal = this->Degrees[l];
    const glm::dvec3 light = segment.Color * zonal.Body + zonal.Highlight;
    factors[l][0] = segment.Weight * light.x;
    factors[l][1] = segment.Weight * light.y;
    factors[l][2] = segment.Weight * light.z;
    factors[l][3] = segment.Weight * zonal.Area;
  }
  for (int j = 0; j < all.GetCount(); ++j)
  {
    const int l = all.GetDegree(j);
    for (int c = 0; c < 4 && l % 2 == 0; ++c)
    {
      sums[j * channels + c] += basis[j] * factors[l][c];
    }
  }
  if (this->TableSize > 0)
  {
    this->AddTable(segment, sums);
  }
  if (channels > ProductChannel)
  {
    this->AddProduct(segment, basis, sums);
  }
}

void AnalyticProjection::AddTable(const ProjectedSegment& segment, double* sums) const
{
  const glm::dvec2 place = (SquareOf(segment.Tangent) + 1.0) * 0.5 * (this->TableSize - 1.0);
  const int column = std::clamp(static_cast<int>(place.x), 0, this->TableSize - 2);
  const int row = std::clamp(static_cast<int>(place.y), 0, this->TableSize - 2);
  const int size = this->Settings.Basis->GetCount() * ChannelsOfTable;
  float light[HarmonicBasis::LargestCount * ChannelsOfTable];
  std::fill_n(light, size, 0.0F);
  for (int corner = 0; corner < 4; ++corner)
  {
    const int right = corner & 1, up = corner >> 1;
    const auto weight = static_cast<float>(
      (right ? place.x - column : 1.0 - (place.x - column)) * (up ? place.y - row : 1.0 - (place.y - row)));
    const float* entry =
      &this->Tangents[(static_cast<std::size_t>(row + up) * this->TableSize + column + right) * size];
    for (int i = 0; i < size; ++i)
    {
      light[i] += weight * entry[i];
    }
  }
  const int channels = this->GetChannels();
  const double factors[3] = { segment.Weight * segment.Color.x, segment.Weight * segment.Color.y,
    segment.Weight * segment.Color.z };
  for (int j = 0; j < this->Settings.Basis->GetCount(); ++j)
  {
    for (int c = 0; c < 3; ++c)
    {
      const float* harmonic = light + j * ChannelsOfTable;
      sums[j * channels + c] += factors[c] * harmonic[c] + segment.Weight * harmonic[c + 3];
    }
  }
}

void AnalyticProjection::AddProduct(const ProjectedSegment& segment, const double* basis, double* sums) const
{
  const HarmonicBasis& all = *this->Settings.Basis;
  const int stride = all.GetMaximumOrder() + 1;
  const double share = std::min(segment.Weight / this->Settings.QuarterSurface, LargestShare);
  const double place = share / LargestShare * ProductIntervals;
  const int i = static_cast<int>(place);
  for (int j = 0; j < all.GetCount(); ++j)
  {
    const double* entry = &this->Products[i * stride + all.GetDegree(j)];
    const double factor = entry[0] + (place - i) * (entry[stride] - entry[0]);
    sums[j * this->GetChannels() + ProductChannel] += segment.Weight * factor * basis[j];
  }
}

SampledProjection::SampledProjection(const ProjectionSettings& settings, int subdivisions)
  : CylinderProjection(settings)
{
  const std::vector<WeightedDirection> directions = OctahedronDirections(subdivisions);
  this->WeightedBasis = WeightBasis(*settings.Basis, directions);
  for (const WeightedDirection& direction : directions)
  {
    this->Directions.push_back(direction.Direction);
  }
}

void SampledProjection::Add(const ProjectedSegment& segment, const double*, double* sums) const
{
  const int count = this->Settings.Basis->GetCount();
  const int channels = this->GetChannels();
  for (std::size_t i = 0; i < this->Directions.size(); ++i)
  {
    glm::dvec3 body = this->Settings.Material.Ambient, highlight(0.0);
    this->AddRadiance(segment.Tangent, this->Directions[i], true, body, highlight);
    const double area = segment.Weight * glm::length(glm::cross(segment.Tangent, this->Directions[i]));
    const glm::dvec3 light = (segment.Color * body + highlight) * area;
    double values[5] = { light.x, light.y, light.z, area, 0.0 };
    if (channels > ProductChannel)
    {
      values[ProductChannel] = area * ProductOverArea(area / this->Settings.QuarterSurface);
    }
    const double* basis = &this->WeightedBasis[i * count];
    for (int j = 0; j < count; ++j)
    {
      for (int c = 0; c < channels; ++c)
      {
        sums[j * channels + c] += basis[j] * values[c];
      }
    }
  }
}
}
