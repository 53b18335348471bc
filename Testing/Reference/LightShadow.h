// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Shadows of lights by rays: the truth for vtkOpticsVolumeProperty's Shadows.

#ifndef LightShadow_h
#define LightShadow_h

#include "ConeIntegral.h"

namespace reference
{
// For Scene::shadow. angle: half of that under which lights appear, in degrees: a directional light's is the
// same everywhere; a positional one is a disk that faces the middle of the volume and appears so from there.
class LightShadow
{
public:
  // step: of the rays, in dataset space; 0: that of the scene. rays: to one light, where it has an angle.
  LightShadow(const Scene& scene, double angle, double step = 0.0, int rays = 256);

  // With the light's shadow attenuation.
  double operator()(const Light& light, const Vector& point) const;

private:
  double ShareOfDirectional(const Light& light, const Vector& point) const;
  double ShareOfPositional(const Light& light, const Vector& point) const;

  Occluders Volume;
  ConeRays Rays;
};
}

#endif
