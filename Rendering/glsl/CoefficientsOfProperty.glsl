// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec. VTK's Ambient, Diffuse and Specular.

OpticsCoefficients opticsCoefficients(int component)
{
  return OpticsCoefficients(in_ambient[component], in_diffuse[component], in_specular[component]);
}
