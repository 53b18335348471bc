// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeRayDirection::Dec.

// The ray's entry into a box and its exit, in steps from the origin; the exit comes first where the ray misses it.
vec2 opticsStepsThrough(vec3 origin, vec3 least, vec3 greatest)
{
  vec3 smallest = vec3(1.0e-20);
  vec3 along = mix(g_dirStep, smallest, lessThan(abs(g_dirStep), smallest));
  vec3 toLeast = (least - origin) / along;
  vec3 toGreatest = (greatest - origin) / along;
  vec3 entry = min(toLeast, toGreatest);
  vec3 leaving = max(toLeast, toGreatest);
  return vec2(max(entry.x, max(entry.y, entry.z)), min(leaving.x, min(leaving.y, leaving.z)));
}
