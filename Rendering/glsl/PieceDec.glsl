// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place Base::Dec. The box of the whole volume, of which in_texMin to in_texMax is drawn.
uniform vec3 in_opticsWholeMin;
uniform vec3 in_opticsWholeMax;
