// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeRayDirection::Dec, last. A ray over empty bricks.

// Whole steps to the first sample beyond the brick that holds the position; at least one.
float opticsStepsOutOfBrick(vec3 position, vec3 direction)
{
  vec3 tile = opticsLineTile(position, in_opticsLineDimensions, in_opticsLineBrick);
  vec3 last = ceil(in_opticsLineDimensions / in_opticsLineBrick) - 1.0;
  float steps = 1.0e6;
  for (int axis = 0; axis < 3; ++axis)
  {
    bool isUp = direction[axis] > 0.0;
    bool isOutermost = isUp ? tile[axis] >= last[axis] : tile[axis] <= 0.0;
    float face = (tile[axis] + (isUp ? 1.0 : 0.0)) * in_opticsLineBrick[axis] + 0.5;
    if (direction[axis] != 0.0 && !isOutermost)
    {
      steps = min(steps, (face - position[axis]) / direction[axis]);
    }
  }
  return max(ceil(steps), 1.0);
}

bool opticsHasLeft(vec3 texPosition)
{
  return any(greaterThan(max(g_dirStep, vec3(0.0)) * (texPosition - in_texMax[0]), vec3(0.0))) ||
    any(greaterThan(min(g_dirStep, vec3(0.0)) * (texPosition - in_texMin[0]), vec3(0.0)));
}

// Leaps to the next sample in a brick that is not empty, or ends the ray, where VTK's loop would.
void opticsLeapOverEmptyBricks()
{
  vec3 direction = vec3(g_opticsTexToLines * vec4(g_dirStep, 0.0));
  vec3 position = vec3(g_opticsTexToLines * vec4(g_dataPos, 1.0));
  while (!g_exit && opticsLinesAreEmptyAt(position))
  {
    float steps = opticsStepsOutOfBrick(position, direction);
    g_dataPos += steps * g_dirStep;
    g_currentT += steps;
    position = vec3(g_opticsTexToLines * vec4(g_dataPos, 1.0));
    g_exit = opticsHasLeft(g_dataPos) || g_currentT - 1.0 >= g_terminatePointMax;
  }
}
