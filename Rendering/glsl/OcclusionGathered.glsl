// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec, after OpacityTable. Fractional visibility by final gathering: near the sample, where a
// surface is thinner than a froxel, rays of the cone look at the volume itself; where they end begins what the sweep
// from the eye found for each direction.

uniform sampler3D in_opticsOcclusion;       // four directions to a texel, each next four behind all slices
uniform mat4 in_opticsOcclusionGrid;        // VTK's texture coordinates to (x w, y w, z, w) of the grid's
uniform mat4 in_opticsGatherView;           // VTK's texture coordinates to the eye's, z away from it
uniform mat3 in_opticsGatherTexture;        // ways from the eye's coordinates to VTK's texture coordinates
uniform mat3 in_opticsGatherLengths;        // and to lengths in units of the opacity
uniform mat4 in_opticsGatherWorld;          // VTK's texture coordinates to the world's
uniform vec3 in_opticsGatherWays[16];       // of length 1, about (0, 0, -1)
uniform vec4 in_opticsGatherNumbers;        // directions, slices, layers of four directions, and of the directions
                                            // each so-manieth is gathered
uniform vec4 in_opticsGather;               // a ray's length, relative to the distance in perspective; the first part
                                            // of it; 1 in perspective; 1, or 0: nothing is known

// Of the pixel, what samples contribute that take the visibility of one before them, less what lies between the two: too
// little to gather for. Less where that one lies on something else, in front of a gap.
const float opticsLargestShare = 1.0 / 16.0;
const float opticsLargestShareOfOther = 1.0 / 64.0;

// Out of a sample's own stretch, relative to that along the eye's ray. Where rays graze, a surface no longer lies across
// the eye's ray, but somehow.
const float opticsLongestWayOut = 2.0;

float g_opticsGathered = 1.0; // by the last sample that gathered
float g_opticsShare = 1.0;    // since then; the first sample gathers
float g_opticsSince = 0.0;    // optical depth that the eye's ray has met since: it hides as much from this sample
float g_opticsEnough = 0.0;   // for which the next one gathers

bool opticsIsClipped(vec3 world);

float opticsGatheredDepth(vec3 texPosition)
{
  bool isInside = all(greaterThanEqual(texPosition, in_texMin[0])) && all(lessThanEqual(texPosition, in_texMax[0]));
  vec4 texel = texture(in_volume[0], texPosition) * in_volume_scale[0] + in_volume_bias[0];
  float opacity = opticsTableOpacity(dot(texel, in_opticsOpacityChannel));
  bool isSeen = isInside && !opticsIsClipped((in_opticsGatherWorld * vec4(texPosition, 1.0)).xyz);
  return isSeen ? (opacity < 1.0 ? OpticalDepth(opacity) : LargestDepth) : 0.0;
}

// By VTK's own table: what it draws is not left out.
bool opticsIsUnseen(vec3 texPosition)
{
  float scalar = texture(in_volume[0], texPosition).r * in_volume_scale[0].r + in_volume_bias[0].r;
  return computeOpacity(vec4(scalar)) <= 0.0;
}

float opticsReaching(int direction, vec3 texPosition)
{
  vec4 froxel = in_opticsOcclusionGrid * vec4(texPosition, 1.0);
  float slices = in_opticsGatherNumbers.y;
  int layer = direction / 4;
  float slice = froxel.z * slices;
  float unhidden = clamp(1.0 - 2.0 * slice, 0.0, 1.0); // from the middle of the first slice on to the grid's front
  slice = clamp(slice, 0.5, slices - 0.5) + float(layer) * slices;
  vec3 place = vec3(froxel.xy / froxel.w, slice / (slices * in_opticsGatherNumbers.z));
  return mix(texture(in_opticsOcclusion, place)[direction - 4 * layer], 1.0, unhidden);
}

float opticsGatheredRay(vec3 texPosition, vec3 texWay)
{
  float depth = 0.0;
  float begin = 0.0;
  float part = in_opticsGather.y;
  for (int i = 0; i < OPTICS_GATHER_SAMPLES; ++i)
  {
    depth += part * opticsGatheredDepth(texPosition + (begin + 0.5 * part) * texWay);
    begin += part;
    part *= 2.0;
  }
  return depth;
}

vec2 g_opticsMet = vec2(0.0);  // optical depths of the sample before this one, and of the one before that
float g_opticsLastDepth = 0.0; // of the last one that was seen
float g_opticsLastT = -9.0;    // and where it was, in steps

// How far rays begin in front of the front of a stretch, in steps. The eye has met what its samples happened to hit; of
// what is denser than a step can tell that differs from sample to sample, and would show as rings. So rays begin where
// the depth of the last two steps is what the eye met on them.
float opticsShiftToMet(vec3 front)
{
  float step = length(in_opticsGatherLengths * (mat3(in_opticsGatherView) * g_dirStep));
  float depth = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    depth += 0.5 * step * opticsGatheredDepth(front - (0.5 * float(i) + 0.25) * g_dirStep);
  }
  float slope = step * opticsGatheredDepth(front);
  float excess = depth - g_opticsMet.x - g_opticsMet.y;
  return clamp(excess / max(slope, 1.0e-3), -0.5, 1.0);
}

void opticsRemember(float opacity)
{
  float gap = g_currentT - g_opticsLastT;
  g_opticsMet = gap < 1.5 ? vec2(g_opticsLastDepth, g_opticsMet.x) : vec2(0.0, gap < 2.5 ? g_opticsLastDepth : 0.0);
  g_opticsLastDepth = opacity < 1.0 ? OpticalDepth(opacity) : LargestDepth;
  g_opticsLastT = g_currentT;
}

float opticsOcclusion(vec3 texPosition, float opacity)
{
#ifdef OPTICS_SWEEP
  return 1.0; // what is drawn on must not be read
#else
  // A sample stands for the stretch of a step about it: rays begin at its front, and all of its points count. VTK's first
  // sample lies a step behind the face of the volume, or a clipping plane, and stands for all of that.
  bool isFirst = dot(texPosition - g_rayOrigin, g_dirStep) < 1.5 * dot(g_dirStep, g_dirStep);
  vec3 front = texPosition - (isFirst ? 1.0 : 0.5) * g_dirStep;
  g_opticsEnough = g_currentT - g_opticsLastT > 2.5 ? opticsLargestShareOfOther : g_opticsEnough;
  opticsRemember(opacity);
  front -= opticsShiftToMet(front) * g_dirStep;
  vec3 position = (in_opticsGatherView * vec4(front, 1.0)).xyz;
  bool isPerspective = in_opticsGather.z > 0.0;
  vec3 axis = isPerspective ? -normalize(position) : vec3(0.0, 0.0, -1.0);
  float reach = in_opticsGather.x * (isPerspective ? position.z : 1.0);
  g_opticsShare += opacity * (1.0 - g_fragColor.a);
  bool gathers = opacity > 0.0 && g_opticsShare > g_opticsEnough;
  int directions = gathers ? int(in_opticsGatherNumbers.x) : 0;
  int stride = int(in_opticsGatherNumbers.w);
  float sum = 0.0;
  for (int i = 0; i < directions; i += stride)
  {
    vec3 way = reach * TurnToAxis(in_opticsGatherWays[i], axis);
    vec3 texWay = in_opticsGatherTexture * way;
    float depth = opticsGatheredRay(front, texWay) * length(in_opticsGatherLengths * way);
    float own = StretchVisibility(opacity, min(-1.0 / in_opticsGatherWays[i].z, opticsLongestWayOut));
    sum += own * exp(-min(depth, LargestDepth)) * opticsReaching(i, front + texWay);
  }
  g_opticsGathered = gathers ? sum * in_opticsGatherNumbers.w / in_opticsGatherNumbers.x : g_opticsGathered;
  g_opticsShare = gathers ? 0.0 : g_opticsShare;
  g_opticsEnough = gathers ? opticsLargestShare : g_opticsEnough;
  float halfDepth = 0.5 * g_opticsLastDepth;
  g_opticsSince = gathers ? 0.0 : g_opticsSince + halfDepth;
  float visibility = g_opticsGathered * exp(-min(g_opticsSince, LargestDepth));
  g_opticsSince += halfDepth;
  return in_opticsGather.w > 0.0 ? visibility : 1.0;
#endif
}
