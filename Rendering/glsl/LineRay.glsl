// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeRayDirection::Dec, after RayEnd, and LineBlock or LineBlockNone. A ray over what is empty.

// Leaps to the next sample where something may be drawn, or ends the ray, where VTK's loop would.
void opticsLeapOverNothing()
{
  vec3 direction = opticsTexToLines(vec4(g_dirStep, 0.0));
  float steps = opticsStepsOverNothing(opticsTexToLines(vec4(g_dataPos, 1.0)), direction);
  while (!g_exit && steps > 0.0)
  {
    g_dataPos += steps * g_dirStep;
    g_currentT += steps;
    g_exit = opticsIsRayOver();
    steps = opticsStepsOverNothing(opticsTexToLines(vec4(g_dataPos, 1.0)), direction);
  }
}
