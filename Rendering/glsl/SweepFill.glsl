// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

//VTK::Output::Dec

// Instead of a sweep: the opacity of a slice's froxels, in the one block that VTK has loaded of a volume in partitions.
// The first block of a frame clears what is not in it, later ones leave it.

uniform int in_sweepBlock;

void opticsSweep(vec2 place, float opacity)
{
  if (in_sweepBlock > 0 && opacity <= 0.0)
  {
    discard;
  }
  gl_FragData[0] = vec4(opacity);
  gl_FragData[1] = vec4(1.0);
}
