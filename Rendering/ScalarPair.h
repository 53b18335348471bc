// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The scalars ahead of a sample and behind it on the gradient, S1 and S2 of [Lum2004], for the terms that
// ask for them.

#ifndef ScalarPair_h
#define ScalarPair_h

#include "OpticsScene.h"
#include "OpticsShaderTable.h"

class vtkShaderProgram;

void AddScalarPairFeatures(const OpticsScene& scene, OpticsFeatures& features);
void SetScalarPairUniforms(const OpticsScene& scene, vtkShaderProgram* program);

#endif
