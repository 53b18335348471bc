// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// A fragment of a face that looks away from the viewer: where the ray leaves the tetrahedron. The ray
// is followed back towards the viewer, by positionView - distance * direction, to where the first
// barycentric weight falls to 0; that is where it enters. [Weiler2003]

const float NoDistance = 1.0e30;

// To where a weight is 0; one that does not fall has no such place.
float DistanceToFace(float weight, float rate)
{
  return rate > 0.0 ? max(weight, 0.0) / rate : NoDistance;
}

// Of the nearest opaque geometry from the viewer's plane, NoDistance where there is none.
float OpaqueDistance()
{
  float depth = texelFetch(in_opaqueDepth, ivec2(gl_FragCoord.xy), 0).x;
  float device = 2.0 * depth - 1.0;
  float z = (in_depthCode.y - device * in_depthCode.w) / (device * in_depthCode.z - in_depthCode.x);
  return depth < 1.0 ? -z : NoDistance;
}

void main()
{
  vec3 direction = in_isParallel == 1 ? vec3(0.0, 0.0, -1.0) : positionView;
  vec3 rates = direction * weightGradients;
  float scalarRate = dot(rates, scalars.yzw);
  float entry = DistanceToFace(1.0 - weights.x - weights.y - weights.z, -rates.x - rates.y - rates.z);
  entry = min(entry, DistanceToFace(weights.x, rates.x));
  entry = min(entry, DistanceToFace(weights.y, rates.y));
  entry = min(entry, DistanceToFace(weights.z, rates.z));

  float depth = -positionView.z;
  float depthRate = -direction.z;
  entry = min(entry, (depth - in_nearDistance) / depthRate);
  float leaving = max((depth - OpaqueDistance()) / depthRate, 0.0);
  float distance = entry - leaving;
  if (!(distance > 0.0 && entry < NoDistance))
  {
    discard;
  }
  float back = scalars.x + dot(weights, scalars.yzw) - leaving * scalarRate;
  float front = back - distance * scalarRate;
  gl_FragData[0] = FragmentColor(front, back, distance * length(direction));
}
