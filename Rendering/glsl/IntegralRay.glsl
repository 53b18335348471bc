// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeRayDirection::Dec, last. From sample to sample.

// Where the ray leaves the block, or meets its end.
float opticsPlaceOfEnd(vec3 rayEnd)
{
  float end = dot(rayEnd - g_rayOrigin, g_dirStep) / dot(g_dirStep, g_dirStep);
  for (int axis = 0; axis < 3; ++axis)
  {
    float face = g_dirStep[axis] > 0.0 ? in_texMax[0][axis] : in_texMin[0][axis];
    if (g_dirStep[axis] != 0.0)
    {
      end = min(end, (face - g_rayOrigin[axis]) / g_dirStep[axis]);
    }
  }
  //Optics::End
  return end;
}

void opticsBegin(float scalar, float place)
{
  g_opticsHasFront = !isnan(scalar);
  g_opticsFront = scalar;
  g_opticsFrontPlace = place;
  opticsBeginAt(scalar);
}

void opticsBeginAtPosition(vec3 texPosition, float place)
{
  opticsBegin(dot(opticsScalarsAt(texPosition), in_opticsOpacityChannel), place);
}

// The segment between the front and g_dataPos, which is at the place.
void opticsIntegrateTo(float place)
{
  vec4 scalars = opticsScalarsAt(g_dataPos);
  float scalar = dot(scalars, in_opticsOpacityChannel);
  if (!g_opticsHasFront || isnan(scalar))
  {
    opticsBegin(scalar, place);
  }
  else if (place > g_opticsFrontPlace)
  {
    opticsSegmentToEye(g_opticsFront, scalar, place - g_opticsFrontPlace, scalars);
    g_opticsFront = scalar;
    g_opticsFrontPlace = place;
  }
}

// The segment that ends at g_dataPos, as far as it is visible; VTK's classification of a sample belongs to it. Leaves
// behind where something is seen, for the depths that VTK takes there.
void opticsSample()
{
  g_srcColor = vec4(0.0);
  vec3 position = g_dataPos;
  g_opticsSeen = position;
  g_opticsSeesSurface = false;
  float place = g_opticsPlace;
  float steps = place - g_opticsFrontPlace;
  bool isLeaving = g_skip && !g_opticsWasHidden;
  if (isLeaving)
  {
    float part = opticsVisiblePart(position - g_dirStep * steps, position);
    g_dataPos = position - g_dirStep * (steps * (1.0 - part));
    place -= steps * (1.0 - part);
  }
  else if (!g_skip && g_opticsWasHidden)
  {
    float part = opticsVisiblePart(position, position - g_dirStep * steps);
    opticsBeginAtPosition(position - g_dirStep * (steps * part), place - steps * part);
  }
  if (isLeaving || !g_skip)
  {
    opticsIntegrateTo(place);
  }
  g_opticsWasHidden = g_skip;
  g_opticsFrontPlace = g_opticsPlace;
  g_dataPos = g_opticsSeen;
}
