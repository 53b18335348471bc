// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec, after OpacityTable. A function of the scalar alone.

float opticsOpacityAt(float scalar, vec3 texPosition, float change, float label)
{
  return opticsTableOpacity(scalar);
}
