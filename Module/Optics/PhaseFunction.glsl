// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Phase functions. They integrate to 4 pi over the sphere, as VTK's own do: the isotropic one is 1.

// |g| = 1 is a delta distribution; the function stays finite by ending here (peak 2e6).
const float LargestScatteringAnisotropy = 0.999;

// [HenyeyGreenstein1941] eq. 2 times 4 pi; [Ament2015] f_d of eq. 4.
// anisotropy: mean cosine g in [-1, 1], > 0 scatters forward; clamped to LargestScatteringAnisotropy.
// cosTheta: cosine between the directions of travel before and after the event, -dot(L, V).
float HenyeyGreenstein(float anisotropy, float cosTheta)
{
  float g = clamp(anisotropy, -LargestScatteringAnisotropy, LargestScatteringAnisotropy);
  // 1 + g^2 - 2 g c, written without cancellation where g and c are both near 1 or both near -1
  float magnitude = abs(g);
  float cosine = g < 0.0 ? -cosTheta : cosTheta;
  float base = (1.0 - magnitude) * (1.0 - magnitude) + 2.0 * magnitude * max(1.0 - cosine, 0.0);
  return (1.0 - g * g) / (base * sqrt(base));
}
