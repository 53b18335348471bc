// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec, before ExtinctionGradientCentral: what it needs of the stored normals.

float opticsChangeAt(vec3 texPosition)
{
  return opticsStoredNormal(texPosition).change;
}

vec3 opticsFrameNormal(vec3 texPosition)
{
  return opticsStoredNormal(texPosition).normal;
}
