// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeRayDirection::Dec.

void opticsTransmit(float from, float to, float depth)
{
}

void opticsTransmitSurface(float opacity)
{
}
