// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

uniform sampler2D in_isosurfaces; // first row colours, second row values
uniform int in_numberOfIsosurfaces;

int NumberOfIsosurfaces()
{
  return in_numberOfIsosurfaces;
}

// The scalar where one cell ends and the next begins is rounded differently in the two. A value that whole
// faces have would be crossed twice or never; a little below it is crossed once.
float Isovalue(int index)
{
  return texelFetch(in_isosurfaces, ivec2(index, 1), 0).x - scalarRounding;
}

vec4 IsosurfaceColor(int index)
{
  return texelFetch(in_isosurfaces, ivec2(index, 0), 0);
}
