// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CylinderProjection.h"

#include "Batches.h"
#include "LineKernel.h"
#include "Optics.h"
#include "SphereDirections.h"

#include <algorithm>
#include <cmath>

namespace volumeoptics
{
namespace
{
const double FullTurn = 4.0 * optics::QuarterTurn;
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

void CylinderProjection::SetSegment(const glm::dvec3& tangent, const glm::dvec3& color, SegmentRow& row) const
{
  if (tangent != row.Tangent)
  {
    double values[HarmonicBasis::LargestCount];
    this->Settings.Basis->Evaluate(tangent, values);
    std::copy(values, values + this->Settings.Basis->GetCount(), row.Basis);
  }
  if (tangent != row.Tangent || color != row.Color)
  {
    row.Tangent = tangent;
    row.Color = color;
    this->FillRow(row);
  }
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
    if (!isHeadlight && !this->Tangents)
    {
      this->Tangents = std::make_unique<TangentTable>(*settings.Basis);
    }
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
}

bool AnalyticProjection::Prepare(Batches& batches, double progressAtEnd)
{
  return !this->Tangents ||
    this->Tangents->Prepare(
      [this](const glm::dvec3& tangent, const glm::dvec3& toViewer, glm::dvec3& body, glm::dvec3& highlight) {
        this->AddRadiance(tangent, toViewer, false, body, highlight);
      },
      batches, progressAtEnd);
}

void AnalyticProjection::FillRow(SegmentRow& row) const
{
  const HarmonicBasis& basis = *this->Settings.Basis;
  float factors[HarmonicBasis::LargestOrder + 1][4] = {};
  for (int l = 0; l <= basis.GetMaximumOrder(); l += 2)
  {
    const Zonal& zonal = this->Degrees[l];
    const glm::vec4 light(row.Color * zonal.Body + zonal.Highlight, zonal.Area);
    std::copy(&light.x, &light.x + 4, factors[l]);
  }
  for (int j = 0; j < basis.GetCount(); ++j)
  {
    for (int c = 0; c < 4; ++c)
    {
      row.Radiance[4 * j + c] = row.Basis[j] * factors[basis.GetDegree(j)][c];
    }
  }
  if (this->Tangents)
  {
    this->Tangents->Add(row.Tangent, row.Color, row.Radiance);
  }
}

void AnalyticProjection::Add(const SegmentRow& row, double weight, double* sums) const
{
  AddScaled(row.Radiance, weight, LineChannels * this->Settings.Basis->GetCount(), sums);
}

SampledProjection::SampledProjection(const ProjectionSettings& settings, int subdivisions)
  : CylinderProjection(settings)
{
  const std::vector<WeightedDirection> directions = OctahedronDirections(subdivisions);
  this->WeightedBasis = settings.Basis->Weighted(directions);
  for (const WeightedDirection& direction : directions)
  {
    this->Directions.push_back(direction.Direction);
  }
}

void SampledProjection::Add(const SegmentRow& row, double weight, double* sums) const
{
  const int count = this->Settings.Basis->GetCount();
  for (std::size_t i = 0; i < this->Directions.size(); ++i)
  {
    glm::dvec3 body = this->Settings.Material.Ambient, highlight(0.0);
    this->AddRadiance(row.Tangent, this->Directions[i], true, body, highlight);
    const double area = weight * glm::length(glm::cross(row.Tangent, this->Directions[i]));
    const glm::dvec3 light = (row.Color * body + highlight) * area;
    const double values[LineChannels] = { light.x, light.y, light.z, area };
    const double* basis = &this->WeightedBasis[i * count];
    for (int j = 0; j < LineChannels * count; ++j)
    {
      sums[j] += basis[j / LineChannels] * values[j % LineChannels];
    }
  }
}
}
