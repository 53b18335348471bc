// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Visibility of a cone of directions by rays, [Schott2009] eqs 3, 4, 6 and 10: the truth for all that goes
// slice by slice, with which it shares no code.

#ifndef ConeIntegral_h
#define ConeIntegral_h

#include "Scene.h"

#include <cstdint>
#include <vector>

namespace reference
{
// A scene as what takes light away. Its silhouettes are the eye's alone, and not part of it.
class Occluders
{
public:
  // step: of the rays, in dataset space; 0: that of the scene. The scene's field must live as long.
  explicit Occluders(const Scene& scene, double step = 0.0);

  const Scene& GetScene() const { return this->Unlit; }
  // Optical depth per length of dataset space, of what is classified point by point; isosurfaces are not in it.
  // 0 outside of the volume.
  double ExtinctionAt(const Vector& point) const;
  // Along a unit direction, to where the volume ends or to a distance. Midpoint rule.
  double Transmittance(const Vector& point, const Vector& direction, double distance = 1.0e300) const;

private:
  double DepthByPoints(const Vector& origin, const Vector& direction, const Interval& inside) const;

  Scene Unlit;
};

struct ConeRays
{
  double angle = 60.0; // half angle in degrees; 180: the whole sphere, the isotropic phase function
  int count = 256;
  unsigned seed = 1;
};

// Directions of one point: one at random in each of count shares of the cosines, at azimuths that
// spread evenly from a random one on. The same for the same seed and point number.
std::vector<Vector> ConeDirections(const Vector& axis, const ConeRays& rays, std::uint64_t pointNumber);

// Mean transmittance over the cone about a unit axis. The rays depend on the point alone, so that any number
// of threads gives the same.
double ConeVisibility(
  const Occluders& occluders, const Vector& point, const Vector& axis, const ConeRays& rays);

// A sample of the picture, with its share of the pixel's opacity.
struct ShownPoint
{
  Vector position;
  Vector toViewer;
  double weight;
  int pixel;
};

// Of a post-classified scene in physical space; of each pixel those above the least weight.
std::vector<ShownPoint> ShownPoints(const Scene& scene, double leastWeight = 1.0e-3);

// At each of them, threaded: the cone about the direction to the eye, or about one axis for all.
std::vector<double> VisibilityAt(const Occluders& occluders, const std::vector<ShownPoint>& points,
  const ConeRays& rays, const Vector* axis = nullptr);

// The mean of values over each pixel's points, by their weights; -1 where there are none.
std::vector<double> MeanOfPixels(
  const std::vector<ShownPoint>& points, const std::vector<double>& values, int pixels);

// Of values against others, each point weighted by its contribution to the picture.
struct VisibilityError
{
  double mean = 0.0; // of the absolute error
  double rootMeanSquare = 0.0;
  double maximum = 0.0;
  double bias = 0.0; // mean of the error with its sign
};
VisibilityError CompareVisibility(
  const std::vector<ShownPoint>& points, const std::vector<double>& values, const std::vector<double>& truth);
}

#endif
