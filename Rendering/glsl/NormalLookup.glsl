// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec. The stored normal -grad(s)/|grad(s)| and gradient magnitude.

uniform sampler3D in_opticsNormals;
uniform vec2 in_opticsFrameCode;       // scale and bias of a signed code
uniform float in_opticsMagnitudeScale; // to change of the scalar in [0, 1] over one step h

struct OpticsNormal
{
  vec3 normal; // data space, unit, or 0 where the data is constant
  float change;
};

OpticsNormal opticsStoredNormal(vec3 texPosition)
{
  vec3 framePosition = (g_opticsTexToFrame * vec4(texPosition, 1.0)).xyz;
  vec4 texel = texture(in_opticsNormals, framePosition);
  vec3 normal = texel.xyz * in_opticsFrameCode.x + in_opticsFrameCode.y;
  float squared = dot(normal, normal);
  OpticsNormal stored;
  stored.normal = squared > 1.0e-8 ? normal * inversesqrt(squared) : vec3(0.0);
  stored.change = texel.w * in_opticsMagnitudeScale;
  return stored;
}
