// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec, before Occlusion. What hides points of the sample from light that comes to them: of an
// isosurface nothing, it has no inside.

float opticsOwnOpacity(float opacity)
{
  return g_opticsIsSurface ? 0.0 : opacity;
}
