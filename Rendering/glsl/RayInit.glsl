// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

  // Place Base::Init, after VTK's text: reads rayDir (data space).
  mat4 opticsTexToData = inverse(ip_inverseTextureDataAdjusted);
  g_opticsTexToEye = in_modelViewMatrix * in_volumeMatrix[0] * opticsTexToData;
  g_opticsToViewer = -normalize(in_opticsTangentToEye * rayDir);
