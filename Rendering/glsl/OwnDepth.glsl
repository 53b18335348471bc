// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec, before Occlusion and ShadowLookup. What the ray has met since the slice in front of a
// sample. A slice's own opacity would show its distance as rings on every dense surface; the ray knows where in the
// slice the surface begins.

struct OpticsOwnDepth
{
  vec3 parts;  // of a sum
  float clear; // transmittance of the ray up to there
};

const OpticsOwnDepth opticsNothingMet = OpticsOwnDepth(vec3(0.0), 1.0);

// After the samples in front of this one, so many slices behind the last call. Of what lies s slices back
// exp(-x) (1 + x + x^2/2) counts, x = 3 s, which is nearly 1 to half a slice and 1 over all s. Each step back takes an
// older part to the next power.
OpticsOwnDepth opticsMeet(OpticsOwnDepth own, float slices)
{
  float clear = max(1.0 - g_fragColor.a, 1.0e-6);
  vec3 parts = own.parts;
  parts.x += log(max(own.clear / clear, 1.0));
  float x = 3.0 * slices;
  parts = exp(-x) * vec3(parts.x, parts.y + x * parts.x, parts.z + x * (parts.y + 0.5 * x * parts.x));
  return OpticsOwnDepth(parts, clear);
}

// What of the light that reaches the slice arrives at the sample, by a way so many times as long as the ray's.
float opticsOwnVisibility(OpticsOwnDepth own, float opacity, float wayOut)
{
  float depth = own.parts.x + own.parts.y + own.parts.z;
  return exp(-depth * wayOut) * StretchVisibility(opticsOwnOpacity(opacity), wayOut);
}
