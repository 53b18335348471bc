// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The spherical harmonics of a lit segment's visible area and of its radiance times this area, as
// functions of the view direction.

#ifndef CylinderProjection_h
#define CylinderProjection_h

#include "HarmonicBasis.h"
#include "LineLighting.h"

#include <array>
#include <vector>

namespace volumeoptics
{
class Batches;

// Red, green, blue times area; area; with the exact product -ln(1 - q), in units of the area, too.
constexpr int AreaChannel = 3;
constexpr int ProductChannel = 4;

struct ProjectedSegment
{
  glm::dvec3 Tangent; // unit
  glm::dvec3 Color;
  double Weight; // 2 radius length: the area from the side
};

struct ProjectionSettings
{
  const HarmonicBasis* Basis = nullptr;
  LineMaterial Material;
  std::vector<LineLight> Lights;
  glm::dvec3 ViewUp = glm::dvec3(0.0, 0.0, 1.0);
  double QuarterSurface = 0.0; // above 0: with the product's channel; a quarter of the voxel's surface
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
  // Adds to sums[harmonic][channel]. basis: of the tangent.
  virtual void Add(const ProjectedSegment& segment, const double* basis, double* sums) const = 0;
  int GetChannels() const { return this->Settings.QuarterSurface > 0.0 ? 5 : 4; }
  // Radiance of a segment of color 1 for coefficient-free light, with all lights but headlights or with
  // all: body takes the segment's colour.
  void AddRadiance(const glm::dvec3& tangent, const glm::dvec3& toViewer, bool withHeadlights,
    glm::dvec3& body, glm::dvec3& highlight) const;
  // Least and largest mean radiance of segments whose colours are within the box.
  std::array<double, 6> ColorRange(const glm::dvec3& least, const glm::dvec3& largest) const;
  // -ln(1 - q)/q at q = weight sine over a quarter of the surface.
  static double ProductOverArea(double q);

protected:
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
  void Add(const ProjectedSegment& segment, const double* basis, double* sums) const override;

private:
  struct Zonal
  {
    glm::dvec3 Body, Highlight;
    double Area;
  };
  void PrepareProduct();
  void AddTable(const ProjectedSegment& segment, double* sums) const;
  void AddProduct(const ProjectedSegment& segment, const double* basis, double* sums) const;

  std::vector<Zonal> Degrees;
  int TableSize = 0;            // 0: headlights alone
  std::vector<float> Tangents;  // [place][harmonic][body rgb, highlight rgb]
  std::vector<double> Products; // [q][degree]
};

// [Schussman2004] section 5: samples of the whole function in the octahedron's directions.
class SampledProjection : public CylinderProjection
{
public:
  SampledProjection(const ProjectionSettings& settings, int subdivisions);
  void Add(const ProjectedSegment& segment, const double* basis, double* sums) const override;

private:
  std::vector<glm::dvec3> Directions;
  std::vector<double> WeightedBasis; // [direction][harmonic]
};
}

#endif
