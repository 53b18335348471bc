// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec, after SurfaceDec and Anisotropy*.

struct OpticsSurface
{
  vec3 normal; // eye space, unit, or 0
  vec3 major;
  vec3 minor;
  float majorParameter;
  float coefficient;
};

OpticsSurface opticsSurface(float label)
{
  OpticsGradient gradient = opticsSurfaceGradient(label);
  AnisotropyFrame frame = EigenFrame(gradient.frameNormal, opticsAnisotropy(g_dataPos, gradient.frameNormal));
  OpticsSurface surface;
  surface.normal = opticsNormalInEye(gradient.normal);
  // tangents are carried forward and made orthogonal again: the matrix may scale unevenly
  vec3 major = in_opticsTangentToEye * frame.major;
  major -= surface.normal * dot(surface.normal, major);
  surface.major = major * inversesqrt(max(dot(major, major), 1.0e-20));
  surface.minor = cross(surface.normal, surface.major);
  surface.majorParameter = opticsMajorParameter(frame.logRatio);
  surface.coefficient = opticsCoefficient(gradient);
  return surface;
}
