// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifdef OPTICS_SWEEP
// Place Base::Dec. Where a visibility sweep samples the volume, instead of a ray: the middle of a froxel, and its
// ends on the slice's front and back.
vec3 g_opticsFroxel;
vec3 g_opticsFroxelFront;
vec3 g_opticsFroxelBack;

uniform float in_sweepStepsOfSlice; // distance of the slices in steps of the ray
#endif
