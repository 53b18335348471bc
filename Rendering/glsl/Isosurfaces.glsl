// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeRayDirection::Dec, after SegmentSmooth. Surfaces of the property's list, sorted by their values: those
// between the scalars at a segment's ends, in the order of crossing, with the smooth parts between them.

uniform sampler2D in_opticsIsosurfaces; // row 0: the value; row 1: colour and opacity, red < 0: the data's colour
uniform int in_opticsNumberOfIsosurfaces;

// Each is a fetch, and takes light on a surface 6 to 8 times nearer to that where bisection finds it, with steps of
// half a voxel.
const int opticsRefinements = 2;

int g_opticsValuesBelow; // isovalues that the scalar at the front has reached

float opticsIsovalue(int index)
{
  return texelFetch(in_opticsIsosurfaces, ivec2(index, 0), 0).r;
}

void opticsBeginAt(float scalar)
{
  g_opticsValuesBelow = 0;
  while (g_opticsValuesBelow < in_opticsNumberOfIsosurfaces && opticsIsovalue(g_opticsValuesBelow) <= scalar)
  {
    ++g_opticsValuesBelow;
  }
}

// The next surface on the way to the scalar at the back, or -1.
int opticsNextIsosurface(float back)
{
  if (g_opticsValuesBelow < in_opticsNumberOfIsosurfaces && back >= opticsIsovalue(g_opticsValuesBelow))
  {
    return g_opticsValuesBelow++;
  }
  if (g_opticsValuesBelow > 0 && back < opticsIsovalue(g_opticsValuesBelow - 1))
  {
    return --g_opticsValuesBelow;
  }
  return -1;
}

vec3 opticsPointOfSegment(float place, float steps)
{
  return g_dataPos - g_dirStep * (steps * (1.0 - place));
}

// Where the segment that ends at g_dataPos has the value, 0 at its front and 1 at its end. At begin the scalar is that
// of the front. Between its ends it is not linear, but closer to it the nearer two points are.
float opticsCrossing(float begin, float front, float back, float value, float steps)
{
  float end = 1.0;
  float place = mix(begin, end, CrossingFraction(front, back, value));
  for (int i = 0; i < opticsRefinements; ++i)
  {
    float scalar = dot(opticsScalarsAt(opticsPointOfSegment(place, steps)), in_opticsOpacityChannel);
    if (CrossesIsovalue(front, scalar, value))
    {
      end = place;
      back = scalar;
    }
    else if (CrossesIsovalue(scalar, back, value))
    {
      begin = place;
      front = scalar;
    }
    place = mix(begin, end, CrossingFraction(front, back, value));
  }
  return place;
}

// At a point of the segment that ends at g_dataPos, lit there.
void opticsIsosurfaceToEye(int index, vec3 texPosition)
{
  vec4 surface = texelFetch(in_opticsIsosurfaces, ivec2(index, 1), 0);
  if (surface.a > 0.0)
  {
    vec3 end = g_dataPos;
    g_dataPos = texPosition;
    g_opticsSeen = g_opticsSeesSurface ? g_opticsSeen : texPosition;
    g_opticsSeesSurface = true;
    g_opticsIsSurface = true;
    opticsTransmitSurface(surface.a);
    vec4 scalars = opticsScalarsAt(texPosition);
    vec3 color = surface.r < 0.0 ? opticsColor(surface.rgb, scalars) : surface.rgb;
    opticsComposite(vec4(color, opticsEyeSurfaceOpacity(surface.a)), scalars);
    g_opticsIsSurface = false;
    g_dataPos = end;
  }
}

void opticsSegmentToEye(float front, float back, float steps, vec4 scalars)
{
  float from = front;
  float done = 0.0;
  for (int surface = opticsNextIsosurface(back); surface >= 0; surface = opticsNextIsosurface(back))
  {
    float value = opticsIsovalue(surface);
    float place = opticsCrossing(done, from, back, value, steps);
    opticsSmoothToEye(from, value, steps * (place - done), scalars);
    opticsIsosurfaceToEye(surface, opticsPointOfSegment(place, steps));
    from = value;
    done = place;
  }
  opticsSmoothToEye(from, back, steps * (1.0 - done), scalars);
}
