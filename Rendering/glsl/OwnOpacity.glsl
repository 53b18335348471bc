// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec, before Occlusion. What hides points of the sample from light that comes to them.

float opticsOwnOpacity(float opacity)
{
  return opacity;
}
