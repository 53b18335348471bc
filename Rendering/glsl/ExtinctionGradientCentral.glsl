// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec, after OpacityAt*. The gradient of the classified extinction by central
// differences over one voxel on each axis, [Ament2015] eq. 5.

uniform mat3 in_opticsDifferenceToData; // differences along the index axes to a gradient times D

struct OpticsGradient
{
  vec3 normal;       // data space, unit, -grad(extinction) or 0
  vec3 frameNormal;  // data space, unit, -grad(s) or 0: what the frame is stored with
  float coefficient; // SpecularCoefficient
};

float opticsDepthAt(vec3 texPosition, float label)
{
  vec4 texel = texture(in_volume[0], texPosition) * in_volume_scale[0] + in_volume_bias[0];
  float change = opticsChangeAt(texPosition);
  return BoundedOpticalDepth(opticsOpacityAt(dot(texel, in_opticsOpacityChannel), texPosition, change, label));
}

OpticsGradient opticsExtinctionGradient(float label)
{
  vec3 voxel = 1.0 / vec3(textureSize(in_volume[0], 0));
  vec3 ahead = vec3(opticsDepthAt(g_dataPos + vec3(voxel.x, 0.0, 0.0), label),
    opticsDepthAt(g_dataPos + vec3(0.0, voxel.y, 0.0), label), opticsDepthAt(g_dataPos + vec3(0.0, 0.0, voxel.z), label));
  vec3 behind = vec3(opticsDepthAt(g_dataPos - vec3(voxel.x, 0.0, 0.0), label),
    opticsDepthAt(g_dataPos - vec3(0.0, voxel.y, 0.0), label), opticsDepthAt(g_dataPos - vec3(0.0, 0.0, voxel.z), label));
  vec3 slope = in_opticsDifferenceToData * (ahead - behind);
  float steepness = length(slope);
  OpticsGradient gradient;
  gradient.normal = steepness > 0.0 ? -slope / steepness : vec3(0.0);
  gradient.frameNormal = opticsFrameNormal(g_dataPos);
  gradient.coefficient = min(steepness, LargestSpecularCoefficient);
  return gradient;
}
