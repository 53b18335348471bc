// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

//VTK::System::Dec

// A triangle around the whole slice, from no vertices at all. What VTK's vertex shader hands on is not asked for.

out vec3 ip_textureCoords;
out vec3 ip_vertexPos;
out mat4 ip_inverseTextureDataAdjusted;

uniform mat4 in_sweepDataToTexture;

void main()
{
  ip_textureCoords = vec3(0.0);
  ip_vertexPos = vec3(0.0);
  ip_inverseTextureDataAdjusted = in_sweepDataToTexture;
  vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1));
  gl_Position = vec4(corner * 4.0 - 1.0, 0.0, 1.0);
}
