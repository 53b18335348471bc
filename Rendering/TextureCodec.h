// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// How numbers are stored in textures of 8, 16 or 32 bits.

#ifndef TextureCodec_h
#define TextureCodec_h

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace volumeoptics
{
// Unsigned codes 0 .. 2 M + 1 of a normalised texture; a signed value v has the code round(M v) + M,
// so that 0 is exact: an isotropic voxel stays isotropic.
template <typename Code>
struct TextureCodec
{
  static constexpr double Largest = std::numeric_limits<Code>::max();
  static constexpr double SignedScale = (Largest - 1.0) / 2.0;
  static Code Signed(double value)
  {
    return static_cast<Code>(
      std::lround(std::clamp(value, -1.0, 1.0) * SignedScale) + std::lround(SignedScale));
  }
  static Code Unsigned(double value)
  {
    return static_cast<Code>(std::lround(std::clamp(value, 0.0, 1.0) * Largest));
  }
};

template <>
struct TextureCodec<float>
{
  static float Signed(double value) { return static_cast<float>(std::clamp(value, -1.0, 1.0)); }
  static float Unsigned(double value) { return static_cast<float>(std::clamp(value, 0.0, 1.0)); }
};

// What a shader multiplies a signed code by, and then adds.
struct SignedTextureCode
{
  explicit SignedTextureCode(int bits)
  {
    const double codes = bits == 8 ? 255.0 : 65535.0;
    this->ScaleAndBias[0] = bits == 32 ? 1.0F : static_cast<float>(2.0 * codes / (codes - 1.0));
    this->ScaleAndBias[1] = bits == 32 ? 0.0F : -1.0F;
  }
  float ScaleAndBias[2];
};
}

#endif
