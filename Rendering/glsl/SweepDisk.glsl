// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

//VTK::Output::Dec

// Behind the ray caster's text, after Visibility. The mean of what passed the slice before this one, over the disk in
// which it cuts the cone: [Schott2009] Algorithms 2 and 3. For comparison.

uniform int in_sweepDiskSize;        // of the square grid of points around the disk
uniform float in_sweepConeTangent;
uniform float in_sweepTrueDistances; // 1: to each point its own (Algorithm 2); 0: that along the axis (3)
uniform float in_sweepSolidAngles;   // 1: points count by their solid angle; 0: evenly
uniform mat3 in_sweepToSlices;       // a slope (x, y, -1) to the way from slice to slice, relative to their distance
uniform float in_sweepSliceDistance;
uniform float in_sweepWidth;         // of this slice
uniform float in_sweepOtherWidth;    // of the one before it
uniform vec4 in_sweepWindowCode;     // scale and bias from places to texture coordinates
uniform sampler2D in_sweepPassed0;

void opticsSweep(vec2 place, float opacity)
{
  float reaching = 0.0;
  float passing = 0.0;
  float weights = 0.0;
  for (int i = 0; i < in_sweepDiskSize * in_sweepDiskSize; ++i)
  {
    if (IsOnDisk(i, in_sweepDiskSize))
    {
      ConeRay ray = DiskDirection(i, in_sweepDiskSize, in_sweepConeTangent);
      vec2 before = PlaceOnSlice(place, ray.slope, in_sweepSliceDistance, in_sweepWidth, in_sweepOtherWidth);
      float weight = mix(1.0, SolidAngleOfDisk(ray.cosine), in_sweepSolidAngles);
      float seen = weight * texture(in_sweepPassed0, before * in_sweepWindowCode.xy + in_sweepWindowCode.zw).r;
      float slices = length(in_sweepToSlices * vec3(ray.slope * in_sweepTrueDistances, -1.0));
      reaching += seen;
      passing += seen * StretchTransmittance(opacity, opticsRelativeLength(slices));
      weights += weight;
    }
  }
  gl_FragData[0] = vec4(reaching / weights);
  gl_FragData[1] = vec4(passing / weights);
}
