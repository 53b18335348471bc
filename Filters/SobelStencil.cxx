// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SobelStencil.h"

#include <algorithm>
#include <cmath>

namespace volumeoptics
{
namespace
{
const int Strides[3] = { 1, 3, 9 };
}

SobelStencil::SobelStencil(const ImageGrid& grid)
  : Spacing(grid.Spacing)
  , ToWorld(grid.GradientToWorld)
{
  const double finest = grid.VoxelLength / grid.Factor;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double ratio = std::min(finest / std::abs(this->Spacing[axis]), 1.0);
    const double share = ratio * ratio / 2.0;
    this->Side[axis] = share / (2.0 * (1.0 - share));
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    const double sideA = this->Side[(axis + 1) % 3];
    const double sideB = this->Side[(axis + 2) % 3];
    this->Norm[axis] = 1.0 / ((1.0 + 2.0 * sideA) * (1.0 + 2.0 * sideB));
  }
}

double SobelStencil::Along(int axis, const double (&values)[27]) const
{
  const int a = (axis + 1) % 3;
  const int b = (axis + 2) % 3;
  double sum = 0.0;
  double weights = 0.0;
  for (int line = 0; line < 9; ++line)
  {
    const int stepA = line % 3 - 1;
    const int stepB = line / 3 - 1;
    const int middle = 13 + stepA * Strides[a] + stepB * Strides[b];
    const bool hasBefore = !std::isnan(values[middle - Strides[axis]]);
    const bool hasAfter = !std::isnan(values[middle + Strides[axis]]);
    const int first = hasBefore ? middle - Strides[axis] : middle;
    const int last = hasAfter ? middle + Strides[axis] : middle;
    if (first == last || std::isnan(values[first]) || std::isnan(values[last]))
    {
      continue;
    }
    const double weight = (stepA ? this->Side[a] : 1.0) * (stepB ? this->Side[b] : 1.0);
    const double steps = hasBefore && hasAfter ? 2.0 : 1.0;
    sum += weight * ((values[last] - values[first]) / steps);
    weights += weight;
  }
  return weights > 0.0 ? sum / weights / this->Spacing[axis] : 0.0;
}

glm::dvec3 SobelStencil::AtIncomplete(const VoxelBox<double>& scalars, int x, int y, int z) const
{
  if (std::isnan(*scalars.At(x, y, z)))
  {
    return glm::dvec3(0.0);
  }
  double values[27];
  for (int i = 0; i < 27; ++i)
  {
    const int rowY = y + i / 3 % 3 - 1;
    const int rowZ = z + i / 9 - 1;
    values[i] = scalars.HasRow(rowY, rowZ) ? *scalars.At(x + i % 3 - 1, rowY, rowZ) : NoValue<double>();
  }
  return glm::dvec3(this->Along(0, values), this->Along(1, values), this->Along(2, values));
}

// All neighbours are there, or give NaN: sums of rows first, which the compiler vectorises.
bool SobelStencil::FastRow(
  const VoxelBox<double>& scalars, int x0, int x1, int y, int z, glm::dvec3* gradients) const
{
  const double* rows[9];
  for (int i = 0; i < 9; ++i)
  {
    if (!scalars.HasRow(y + i % 3 - 1, z + i / 3 - 1))
    {
      return false;
    }
    rows[i] = scalars.At(x0, y + i % 3 - 1, z + i / 3 - 1) - 1;
  }
  const int length = x1 - x0 + 3;
  static thread_local std::vector<double> sums;
  sums.resize(3 * length);
  double* across = sums.data();
  double* alongY = across + length;
  double* alongZ = alongY + length;
  const double qy = this->Side[1];
  const double qz = this->Side[2];
  for (int i = 0; i < length; ++i)
  {
    const double below = rows[1][i] + qy * (rows[0][i] + rows[2][i]);
    const double middle = rows[4][i] + qy * (rows[3][i] + rows[5][i]);
    const double above = rows[7][i] + qy * (rows[6][i] + rows[8][i]);
    across[i] = middle + qz * (below + above);
    alongZ[i] = above - below;
    alongY[i] = rows[5][i] - rows[3][i] + qz * ((rows[2][i] - rows[0][i]) + (rows[8][i] - rows[6][i]));
  }
  const double qx = this->Side[0];
  const glm::dvec3 scale = glm::dvec3(this->Norm[0], this->Norm[1], this->Norm[2]) / 2.0 / this->Spacing;
  for (int i = 0; i < length - 2; ++i)
  {
    gradients[i].x = (across[i + 2] - across[i]) * scale.x;
    gradients[i].y = (alongY[i + 1] + qx * (alongY[i] + alongY[i + 2])) * scale.y;
    gradients[i].z = (alongZ[i + 1] + qx * (alongZ[i] + alongZ[i + 2])) * scale.z;
  }
  return true;
}

void SobelStencil::Row(
  const VoxelBox<double>& scalars, int x0, int x1, int y, int z, glm::dvec3* gradients) const
{
  const bool isFast = this->FastRow(scalars, x0, x1, y, z, gradients);
  const double* centres = scalars.At(x0, y, z);
  for (int i = 0; i <= x1 - x0; ++i)
  {
    glm::dvec3& gradient = gradients[i];
    const double sum = gradient.x + gradient.y + gradient.z + centres[i];
    if (!isFast || !std::isfinite(sum))
    {
      gradient = this->AtIncomplete(scalars, x0 + i, y, z);
    }
    gradient = this->ToWorld * gradient;
  }
}

NormalAndMagnitude NormalOf(const glm::dvec3& gradient)
{
  const double largest = std::max({ std::abs(gradient.x), std::abs(gradient.y), std::abs(gradient.z) });
  if (!(largest > 0.0) || !std::isfinite(largest))
  {
    return { glm::dvec3(0.0), 0.0 };
  }
  const glm::dvec3 scaled = gradient / largest;
  const double length = std::sqrt(glm::dot(scaled, scaled));
  return { -scaled / length, length * largest };
}
}
