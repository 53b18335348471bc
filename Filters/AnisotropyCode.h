// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Anisotropies as numbers of a voxel: encoding, missing voxels, precision.

#ifndef AnisotropyCode_h
#define AnisotropyCode_h

#include "VoxelBox.h"

#include <cmath>

namespace volumeoptics
{
// As vtkAnisotropyFilter::StorageType.
enum class Storage
{
  Map,
  Components,
  World
};

int NumberOfCodeComponents(Storage storage);

// normal: unit. anisotropy: (Ctt - Cpp, 2 Ctp)/(Ctt + Cpp). code: 3 numbers, World 5: xx yy xy xz yz.
void EncodeAnisotropy(Storage storage, const glm::dvec3& normal, const glm::dvec2& anisotropy, float* code);

// From (Ctt, Ctp, Cpp); false if the trace gives none.
bool AnisotropyOf(const glm::dvec3& tangentCovariance, glm::dvec2& anisotropy);

// The voxel's own code or, if it is missing (first number NaN), the mean of those of its 26
// neighbours that have one, 0 if none: a voxel without an estimate must not pass as isotropic.
void MeanOfNeighbours(const VoxelBox<float>& codes, int x, int y, int z, float* code);

inline void CodeOrMeanOfNeighbours(const VoxelBox<float>& codes, int x, int y, int z, float* code)
{
  const float* own = codes.At(x, y, z);
  if (std::isnan(own[0]))
  {
    MeanOfNeighbours(codes, x, y, z, code);
  }
  else
  {
    std::copy(own, own + codes.GetComponents(), code);
  }
}

// The nearest number that a signed normalised integer of this many bits stores: round(127 a)/127,
// round(32767 a)/32767; 32 bits: the number itself.
inline float RoundedToBits(float value, int bits)
{
  const float largest = bits == 8 ? 127.0f : 32767.0f;
  return bits >= 32 ? value : std::round(std::clamp(value, -1.0f, 1.0f) * largest) / largest;
}
}

#endif
