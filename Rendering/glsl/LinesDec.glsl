// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place Base::Dec. Anisotropic voxels, evaluated for the eye; positions in voxels, from the first one's corner.

uniform usampler3D in_opticsLineBricks; // of each brick the texel of its tile, or the distance to the next brick with one
uniform usampler2D in_opticsLineCells; // of each tile a bit for each cell between the middles of eight voxels
uniform sampler2D in_opticsLineAtlas;  // colour times opacity, opacity
uniform mat4 in_opticsDataToLines;
uniform vec3 in_opticsLineDimensions;
uniform float in_opticsLineUnitInverse; // of the length that the opacity of a voxel belongs to
