// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec.

float opticsGradientOpacity(int component, float label)
{
  return 1.0;
}
