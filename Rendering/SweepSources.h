// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// What the result of a sweep depends on beside its grid, its knobs and the ray's uniforms: while none of it changes,
// nothing is swept again.

#ifndef SweepSources_h
#define SweepSources_h

#include "OpticsScene.h"

#include "vtkType.h"

#include <utility>
#include <vector>

class vtkShaderProgram;

/** What the textures that a sweep looks up are made of: objects and their times, numbers and the ray's text. */
std::vector<std::pair<const void*, vtkMTimeType>> SweepSources(
  const OpticsScene& scene, vtkShaderProgram* ray);

#endif
