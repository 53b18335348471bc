// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "AttenuatedStretch.h"

#include "Optics.h"

#include <algorithm>
#include <cmath>

namespace volumeoptics
{
namespace
{
// Gauss-Legendre on [0, 1].
const double Abscissae[5] = { 0.046910077030668004, 0.23076534494715845, 0.5, 0.76923465505284155,
  0.953089922969332 };
const double Weights[5] = { 0.11846344252809454, 0.23931433524968324, 0.28444444444444444,
  0.23931433524968324, 0.11846344252809454 };

double DepthOf(double opacity)
{
  return opacity < 1.0 ? -std::log1p(-opacity) : optics::OpaqueDepth;
}

// Integral of t ln(t) - t, 0 at t = 0.
double LogarithmIntegral(double t)
{
  return t > 0.0 ? t * std::log(t) - t : 0.0;
}

// Mean of -ln(1 - opacity) and the place of its centre on [0, 1], opacity linear. Where the transparency
// halves at least, its logarithm is too steep for the quadrature (infinite at opacity 1), and the closed
// form has lost no digits.
struct DepthAndCentre
{
  double depth = 0.0;
  double centre = 0.5;
};
DepthAndCentre MeanDepth(double first, double last)
{
  DepthAndCentre mean;
  double moment = 0.0;
  for (int i = 0; i < 5; ++i)
  {
    const double depth = DepthOf(first + Abscissae[i] * (last - first));
    mean.depth += Weights[i] * depth;
    moment += Weights[i] * Abscissae[i] * depth;
  }
  mean.centre = mean.depth > 0.0 ? moment / mean.depth : 0.5;
  const double least = std::min(1.0 - first, 1.0 - last);
  const double largest = std::max(1.0 - first, 1.0 - last);
  if (least < 0.5 * largest)
  {
    mean.depth = (LogarithmIntegral(least) - LogarithmIntegral(largest)) / (largest - least);
  }
  return mean;
}

// Integral over x in [0, 1] of (x - 1/2) depth exp(-depth x): what a colour that grows by 1 along the way
// differs by from its mean. Below zero.
double FrontWeight(double depth, double opacity, double transparency)
{
  return depth < 1.0e-3 ? -depth * depth / 12.0 * (1.0 - depth / 2.0)
                        : opacity / depth - transparency - opacity / 2.0;
}
}

//------------------------------------------------------------------------------
Stretch Join(const Stretch& lower, const Stretch& upper)
{
  Stretch both;
  both.width = lower.width + upper.width;
  both.depth = lower.depth + upper.depth;
  both.emission = lower.emission + upper.emission;
  both.color = lower.color + upper.color;
  both.first = lower.first;
  both.last = upper.last;
  both.least = glm::min(lower.least, upper.least);
  both.largest = glm::max(lower.largest, upper.largest);
  return both;
}

//------------------------------------------------------------------------------
Stretch LinearStretch(double width, double attenuation, const std::array<double, 2>& opacity,
  const glm::dvec3& first, const glm::dvec3& last)
{
  const DepthAndCentre mean = MeanDepth(opacity[0], opacity[1]);
  Stretch stretch;
  stretch.width = width;
  stretch.depth = mean.depth * attenuation * width;
  stretch.emission = stretch.depth * (first + mean.centre * (last - first));
  stretch.color = width * (first + 0.5 * (last - first));
  stretch.first = first;
  stretch.last = last;
  stretch.least = glm::min(first, last);
  stretch.largest = glm::max(first, last);
  return stretch;
}

//------------------------------------------------------------------------------
Slab Attenuate(const Stretch& stretch, double scale)
{
  Slab slab;
  slab.width = stretch.width;
  slab.depth = stretch.depth * scale;
  slab.opacity = -std::expm1(-slab.depth);
  slab.transparency = 1.0 - slab.opacity;
  slab.color = stretch.color;
  if (!(stretch.depth > LeastDepth))
  {
    return slab;
  }
  const glm::dvec3 mean = glm::clamp(stretch.emission / stretch.depth, stretch.least, stretch.largest);
  // the colour at neither end may leave the bounds
  const glm::dvec3 room = 2.0 * glm::min(mean - stretch.least, stretch.largest - mean);
  const glm::dvec3 change = glm::clamp(stretch.last - stretch.first, -room, room);
  const glm::dvec3 shift = change * FrontWeight(slab.depth, slab.opacity, slab.transparency);
  slab.upward = mean * slab.opacity + shift;
  slab.downward = mean * slab.opacity - shift;
  return slab;
}

//------------------------------------------------------------------------------
Slab Composite(const Slab& lower, const Slab& upper)
{
  Slab both;
  both.width = lower.width + upper.width;
  both.depth = lower.depth + upper.depth;
  both.transparency = lower.transparency * upper.transparency;
  both.opacity = lower.opacity + lower.transparency * upper.opacity;
  both.upward = lower.upward + lower.transparency * upper.upward;
  both.downward = upper.downward + upper.transparency * lower.downward;
  both.color = lower.color + upper.color;
  return both;
}

//------------------------------------------------------------------------------
glm::dvec3 UpwardColor(const Slab& slab)
{
  return slab.opacity > LeastDepth ? slab.upward / slab.opacity : slab.color / slab.width;
}

//------------------------------------------------------------------------------
glm::dvec3 DownwardColor(const Slab& slab)
{
  return slab.opacity > LeastDepth ? slab.downward / slab.opacity : slab.color / slab.width;
}
}
