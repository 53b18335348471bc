// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "MacrocellGradients.h"

namespace
{
inline float Larger(float a, float b)
{
  return a > b ? a : b;
}

inline float Steeper(float before, float here, float after, float scale)
{
  const float to = std::abs(after - here) * scale, from = std::abs(here - before) * scale;
  return Larger(volumeoptics::UpToOne(to), volumeoptics::UpToOne(from));
}
}

namespace volumeoptics
{
//------------------------------------------------------------------------------
void FindGradientSquares(
  const float* const rows[5], int size, const std::array<float, 3>& scale, float* squares)
{
  const float *here = rows[0], *front = rows[1], *back = rows[2], *below = rows[3], *above = rows[4];
  const float scaleX = scale[0], scaleY = scale[1], scaleZ = scale[2];
  for (int x = 0; x < size; ++x)
  {
    const float alongX = (here[x + 1] - here[x - 1]) * scaleX, alongY = (back[x] - front[x]) * scaleY,
                alongZ = (above[x] - below[x]) * scaleZ;
    squares[x] = UpToOne(alongX * alongX + alongY * alongY + alongZ * alongZ);
  }
}

//------------------------------------------------------------------------------
void FindLargestSteps(const float* const rows[5], int size, const std::array<float, 3>& scale, float* steps)
{
  const float *here = rows[0], *front = rows[1], *back = rows[2], *below = rows[3], *above = rows[4];
  const float scaleX = scale[0], scaleY = scale[1], scaleZ = scale[2];
  for (int x = 0; x < size; ++x)
  {
    const float alongX = Steeper(here[x - 1], here[x], here[x + 1], scaleX);
    const float alongY = Steeper(front[x], here[x], back[x], scaleY);
    const float alongZ = Steeper(below[x], here[x], above[x], scaleZ);
    steps[x] = Larger(Larger(alongX, alongY), alongZ);
  }
}

//------------------------------------------------------------------------------
void EnlargeBounds(float* largest, const float* values, int size)
{
  for (int i = 0; i < size; ++i)
  {
    largest[i] = Larger(values[i], largest[i]);
  }
}
}
