// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Radiance of one sample of the volume, in double, over the formulas of Module/Optics.

#ifndef Shading_h
#define Shading_h

#include "Scene.h"

namespace reference
{
struct Sample
{
  Vector position;
  Vector entry;    // of the ray into the volume
  Vector toViewer; // unit
  double scalar = 0.0;
  bool isSurface = false; // of an isosurface: it has the scalar's normal, and a specular coefficient of 1
};

// Radiance of the ambient light that reaches a sample.
Vector AmbientLight(const Scene& scene, const Sample& sample);

// Of a light, that nothing takes away on the way to a point.
double ShareOfLight(const Scene& scene, const Light& light, const Vector& point);

// Direction to a light, and its attenuation and shadow at a point.
struct Illumination
{
  Vector toLight;
  double factor = 1.0;
};
Illumination IlluminationAt(const Scene& scene, const Light& light, const Vector& point);

// How much of a light falls on the side that the viewer does not see, and shines through: it is not reflected then.
double ShareBehind(const Scene& scene, const Sample& sample, const Vector& toLight);

// The gradient of the classified extinction: direction -grad(sigma)/|grad(sigma)| (unit, or 0) and the
// scale-free specular coefficient K. tangentNormal and anisotropy are the unclassified scalar's.
struct ExtinctionGradient
{
  Vector normal = Vector(0.0);
  double coefficient = 0.0;
  Frame frame;
};
ExtinctionGradient ExtinctionGradientAt(const Scene& scene, const Sample& sample);

// Not multiplied by the sample's opacity.
Vector Radiance(const Scene& scene, const Sample& sample);

// Of a sample with this colour, that lets through this share of the light from behind, [Kraus2005] eq. 19.
// With transmitted light on, a light behind the surface is transmitted and not reflected.
Vector Radiance(const Scene& scene, const Sample& sample, const Vector& color, double transmittedShare);
}

#endif
