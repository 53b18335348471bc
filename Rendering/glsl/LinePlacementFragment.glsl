// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

//VTK::System::Dec
//VTK::Output::Dec

// Fragment shader of the atlas: a fragment is a texel, which takes an evaluated voxel over, or nothing.

uniform isampler2D in_sources; // of each texel the number of the voxel; -1: none
uniform sampler2D in_evaluated;

void main()
{
  int voxel = texelFetch(in_sources, ivec2(gl_FragCoord.xy), 0).r;
  int width = textureSize(in_evaluated, 0).x;
  ivec2 place = ivec2(max(voxel, 0) % width, max(voxel, 0) / width);
  vec4 evaluated = texelFetch(in_evaluated, place, 0);
  gl_FragData[0] = voxel >= 0 ? evaluated : vec4(0.0);
}
