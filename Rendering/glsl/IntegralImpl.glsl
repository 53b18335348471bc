// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

    // Place Shading::Impl, in place of VTK's text.
    opticsSample();
