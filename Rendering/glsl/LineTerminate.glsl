// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

    // Place Terminate::Impl, after VTK's text.
    opticsLeapOverNothing();
