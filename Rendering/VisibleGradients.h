// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// What of the gradients a scene shows, in VTK's measure: 1 is a quarter of the scalars' range in the mean of a voxel's
// edges, and more is taken for that.

#ifndef VisibleGradients_h
#define VisibleGradients_h

#include "OpticsScene.h"

#include <vector>

/**
 * Whether what is hidden follows from the largest gradient magnitude among the voxels around: VTK's gradient is of one
 * component, linearly interpolated, not replaced by a value for what is clipped, and no other array takes its place.
 */
bool IsSeenByGradients(const OpticsScene& scene);

/** Gradient magnitude of a difference of 1 between the two neighbours of a voxel on each axis; 0 where it has none. */
void FindGradientScale(const OpticsScene& scene, double scale[3]);

/** How much more the shader may find: it computes in single precision, with the scalars' offset. */
double FindGradientSlack(const OpticsScene& scene);

/** VTK's table of the gradient opacity, over magnitudes from 0 to 1. */
std::vector<float> MakeGradientTable(const OpticsScene& scene);

/** The least magnitude with which such a table is not 0, rounded downwards; infinite where there is none. */
double FindLeastGradient(const OpticsScene& scene, const std::vector<float>& table);

#endif
