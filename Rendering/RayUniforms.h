// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Spaces and lengths along the ray as uniforms.

#ifndef RayUniforms_h
#define RayUniforms_h

#include "OpticsScene.h"

class vtkShaderProgram;

/** Of the image, on any axis. */
double SmallestSpacing(const OpticsScene& scene);

double UnitDistance(const OpticsScene& scene);

/** Gives a width to a range that has none. */
void WidenEmptyRange(double range[2]);

/** The loaded scalars' range of a component; a constant one is given a width. */
void ScalarRange(const OpticsScene& scene, int component, double range[2]);

/** The scalars that VTK's coordinates 0 and 1 stand for: not its range, where it takes the codes of 8 and
 * 16 bits for one more than there are. */
void CoordinateRange(const OpticsScene& scene, double range[2]);

/** Data to eye space, for directions and for normals. */
void SetSpaceUniforms(const OpticsScene& scene, vtkShaderProgram* program);

/** Unit intervals of data in the range of the scalars; after VTK has loaded the volume. */
double UnitsPerRange(const OpticsScene& scene);

/** Which component opacity depends on. */
void SetScalarUniforms(const OpticsScene& scene, vtkShaderProgram* program);

/** A matrix from differences over two voxels on each index axis, to the gradient times a length. */
void SetDifferences(const OpticsScene& scene, double length, const char* name, vtkShaderProgram* program);

#endif
