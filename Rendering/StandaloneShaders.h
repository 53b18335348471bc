// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Shaders that are none of VTK's, put together from the same formulas.

#ifndef StandaloneShaders_h
#define StandaloneShaders_h

#include <string>

/**
 * The shaders that evaluate anisotropic voxels of an order and a number of line types.
 */
std::string LineEvaluationVertexShader(int order, int types);
std::string LineEvaluationFragmentShader();

/**
 * The shaders of vtkDataSpaceProjectedTetrahedraMapper. silhouette: vtkOpticsVolumeProperty's.
 */
std::string ProjectedTetrahedraVertexShader();
std::string ProjectedTetrahedraFragmentShader(int silhouette, bool hasIsosurfaces);

/**
 * The same with another text that defines FragmentColor(), as ProjectedTetrahedraInterior.glsl does.
 */
std::string ProjectedTetrahedraFragmentShader(const std::string& color);

#endif
