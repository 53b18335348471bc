// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

//VTK::System::Dec
//VTK::Output::Dec

// Fragment shader of the atlas: a fragment is a texel, which takes an evaluated voxel over, or nothing.

uniform usampler2D in_ranks; // of each texel which of its tile's voxels it holds, from 1 on; 0: none
uniform isampler2D in_firstSources; // of each tile, of its voxels
uniform isampler2D in_sources; // numbers of voxels
uniform sampler2D in_evaluated;

ivec2 PlaceInRows(int index, int width)
{
  return ivec2(index % width, index / width);
}

void main()
{
  ivec2 texel = ivec2(gl_FragCoord.xy);
  int rank = int(texelFetch(in_ranks, texel, 0).r);
  int first = texelFetch(in_firstSources, texel / ivec2(25, 5), 0).r; // texels of a tile
  int source = max(first + rank - 1, 0);
  int voxel = texelFetch(in_sources, PlaceInRows(source, textureSize(in_sources, 0).x), 0).r;
  vec4 evaluated = texelFetch(in_evaluated, PlaceInRows(voxel, textureSize(in_evaluated, 0).x), 0);
  gl_FragData[0] = rank > 0 ? evaluated : vec4(0.0);
}
