// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// What a scene hands to a visibility sweep.

#ifndef SweepViews_h
#define SweepViews_h

#include "OpticsScene.h"
#include "OpticsShaderTable.h"
#include "SweepGrid.h"
#include "vtkVisibilitySweep.h"

#include <string>

/** What a text needs that serves a sweep as well. */
void AddSweepFeatures(const OpticsScene& scene, OpticsFeatures& features);

/** Why a volume that VTK is about to draw can't be swept, in a sentence with a remedy; empty where it can. */
std::string FindUnsweepable(const OpticsScene& scene);

/** Whether what is drawn is a selection, which no light is seen in. */
bool IsSelection(const OpticsScene& scene);

/** What the renderer's camera sees. */
SweepGrid::View CameraView(const OpticsScene& scene);

/** The corners of the volume in world coordinates. */
void VolumeCorners(const OpticsScene& scene, double corners[24]);

/** The mapper's knobs. */
SweepGrid::Resolution SweepResolution(const OpticsScene& scene);
void SetSweepKnobs(const OpticsScene& scene, vtkVisibilitySweep* sweep);

/** The volume that VTK is about to draw. */
vtkVisibilitySweep::Volume SweptVolume(const OpticsScene& scene, vtkShaderProgram* ray);

/** World to the texture coordinates of the grid, for VTK's texture coordinates. */
void SetGridUniform(const SweepGrid& grid, const vtkVisibilitySweep::Volume& volume, const char* name,
  vtkShaderProgram* program, bool isInMiddle = false);

#endif
