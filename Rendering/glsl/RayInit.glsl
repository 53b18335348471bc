// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

  // Place Base::Init, after VTK's text: reads rayDir (data space).
  mat4 opticsTexToData = inverse(ip_inverseTextureDataAdjusted);
  g_opticsTexToEye = in_modelViewMatrix * in_volumeMatrix[0] * opticsTexToData;
  vec3 opticsRayInEye = in_opticsTangentToEye * rayDir;
  g_opticsEyePerData = length(opticsRayInEye);
  g_opticsToViewer = -normalize(opticsRayInEye);
