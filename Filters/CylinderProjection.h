// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The spherical harmonics of a lit segment's visible area and of its radiance times this area, as
// functions of the view direction.

#ifndef CylinderProjection_h
#define CylinderProjection_h

#include "HarmonicBasis.h"
#include "LineVoxels.h"
#include "TangentTable.h"

#include <array>
#include <memory>
#include <vector>

namespace volumeoptics
{
class Batches;

// What the parts of a segment share.
struct SegmentRow
{
  glm::dvec3 Tangent = glm::dvec3(0.0); // unit
  glm::dvec3 Color = glm::dvec3(0.0);
  float Basis[HarmonicBasis::LargestCount];                   // of the tangent
  float Radiance[LineChannels * HarmonicBasis::LargestCount]; // [harmonic][channel], of weight 1
};

struct ProjectionSettings
{
  const HarmonicBasis* Basis = nullptr;
  LineMaterial Material;
  std::vector<LineLight> Lights;
  glm::dvec3 ViewUp = glm::dvec3(0.0, 0.0, 1.0);
};

class CylinderProjection
{
public:
  explicit CylinderProjection(const ProjectionSettings& settings)
    : Settings(settings)
    , Table(settings.Material.Exponent)
  {
  }
  virtual ~CylinderProjection() = default;

  // Prepares tables; false on abort.
  virtual bool Prepare(Batches&, double) { return true; }
  // Makes the row that of the segment, unless it is.
  void SetSegment(const glm::dvec3& tangent, const glm::dvec3& color, SegmentRow& row) const;
  // Adds a part of the weight 2 radius length, its area from the side, to sums[harmonic][channel].
  virtual void Add(const SegmentRow& row, double weight, double* sums) const = 0;
  // Radiance of a segment of color 1 for coefficient-free light, with all lights but headlights or with
  // all: body takes the segment's colour.
  void AddRadiance(const glm::dvec3& tangent, const glm::dvec3& toViewer, bool withHeadlights,
    glm::dvec3& body, glm::dvec3& highlight) const;
  // Least and largest mean radiance of segments whose colours are within the box.
  std::array<double, 6> ColorRange(const glm::dvec3& least, const glm::dvec3& largest) const;

protected:
  virtual void FillRow(SegmentRow&) const {}

  ProjectionSettings Settings;
  CosinePowerTable Table;
};

// Headlights and ambient light depend on the angle to the tangent alone: their coefficients are powers
// of the sine, in closed form, times Y_lm(T). Other lights: a table over the tangent's directions.
class AnalyticProjection : public CylinderProjection
{
public:
  explicit AnalyticProjection(const ProjectionSettings& settings);
  bool Prepare(Batches& batches, double progressAtEnd) override;
  void Add(const SegmentRow& row, double weight, double* sums) const override;

protected:
  void FillRow(SegmentRow& row) const override;

private:
  struct Zonal
  {
    glm::dvec3 Body, Highlight;
    double Area;
  };
  std::vector<Zonal> Degrees;
  std::unique_ptr<TangentTable> Tangents; // none: headlights alone
};

// [Schussman2004] section 5: samples of the whole function in the octahedron's directions.
class SampledProjection : public CylinderProjection
{
public:
  SampledProjection(const ProjectionSettings& settings, int subdivisions);
  void Add(const SegmentRow& row, double weight, double* sums) const override;

private:
  std::vector<glm::dvec3> Directions;
  std::vector<double> WeightedBasis; // [direction][harmonic]
};
}

#endif
