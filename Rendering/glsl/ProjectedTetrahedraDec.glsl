// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

//VTK::System::Dec
//VTK::Output::Dec

smooth in vec3 positionView;
smooth in vec3 weights;
flat in vec4 scalars;
flat in mat3 weightGradients;
flat in float scalarRounding;

uniform sampler2D in_table; // x front, y back
uniform sampler2D in_opaqueDepth;
uniform vec4 in_depthCode; // elements zz, zw, wz, ww of the projection
uniform float in_tableSize;
uniform float in_nearDistance;
uniform int in_isParallel;

float TableCoordinate(float normalizedScalar, float entries); // of DataSpace.glsl

vec4 TableEntry(float front, float back)
{
  return texture(in_table, vec2(TableCoordinate(front, in_tableSize), TableCoordinate(back, in_tableSize)));
}
