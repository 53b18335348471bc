// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifdef OPTICS_SWEEP
    break; // Place DepthPass::Impl: the one sample of a sweep
#endif
