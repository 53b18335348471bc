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
  return end;
}

void opticsBegin(float scalar, float place)
{
  g_opticsHasFront = !isnan(scalar);
  g_opticsFront = scalar;
  g_opticsFrontPlace = place;
  opticsBeginAt(scalar);
}

// The segment that ends at g_dataPos; VTK's classification of a sample belongs to it.
void opticsSample()
{
  g_srcColor = vec4(0.0);
  if (g_skip)
  {
    g_opticsHasFront = false;
    return;
  }
  vec4 scalars = opticsScalarsAt(g_dataPos);
  float scalar = dot(scalars, in_opticsOpacityChannel);
  float steps = g_opticsPlace - g_opticsFrontPlace;
  if (!g_opticsHasFront || isnan(scalar))
  {
    opticsBegin(scalar, g_opticsPlace);
  }
  else if (steps > 0.0)
  {
    opticsSegmentToEye(g_opticsFront, scalar, steps, scalars);
    g_opticsFront = scalar;
    g_opticsFrontPlace = g_opticsPlace;
  }
}
