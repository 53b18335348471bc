// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Normals that take their side from the classified density [Lum2004, section 3.3].

// What a normal -grad(s)/|grad(s)| is multiplied by, so that it points to the less opaque material:
// 1 where the density grows with the scalar or is the same, -1 where it falls. densityDifference:
// rho(S1) - rho(S2), with S1 ahead on the gradient; fade > 0: over differences from 0 to -fade the
// factor goes linearly from 1 to -1, so that light has no jump.
float HybridSide(float densityDifference, float fade)
{
  return clamp(1.0 + 2.0 * densityDifference / fade, -1.0, 1.0);
}
