// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Colour of a segment of a ray on which the scalar is linear, by the table of pre-integrated segments.
// Plain GLSL that C++ includes as well (DataSpaceClassification). Needs Opacity.glsl, DataSpace.glsl and
//   vec4 TableEntry(float front, float back)  mean colour and attenuation between two scalars
//   int SilhouetteMode()                      as vtkOpticsVolumeProperty::SilhouetteType
// Scalars and steps are in units of the table's range.

const int SilhouetteModeOff = 0;
const int SilhouetteModeClamped = 2;

// Of a segment without isosurfaces. gradientStep: |grad s| times its length.
vec4 InteriorColor(float front, float back, float gradientStep)
{
  vec4 mean = TableEntry(front, back);
  float scalarStep = abs(back - front);
  float opacity = SegmentOpacity(mean.w, scalarStep);
  if (SilhouetteMode() == SilhouetteModeClamped)
  {
    opacity = ClampedSilhouetteOpacity(mean.w, scalarStep, gradientStep);
  }
  else if (SilhouetteMode() != SilhouetteModeOff)
  {
    opacity = SilhouetteOpacity(mean.w, scalarStep, gradientStep);
  }
  return vec4(vec3(mean) * opacity, opacity);
}
