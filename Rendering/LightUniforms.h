// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The renderer's lights as uniforms, in eye space.

#ifndef LightUniforms_h
#define LightUniforms_h

class vtkRenderer;
class vtkShaderProgram;

/** Lights that are switched on. */
int CountLights(vtkRenderer* renderer);

bool HasPositionalLight(vtkRenderer* renderer);

void SetLightUniforms(vtkRenderer* renderer, vtkShaderProgram* program);

#endif
