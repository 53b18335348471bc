// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifdef OPTICS_SWEEP
// Place ComputeRayDirection::Dec, after Isosurfaces. What passes all those between two scalars.
float opticsIsosurfacesTransmittance(float front, float back)
{
  float clear = 1.0;
  for (int i = 0; i < in_opticsNumberOfIsosurfaces; ++i)
  {
    float opacity = texelFetch(in_opticsIsosurfaces, ivec2(i, 1), 0).a;
    clear *= CrossesIsovalue(front, back, opticsIsovalue(i)) ? 1.0 - opacity : 1.0;
  }
  return clear;
}
#endif
