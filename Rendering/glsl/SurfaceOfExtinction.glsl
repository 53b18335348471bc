// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec, after ExtinctionGradient*. The surface that is lit is that of the extinction.

OpticsGradient opticsSurfaceGradient(float label)
{
  return opticsExtinctionGradient(label);
}
