// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Final gathering of occlusion: what the rays of a sample look at before the sweep goes on for them.

#ifndef OcclusionGathering_h
#define OcclusionGathering_h

#include "OpticsScene.h"
#include "OpticsShaderTable.h"
#include "vtkVisibilitySweep.h"

class SweepGrid;
class vtkShaderProgram;

/** What the text of gathering needs. */
void AddGatheringFeatures(const OpticsScene& scene, OpticsFeatures& features);

/** How far from its sample a ray looks at the sweep. */
void SetGatheringReach(const SweepGrid& grid, vtkVisibilitySweep::Volume& volume);

/** All uniforms of OcclusionGathered.glsl but the texture and the table of opacities. */
void SetGatheringUniforms(const OpticsScene& scene, const vtkVisibilitySweep::Volume& volume,
  const SweepGrid& grid, bool isSwept, vtkShaderProgram* program);

#endif
