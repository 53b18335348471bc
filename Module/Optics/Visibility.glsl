// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Visibility of a cone of directions, slice by slice from its open end, [Schott2009]. Needs Opacity.glsl
// and DataSpace.glsl.
//
// A slope is a direction across the slices per distance along their normal: a ray that goes d along it
// moves by d times the slope, and d/cosine in all.

// The azimuths that spread any number of directions most evenly, pi (3 - sqrt(5)).
const float GoldenAngle = 2.399963229728653;

struct ConeRay
{
  vec2 slope;
  float cosine; // of the angle with the axis
};

// One of count directions about the axis that have equal shares of the cone's solid angle: each lies in the
// middle of its share of the cosines. index in [0, count); coneCosine of the half angle, in (0, 1].
ConeRay ConeDirection(int index, int count, float coneCosine)
{
  // 1 - cosine: the cosine itself has lost the digits of a narrow cone
  float versine = (float(index) + 0.5) / float(count) * (1.0 - coneCosine);
  float azimuth = GoldenAngle * float(index);
  ConeRay ray;
  ray.cosine = 1.0 - versine;
  ray.slope = vec2(cos(azimuth), sin(azimuth)) * (sqrt(versine * (2.0 - versine)) / ray.cosine);
  return ray;
}

// Whether a point of a square grid of gridSize^2 points lies on the disk that touches the square's sides.
// Exact: no point lies on the circle. index in [0, gridSize^2), gridSize in [1, 1024].
bool IsOnDisk(int index, int gridSize)
{
  int row = index / gridSize;
  int x = 2 * (index - row * gridSize) + 1 - gridSize;
  int y = 2 * row + 1 - gridSize;
  return x * x + y * y <= gridSize * gridSize;
}

// The direction to that point of the cone's base, [Schott2009] eq. 11 and section 3.4.
// coneTangent of the half angle, >= 0: the disk's radius at a distance of 1.
ConeRay DiskDirection(int index, int gridSize, float coneTangent)
{
  int row = index / gridSize;
  vec2 place = vec2(float(2 * (index - row * gridSize) + 1 - gridSize), float(2 * row + 1 - gridSize));
  ConeRay ray;
  ray.slope = place * (coneTangent / float(gridSize));
  ray.cosine = 1.0 / sqrt(1.0 + dot(ray.slope, ray.slope));
  return ray;
}

// The solid angle of a piece of the cone's base, relative to that of the same piece on the axis. The paper
// gives all of them the weight 1.
float SolidAngleOfDisk(float cosine)
{
  return cosine * cosine * cosine;
}

// Transmittance of a stretch of a homogeneous material. opacity in [0, 1], of a stretch of length 1;
// relativeLength >= 0: 1/cosine of a ray across a slice ([Schott2009] Algorithm 2), 1 with approximated
// distances (Algorithm 3). 0 of an opaque material at any length.
float StretchTransmittance(float opacity, float relativeLength)
{
  return opacity >= 1.0 ? 0.0 : exp(-min(OpticalDepth(opacity) * relativeLength, LargestDepth));
}

// Where a ray through a place on a slice crosses another one, sliceDistance nearer to the open end. Places
// are lengths divided by their slice's width: the distance to the eye (perspective) or 1 (parallel), so that
// the places of a pixel are the same on all slices. [Schott2009] eqs 12 to 15.
vec2 PlaceOnSlice(vec2 place, vec2 slope, float sliceDistance, float width, float otherWidth)
{
  return (place * width + slope * sliceDistance) / otherWidth;
}

// A way that is given for a cone about (0, 0, -1), turned by the shortest turn to a cone about another axis. axis: of
// length 1, to the open end, its z < 0.
vec3 TurnToAxis(vec3 way, vec3 axis)
{
  float aside = (axis.y * way.x - axis.x * way.y) / (1.0 - axis.z);
  vec2 across = axis.z * vec2(way.x, way.y) + way.z * vec2(axis.x, axis.y) - aside * vec2(axis.y, -axis.x);
  return vec3(-across.x, -across.y, axis.x * way.x + axis.y * way.y - axis.z * way.z);
}

// A ray that goes along the slices, or away from the open end, never leaves them: it gets this rise at least, of its
// length.
const float LeastRise = 0.05;

// The slope of a way to the open end, at negative z.
vec2 SlopeOfWay(vec3 way)
{
  return vec2(way.x, way.y) / max(-way.z, LeastRise * length(way));
}

// A gathering ray is cut in parts, each twice as long as the one before: the share of the first of count in its length.
// count in [1, 16].
float FirstPartOfRay(int count)
{
  return 1.0 / (exp2(float(count)) - 1.0);
}

// What the points of a stretch of the ray see through it, on average, each as much as the eye sees of it:
// int_0^1 exp(-x s) exp(-x r s) x ds / (1 - exp(-x)) for the depth x and the relative length r. opacity in
// [0, 1] of the stretch; relativeLength >= 0 of the way out to that along the ray. 1 without opacity, and
// 1/(1 + r) of an opaque stretch: its points see the half of what they would without it at r = 1.
float StretchVisibility(float opacity, float relativeLength)
{
  float depth = opacity < 1.0 ? OpticalDepth(opacity) : LargestDepth;
  float whole = 1.0 + relativeLength;
  return opacity > 0.0 ? OneMinusExp(min(depth * whole, LargestDepth)) / (whole * opacity) : 1.0;
}

// The relative length at which StretchVisibility() of an opaque stretch is the mean over a cone of what it is at
// 1/cosine: of c/(1 + c), int_a^1 c/(1 + c) dc/(1 - a) = 1 + ln((1 + a)/2)/(1 - a). coneCosine a in (0, 1]; 1 at 1,
// and rising as the cone opens.
float MeanWayOut(float coneCosine)
{
  float versine = 1.0 - coneCosine;
  float series = 1.0 / 2.0 +
    versine * (1.0 / 8.0 + versine * (1.0 / 24.0 + versine * (1.0 / 64.0 + versine * (1.0 / 160.0 + versine / 384.0))));
  float hidden = versine < 0.1 ? series : -log(1.0 - versine / 2.0) / versine;
  return hidden / (1.0 - hidden);
}
