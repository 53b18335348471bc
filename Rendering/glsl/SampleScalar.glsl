// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place Base::Dec. Scalars as VTK's tables are read with them, in [0, 1].

uniform vec4 in_opticsOpacityChannel; // selects the component that opacity depends on

vec4 g_opticsScalar; // the sample's components, set before computeLighting()
