// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place Base::Dec. Whether what is lit is an isosurface.

bool g_opticsIsSurface = false;
