// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Shaders that are none of VTK's, put together from the same formulas.

#ifndef StandaloneShaders_h
#define StandaloneShaders_h

#include <string>

/**
 * The shaders that evaluate anisotropic voxels of an order and a number of line types, and put them where rays look
 * them up. inBytes: of 8 bits a number.
 */
std::string LineEvaluationVertexShader();
std::string LineEvaluationFragmentShader(int order, int types, bool inBytes);
std::string LinePlacementFragmentShader();

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
