// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Associated colour and opacity of what a fragment's ray sees of a tetrahedron: without isosurfaces.
vec4 FragmentColor(float front, float back, float segmentLength)
{
  return InteriorColor(front, back, segmentLength * length(weightGradients * scalars.yzw));
}
