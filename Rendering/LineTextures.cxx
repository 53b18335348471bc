// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LineTextures.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtk_glew.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

using volumeoptics::LineChannels;
using volumeoptics::LineCoefficients;
using volumeoptics::LineVoxels;

namespace
{
// The largest of what is stored in 16 bits, a quarter of what these can hold.
const float LargestStored = 16384.0F;

// What is no number counts as nothing; sums of the others, scaled, are finite.
float Finite(float value)
{
  const float largest = 1.0e25F;
  return std::isfinite(value) ? std::clamp(value, -largest, largest) : 0.0F;
}

float LargestOf(const LineCoefficients& set)
{
  float largest = 0.0F;
  for (vtkTypeInt64 i = 0; i < set.GetNumberOfCoefficients() * LineChannels; ++i)
  {
    largest = std::max(largest, std::abs(Finite(set.Values[i])));
  }
  return largest > 0.0F ? largest : 1.0F;
}

}

//------------------------------------------------------------------------------
std::string LineTextures::Upload(vtkImageData* image, int bits, vtkOpenGLRenderWindow* window)
{
  this->Release(window);
  std::string error;
  const LineVoxels voxels(image, error);
  if (!error.empty())
  {
    return "The input holds " + error + ". Connect the output of vtkAnisotropicLineVoxelizer.";
  }
  this->Grid = voxels.Grid;
  this->MaximumOrder = voxels.MaximumOrder;
  error = this->CheckSizes(voxels, window);
  if (!error.empty())
  {
    return error;
  }
  LineAtlas atlas(voxels);
  error = this->CheckAtlas(atlas, window);
  if (error.empty() && !atlas.Voxels.empty())
  {
    this->ReadTypes(voxels, bits);
    this->UploadAtlas(atlas, window);
    this->UploadCoefficients(voxels, atlas.Starts, bits, window);
  }
  return error;
}

//------------------------------------------------------------------------------
std::string LineTextures::CheckSizes(const LineVoxels& voxels, vtkOpenGLRenderWindow* window) const
{
  const long long largest = vtkTextureObject::GetMaximumTextureSize(window);
  const int largest3D = vtkTextureObject::GetMaximumTextureSize3D(window) * LineAtlas::Brick;
  const int largestGrid = std::min(largest3D, 65535);
  const glm::ivec3 size = this->Grid.Dimensions;
  if (std::max({ size.x, size.y, size.z }) > largestGrid)
  {
    return "The anisotropic voxels are more than the " + std::to_string(largestGrid) +
      " on an axis that this OpenGL can draw. Lower SampleDimensions.";
  }
  vtkTypeInt64 coefficients = 0;
  for (const LineCoefficients& set : voxels.Types)
  {
    coefficients += set.GetNumberOfCoefficients();
  }
  if (coefficients > std::min(largest * largest, static_cast<long long>(VTK_INT_MAX)))
  {
    return "The anisotropic voxels have " + std::to_string(coefficients) +
      " coefficients, more than a texture of " + std::to_string(largest) + " x " + std::to_string(largest) +
      " holds. Raise CoefficientTolerance, lower MaximumOrder or SampleDimensions, or draw by "
      "vtkAnisotropicVoxelEvaluator.";
  }
  return "";
}

//------------------------------------------------------------------------------
std::string LineTextures::CheckAtlas(const LineAtlas& atlas, vtkOpenGLRenderWindow* window) const
{
  const int largest = vtkTextureObject::GetMaximumTextureSize(window);
  return std::max(atlas.Size.x, atlas.Size.y) <= std::min(largest, LineAtlas::NoTile - 1)
    ? ""
    : "The " + std::to_string(atlas.Voxels.size()) + " occupied anisotropic voxels need a texture of " +
      std::to_string(atlas.Size.x) + " x " + std::to_string(atlas.Size.y) + ", but this OpenGL has at most " +
      std::to_string(largest) +
      " on an axis. Lower SampleDimensions, or draw by vtkAnisotropicVoxelEvaluator.";
}

//------------------------------------------------------------------------------
template <class Value>
void LineTextures::UploadList(
  TermTexture& texture, std::vector<Value>& values, const Format& format, vtkOpenGLRenderWindow* window)
{
  const long long texels = std::max<long long>(values.size() / format.Channels, 1);
  const int largest = vtkTextureObject::GetMaximumTextureSize(window);
  int width = 1;
  while (width < largest && static_cast<long long>(width) * width < texels)
  {
    width *= 2;
  }
  const glm::ivec2 size(width, (texels + width - 1) / width);
  values.resize(std::size_t(1) * size.x * size.y * format.Channels);
  this->UploadTexels(texture, size, values.data(), format, window);
}

//------------------------------------------------------------------------------
void LineTextures::UploadTexels(TermTexture& texture, const glm::ivec2& size, void* texels,
  const Format& format, vtkOpenGLRenderWindow* window)
{
  texture.Renew(window);
  texture->SetInternalFormat(format.Internal);
  texture->SetFormat(format.External);
  texture->SetDataType(format.Number);
  texture->Create2DFromRaw(size.x, size.y, format.Channels, format.VTKType, texels);
  this->MemorySize += std::size_t(1) * size.x * size.y * format.Bytes;
}

//------------------------------------------------------------------------------
void LineTextures::UploadAtlas(LineAtlas& atlas, vtkOpenGLRenderWindow* window)
{
  this->AtlasSize = atlas.Size;
  this->NumberOfVoxels = static_cast<int>(atlas.Voxels.size());
  this->Bricks.Renew(window);
  this->Bricks->SetInternalFormat(GL_RG16UI);
  this->Bricks->SetFormat(GL_RG_INTEGER);
  this->Bricks->SetDataType(GL_UNSIGNED_SHORT);
  this->Bricks->Create3DFromRaw(
    atlas.Bricks.x, atlas.Bricks.y, atlas.Bricks.z, 2, VTK_UNSIGNED_SHORT, atlas.Tiles.data());
  this->MemorySize += sizeof(std::uint16_t) * atlas.Tiles.size();

  const glm::ivec2 tiles = atlas.Size / glm::ivec2(LineAtlas::Tile * LineAtlas::Tile, LineAtlas::Tile);
  this->UploadTexels(this->Cells, tiles, atlas.Cells.data(),
    { GL_RG32UI, GL_RG_INTEGER, GL_UNSIGNED_INT, 2, VTK_UNSIGNED_INT, 8 }, window);
  const Format numbers = { GL_R32I, GL_RED_INTEGER, GL_INT, 1, VTK_INT, 4 };
  this->UploadTexels(this->Ranks, atlas.Size, atlas.Ranks.data(),
    { GL_R8UI, GL_RED_INTEGER, GL_UNSIGNED_BYTE, 1, VTK_UNSIGNED_CHAR, 1 }, window);
  this->UploadTexels(this->FirstSources, tiles, atlas.FirstSources.data(), numbers, window);
  this->UploadList(this->Sources, atlas.Sources, numbers, window);
  std::vector<std::uint16_t> voxels;
  for (const auto& voxel : atlas.Voxels)
  {
    voxels.insert(voxels.end(), voxel.begin(), voxel.end());
  }
  this->UploadList(this->Voxels, voxels,
    { GL_RGBA16UI, GL_RGBA_INTEGER, GL_UNSIGNED_SHORT, 4, VTK_UNSIGNED_SHORT, 8 }, window);
  this->UploadList(this->Starts, atlas.Starts, numbers, window);
}

//------------------------------------------------------------------------------
void LineTextures::ReadTypes(const LineVoxels& voxels, int bits)
{
  this->Types.clear();
  for (const LineCoefficients& set : voxels.Types)
  {
    const float scale = bits == 32 ? 1.0F : LargestOf(set) / LargestStored;
    this->Types.push_back({ set.Type, scale, glm::vec3(set.LeastColor), glm::vec3(set.LargestColor) });
  }
}

//------------------------------------------------------------------------------
// starts: one after another, of each type in each voxel, and the end.
void LineTextures::UploadCoefficients(
  const LineVoxels& voxels, const std::vector<std::int32_t>& starts, int bits, vtkOpenGLRenderWindow* window)
{
  std::vector<float> texels;
  std::vector<std::uint8_t> harmonics;
  for (std::size_t t = 0; t < this->Types.size(); ++t)
  {
    const LineCoefficients& set = voxels.Types[t];
    const vtkTypeInt64 count = set.GetNumberOfCoefficients();
    harmonics.insert(harmonics.end(), set.Harmonics, set.Harmonics + count);
    for (vtkTypeInt64 i = 0; i < count * LineChannels; ++i)
    {
      texels.push_back(Finite(set.Values[i]) / this->Types[t].Scale);
    }
  }
  this->UploadList(this->Harmonics, harmonics,
    { GL_R8UI, GL_RED_INTEGER, GL_UNSIGNED_BYTE, 1, VTK_UNSIGNED_CHAR, 1 }, window);
  if (bits == 8)
  {
    this->UploadBytes(texels, starts, window);
    return;
  }
  this->UploadList(this->Coefficients, texels,
    { static_cast<unsigned int>(bits == 16 ? GL_RGBA16F : GL_RGBA32F), GL_RGBA, GL_FLOAT, 4, VTK_FLOAT,
      bits / 2 },
    window);
}

//------------------------------------------------------------------------------
// Degree 0, of which most of a voxel's look is made, is kept out of the bytes.
void LineTextures::UploadBytes(
  const std::vector<float>& texels, const std::vector<std::int32_t>& starts, vtkOpenGLRenderWindow* window)
{
  std::vector<std::int8_t> bytes(texels.size(), 0);
  std::vector<float> ranges;
  const std::size_t entries = this->Types.size() * this->NumberOfVoxels;
  for (std::size_t entry = 0; entry < entries; ++entry)
  {
    const std::size_t first = LineChannels * starts[entry], end = LineChannels * starts[entry + 1];
    float largest[LineChannels] = {};
    for (std::size_t i = first + LineChannels; i < end; ++i)
    {
      largest[i % LineChannels] = std::max(largest[i % LineChannels], std::abs(texels[i]));
    }
    for (std::size_t i = first + LineChannels; i < end; ++i)
    {
      const float range = std::max(largest[i % LineChannels], std::numeric_limits<float>::min());
      bytes[i] = static_cast<std::int8_t>(std::lround(127.0F * (texels[i] / range)));
    }
    for (int c = 0; c < LineChannels; ++c)
    {
      ranges.push_back(first < end ? texels[first + c] : 0.0F);
    }
    ranges.insert(ranges.end(), largest, largest + LineChannels);
  }
  this->UploadList(
    this->Coefficients, bytes, { GL_RGBA8_SNORM, GL_RGBA, GL_BYTE, 4, VTK_SIGNED_CHAR, 4 }, window);
  this->UploadList(this->Ranges, ranges, { GL_RGBA16F, GL_RGBA, GL_FLOAT, 4, VTK_FLOAT, 8 }, window);
}

//------------------------------------------------------------------------------
void LineTextures::Release(vtkWindow* window)
{
  for (TermTexture* texture : { &this->Bricks, &this->Cells, &this->Ranks, &this->FirstSources,
         &this->Sources, &this->Voxels, &this->Starts, &this->Harmonics, &this->Coefficients, &this->Ranges })
  {
    texture->Release(window);
  }
  this->MemorySize = 0;
  this->AtlasSize = glm::ivec2(0);
}
