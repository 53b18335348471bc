// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec, before ExtinctionGradientCentral: nothing asks for stored normals.

float opticsChangeAt(vec3 texPosition)
{
  return 0.0;
}

vec3 opticsFrameNormal(vec3 texPosition)
{
  return vec3(0.0);
}
