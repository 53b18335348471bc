// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// A range of scalar values with soft edges: the factor that a lighting transfer function
// [Lum2004, section 4.1] and a rule of a classification by several samples are made of.

// 1 for low <= value <= high, falling linearly to 0 at the distance `softness` outside.
// low <= high, softness >= 0: 0 is a hard edge that belongs to the range. 0 for a value that is NaN.
float SoftRange(float value, float low, float high, float softness)
{
  float distance = max(low - value, value - high);
  if (distance <= 0.0)
  {
    return 1.0;
  }
  return distance < softness ? 1.0 - distance / softness : 0.0;
}
