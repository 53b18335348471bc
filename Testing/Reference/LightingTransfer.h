// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Light by a lighting transfer function [Lum2004] and classification by several samples in double: nothing
// is tabulated.

#ifndef LightingTransfer_h
#define LightingTransfer_h

#include "Shading.h"

namespace reference
{
// Coefficients of one sample, times the light scale, and the side of its normal.
struct LightingCoefficients
{
  double ambient = 0.0;
  double diffuse = 0.0;
  double specular = 0.0;
  double side = 1.0; // HybridSide; 1 without hybrid normals
};

// Of the scalar: along it S1 and S2 are taken, and from it the sides of a surface.
Vector PairGradientAt(const Scene& scene, const Sample& sample);

LightingCoefficients LightingCoefficientsAt(const Scene& scene, const Sample& sample, const Vector& gradient);

// The mapper's Phong model with those coefficients, or without a function the scene's own.
Vector PhongRadiance(const Scene& scene, const Sample& sample, const Vector& color);

// The coefficient of light that shines through: the diffuse one.
double TransmissionAt(const Scene& scene, const Sample& sample);

// Colour of a sample, and opacity of one step, after the rules if there are some.
struct Classified
{
  Vector color = Vector(0.0);
  double opacity = 0.0;
};
Classified ClassifiedAt(const Scene& scene, const Sample& sample);
}

#endif
