// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Associated colour and opacity of what a fragment's ray sees of a tetrahedron: with isosurfaces.
vec4 FragmentColor(float front, float back, float segmentLength)
{
  return SegmentColor(front, back, segmentLength * length(weightGradients * scalars.yzw));
}
