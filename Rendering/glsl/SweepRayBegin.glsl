// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef OPTICS_SWEEP // until SweepRayEnd: a sweep has no ray
