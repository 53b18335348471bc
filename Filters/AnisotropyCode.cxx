// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "AnisotropyCode.h"

#include "Optics.h"

#include <algorithm>
#include <cmath>

namespace volumeoptics
{
int NumberOfCodeComponents(Storage storage)
{
  return storage == Storage::World ? 5 : 3;
}

void EncodeAnisotropy(Storage storage, const glm::dvec3& normal, const glm::dvec2& anisotropy, float* code)
{
  if (storage == Storage::World)
  {
    const optics::WorldTensor tensor = optics::EncodeWorld(normal, anisotropy);
    const double numbers[5] = { tensor.diagonal.x, tensor.diagonal.y, tensor.diagonal.z, tensor.mixed.x,
      tensor.mixed.y };
    std::copy(numbers, numbers + 5, code);
    return;
  }
  const glm::dvec3 numbers =
    storage == Storage::Map ? optics::EncodeMap(normal, anisotropy) : optics::EncodeComponents(anisotropy);
  std::copy(&numbers.x, &numbers.x + 3, code);
}

bool AnisotropyOf(const glm::dvec3& tangentCovariance, glm::dvec2& anisotropy)
{
  const double trace = tangentCovariance.x + tangentCovariance.z;
  if (!(trace > 0.0) || !std::isfinite(trace))
  {
    return false;
  }
  anisotropy = glm::dvec2(tangentCovariance.x - tangentCovariance.z, 2.0 * tangentCovariance.y) / trace;
  // Rounding of a perfect line may exceed 1.
  const double strength = glm::length(anisotropy);
  anisotropy /= std::max(strength, 1.0);
  return true;
}

void MeanOfNeighbours(const VoxelBox<float>& codes, int x, int y, int z, float* code)
{
  const int components = codes.GetComponents();
  const Extent around = Grown({ x, x, y, y, z, z }, { 1, 1, 1 }, codes.GetBox());
  double sums[5] = { 0.0, 0.0, 0.0, 0.0, 0.0 };
  int count = 0;
  for (int nz = around[4]; nz <= around[5]; ++nz)
  {
    for (int ny = around[2]; ny <= around[3]; ++ny)
    {
      for (int nx = around[0]; nx <= around[1]; ++nx)
      {
        const float* neighbour = codes.At(nx, ny, nz);
        const bool isThere = !std::isnan(neighbour[0]);
        count += isThere;
        for (int i = 0; isThere && i < components; ++i)
        {
          sums[i] += neighbour[i];
        }
      }
    }
  }
  std::transform(sums, sums + components, code,
    [count](double sum) { return static_cast<float>(sum / std::max(count, 1)); });
}
}
