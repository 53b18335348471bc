// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The volume rendering integral in data space, [Kraus2005]. Attenuation belongs to a change of the
// scalar, not to a length: where the scalar is constant nothing is seen. Needs Opacity.glsl.
//
// A segment is the part of a ray between two samples, the scalar monotone on it from front to back.
// Scalars, steps of the scalar and attenuation per scalar share one unit, whatever it is: the data's own,
// or the range of a table. So do lengths and gradients.

// Optical depth of an opaque material over the unit interval of data. It has none; this one is opaque
// on every step above 1e-5 unit intervals and still sums up in a float.
const float OpaqueDepth = 1.0e6;

// Beyond, 1 - exp(-x) is 1 in every precision; the bound keeps products that overflow out of exp().
const float LargestDepth = 1.0e4;

// 1/|cosine| and the like end here: finite in float with any optical depth.
const float SmallestCosine = 1.0e-30;

// A cosine, of a tenth of a degree: a light fades from one side of a surface to the other where the light or the viewer is so
// near to the surface's plane. Rounding in float is a four-hundredth of it.
const float LightFade = 0.002;

// (1 - exp(-x))/x: opacity over optical depth, 1 at x = 0 and falling. x >= 0.
float OpacityOverDepth(float x)
{
  return x < 0.01 ? 1.0 - x / 2.0 * (1.0 - x / 3.0) : (1.0 - exp(-min(x, LargestDepth))) / x;
}

// Opacity of a segment, eqs 3 and 7. meanAttenuation: over the segment, >= 0, per unit of the scalar
// (segmentLength: |back - front|) or of length (physical space). 0 where the segment has no length.
float SegmentOpacity(float meanAttenuation, float segmentLength)
{
  return OneMinusExp(min(meanAttenuation * segmentLength, LargestDepth));
}

// Change of the scalar along a step of the ray, eq. 9: the projected gradient times the step.
float ScalarStep(vec3 gradient, vec3 step)
{
  return abs(dot(gradient, step));
}

// Opacity of a post-classified sample, eq. 11. opacity in [0, 1] is that of crossing the unit interval of
// data; relativeStep = scalar step / unit interval >= 0. Nothing at a step of 0, also for opacity 1.
float OpacityForScalarStep(float opacity, float relativeStep)
{
  float depth = opacity < 1.0 ? OpticalDepth(opacity) : OpaqueDepth;
  return SegmentOpacity(depth, relativeStep);
}

// Opacity of a segment with silhouettes, eq. 15 by eq. 17: the ray crosses |grad s| d of data instead of
// |back - front|. For a sample's own attenuation in place of the mean, it is eq. 18. scalarStep,
// gradientStep (|grad s| times the step) >= 0; a gradient that is less than its projection counts as it.
float SilhouetteOpacity(float meanAttenuation, float scalarStep, float gradientStep)
{
  return SegmentOpacity(meanAttenuation, max(scalarStep, gradientStep));
}

// The same by eq. 16, min(1, opacity/|cosine|), written without the cosine: finite across it.
float ClampedSilhouetteOpacity(float meanAttenuation, float scalarStep, float gradientStep)
{
  float depth = min(meanAttenuation * scalarStep, LargestDepth);
  float alongGradient = min(meanAttenuation * max(scalarStep, gradientStep), LargestDepth * LargestDepth);
  return min(1.0, alongGradient * OpacityOverDepth(depth));
}

// Opacity of an infinitely thin surface at an angle, eq. 15: 1 - (1 - opacity)^(1/|cosine|). 1 stays 1,
// 0 stays 0, and all else tends to 1 where the ray grazes the surface (cosine 0).
float SurfaceSilhouetteOpacity(float opacity, float cosine)
{
  return OpacityForScalarStep(opacity, 1.0 / max(abs(cosine), SmallestCosine));
}

// Eq. 16, the approximation of it for small opacities. 0 stays 0.
float ClampedSurfaceOpacity(float opacity, float cosine)
{
  return min(1.0, opacity / max(abs(cosine), SmallestCosine));
}

// How much of a light is behind the surface, eq. 19: 0 on the viewer's side (it is reflected), in the surface and
// without a normal, 1 on the other side (it is transmitted). The paper has a step; between the two a light fades
// where L.n or V.n is within LightFade, so that no sample's light hangs on a rounding. The normal's sign does not matter.
float ShareBehind(vec3 normal, vec3 toLight, vec3 toViewer)
{
  float cosLight = dot(normal, toLight);
  float cosViewer = dot(normal, toViewer);
  float below = cosLight * cosViewer < 0.0 ? min(abs(cosLight), abs(cosViewer)) : 0.0;
  return min(below / LightFade, 1.0);
}

// Transmitted light, eq. 19, before opacity and colour: x diffuse |L.n|, y specular max(0, -L.V)^exponent
// (no cosine in it), of the light that is behind the surface. normal unit or 0; exponent in [0.01, 1e5].
vec2 TransmittedLight(vec3 normal, vec3 toLight, vec3 toViewer, float exponent)
{
  float cosThrough = -dot(toLight, toViewer);
  float specular = cosThrough > 0.0 ? pow(min(cosThrough, 1.0), exponent) : 0.0;
  return vec2(abs(dot(normal, toLight)), specular);
}

// What a segment transmits, relative to its opacity, so that all segments of a peak composite to
// A (1 - A), A the opacity of the whole peak: eq. 19 for a crossing, at any step. Integrates the light
// that what is left of the peak lets through, and rescales -(1 - A) ln(1 - A) to A (1 - A).
// Optical depths in [0, 1e30]: of the segment; from its back to the end of the peak, 0 outside of one; of the
// whole peak, the larger one of those that the segment's two ends are in.
float TransmittedShare(float segmentDepth, float depthBehind, float peakDepth)
{
  float left = segmentDepth + depthBehind;
  float whole = max(peakDepth, left);
  return exp(-min(left, LargestDepth)) * (OpacityOverDepth(whole) / OpacityOverDepth(segmentDepth));
}

// Whether a segment crosses an isovalue: the front is below it and the back is not, or the other way.
// So a value met exactly at a sample counts in one of its two segments, and NaN crosses nothing.
bool CrossesIsovalue(float front, float back, float isovalue)
{
  return (front < isovalue && back >= isovalue) || (front >= isovalue && back < isovalue);
}

// Where on the segment, in [0, 1] from the front. Of a segment that crosses the isovalue.
float CrossingFraction(float front, float back, float isovalue)
{
  float change = back - front;
  return change == 0.0 ? 0.0 : clamp((isovalue - front) / change, 0.0, 1.0);
}

// Texture coordinate of a scalar, 0 at the first and 1 at the last of a table's entries: their middles.
float TableCoordinate(float normalizedScalar, float entries)
{
  return (clamp(normalizedScalar, 0.0, 1.0) * (entries - 1.0) + 0.5) / entries;
}
