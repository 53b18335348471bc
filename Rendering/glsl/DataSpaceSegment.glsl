// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Colour of a segment of a ray on which the scalar is linear, with isosurfaces where it crosses them.
// Plain GLSL that C++ includes as well (DataSpaceClassification). Needs DataSpaceInterior.glsl and
//   int NumberOfIsosurfaces()        their values ascend
//   float Isovalue(int index)
//   vec4 IsosurfaceColor(int index)  not associated; its opacity seen along the normal

// front, back: associated.
vec4 Over(vec4 front, vec4 back)
{
  return front + (1.0 - front.w) * back;
}

// Of an isosurface that the ray meets at an angle. cosine: of the angle between ray and gradient.
vec4 CrossingColor(int index, float cosine)
{
  vec4 surface = IsosurfaceColor(index);
  float opacity = surface.w;
  if (SilhouetteMode() == SilhouetteModeClamped)
  {
    opacity = ClampedSurfaceOpacity(surface.w, cosine);
  }
  else if (SilhouetteMode() != SilhouetteModeOff)
  {
    opacity = SurfaceSilhouetteOpacity(surface.w, cosine);
  }
  return vec4(vec3(surface) * opacity, opacity);
}

// Associated colour and opacity. The isosurfaces part the segment; each part looks the table up.
vec4 SegmentColor(float front, float back, float gradientStep)
{
  vec4 color = vec4(0.0, 0.0, 0.0, 0.0);
  float scalarStep = abs(back - front);
  float cosine = scalarStep < gradientStep ? scalarStep / gradientStep : 1.0;
  float partFront = front;
  float partStep = gradientStep;
  int surfaces = NumberOfIsosurfaces();
  for (int i = 0; i < surfaces; ++i)
  {
    int index = front < back ? i : surfaces - 1 - i;
    float value = Isovalue(index);
    if (CrossesIsovalue(front, back, value))
    {
      float fraction = CrossingFraction(partFront, back, value);
      color = Over(color, InteriorColor(partFront, value, partStep * fraction));
      color = Over(color, CrossingColor(index, cosine));
      partFront = value;
      partStep = partStep * (1.0 - fraction);
    }
  }
  return Over(color, InteriorColor(partFront, back, partStep));
}
