// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#else
  // Place Shading::Init, last. One sample, behind nothing; and of what initializeRayCast() sets up for a ray, what
  // the sample depends on.
  //VTK::Cropping::Init
  g_dataPos = g_opticsFroxel;
  g_fragColor = vec4(0.0);
  g_dirStep = vec3(0.0);
  g_currentT = 0.0;
  g_exit = false;
#endif
