// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

//VTK::System::Dec

// A vertex of a tetrahedron, four of which follow each other. The flat values are the same at all
// four. MC: the grid's own coordinates, shifted and scaled to a unit box; VC: view coordinates.

in vec3 vertexMC;
in vec4 vertexScalars; // at the first vertex, and what the others have more
in vec3 vertexWeightGradient1;
in vec3 vertexWeightGradient2;
in vec3 vertexWeightGradient3;

uniform mat4 in_modelToView;
uniform mat4 in_viewToDevice;
uniform mat3 in_gradientToView;

smooth out vec3 positionView;
smooth out vec3 weights; // barycentric, of the vertices 1, 2, 3
flat out vec4 scalars;
flat out mat3 weightGradients;
flat out float scalarRounding;

// A bound of the rounding of a scalar, relative to the largest at the vertices.
const float ScalarRounding = 1.0e-6;

void main()
{
  int corner = gl_VertexID & 3;
  weights = vec3(corner == 1 ? 1.0 : 0.0, corner == 2 ? 1.0 : 0.0, corner == 3 ? 1.0 : 0.0);
  scalars = vertexScalars;
  vec3 others = abs(vertexScalars.x + vertexScalars.yzw);
  scalarRounding = ScalarRounding * max(max(abs(vertexScalars.x), others.x), max(others.y, others.z));
  weightGradients =
    in_gradientToView * mat3(vertexWeightGradient1, vertexWeightGradient2, vertexWeightGradient3);
  vec4 position = in_modelToView * vec4(vertexMC, 1.0);
  positionView = position.xyz;
  gl_Position = in_viewToDevice * position;
}
