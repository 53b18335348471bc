// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place Base::Dec. The box of the whole volume, and of the input; what is drawn lies from in_texMin to in_texMax.
uniform vec3 in_opticsWholeMin;
uniform vec3 in_opticsWholeMax;
uniform vec3 in_opticsInputMin;
uniform vec3 in_opticsInputMax;
uniform float in_opticsNearest; // depth at which rays begin, for a camera inside

float g_opticsPieceEnd; // of the last sample, or segment, in steps from the first sample
