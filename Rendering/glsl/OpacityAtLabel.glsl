// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec, after OpacityTable. Label 0 has the scalar opacity, others their own.

float opticsOpacityAt(float scalar, vec3 texPosition, float change, float label)
{
  float labelled = texture(in_labelMapTransfer, vec2(scalar, label)).a;
  return label > 0.0 ? labelled : opticsTableOpacity(scalar);
}
