// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place Base::Dec.

uniform mat4 in_opticsDataToFrame; // data space to texture coordinates of the frame's grid
mat4 g_opticsTexToFrame;
