// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifdef OPTICS_SWEEP
// Place ComputeRayDirection::Dec, last. The segment is a froxel from front to back, its isosurfaces included; never
// silhouettes: those are the eye's.
void opticsSweepSegment()
{
  float front = dot(opticsScalarsAt(g_opticsFroxelFront), in_opticsOpacityChannel);
  float back = dot(opticsScalarsAt(g_opticsFroxelBack), in_opticsOpacityChannel);
  g_srcColor = vec4(0.0);
  if (!g_skip && !isnan(front) && !isnan(back))
  {
    float clear = 1.0 - opticsSegment(front, back, in_sweepStepsOfSlice).a;
    g_srcColor.a = 1.0 - clear * opticsIsosurfacesTransmittance(front, back);
  }
  g_fragColor = g_srcColor;
}
#define opticsSample opticsSweepSegment
#endif
