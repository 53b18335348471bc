// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LineTextures.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtk_glew.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

using volumeoptics::LineCoefficients;
using volumeoptics::LineVoxels;

namespace
{
constexpr int Depth = 3; // the channel
constexpr int Product = 4;

// The largest of what is stored in 16 bits, a quarter of what these can hold.
const float LargestStored = 16384.0F;

vtkTypeInt64 CountOf(const LineCoefficients& set, int bricks)
{
  return set.VoxelStarts[set.BrickStarts[bricks]];
}

float LargestOf(const LineCoefficients& set, vtkTypeInt64 count)
{
  float largest = 0.0F;
  for (vtkTypeInt64 i = 0; i < count * set.Channels; ++i)
  {
    largest = std::isfinite(set.Values[i]) ? std::max(largest, std::abs(set.Values[i])) : largest;
  }
  return largest > 0.0F ? largest : 1.0F;
}

float Finite(float value)
{
  return std::isfinite(value) ? value : 0.0F;
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
  const int* last = std::max_element(voxels.BrickIndices, voxels.BrickIndices + voxels.Grid.NumberOfBricks());
  this->NumberOfOccupiedBricks = *last + 1;
  this->Atlas = LineAtlas(voxels);
  error = this->CheckSizes(voxels, window);
  if (error.empty() && !this->Atlas.Tiles.empty())
  {
    this->UploadBricks(voxels, window);
    this->UploadTiles(window);
    this->UploadStarts(voxels, window);
    this->UploadCoefficients(voxels, bits, window);
  }
  return error;
}

//------------------------------------------------------------------------------
std::string LineTextures::CheckSizes(const LineVoxels& voxels, vtkOpenGLRenderWindow* window) const
{
  const long long largest = vtkTextureObject::GetMaximumTextureSize(window);
  const long long largest3D = vtkTextureObject::GetMaximumTextureSize3D(window);
  const glm::ivec3 bricks = this->Grid.Bricks();
  if (std::max({ bricks.x, bricks.y, bricks.z }) > largest3D)
  {
    return "The anisotropic voxels have more than the " + std::to_string(largest3D) +
      " bricks on an axis that a texture of this OpenGL holds. Lower SampleDimensions.";
  }
  const glm::ivec2 atlas = this->Atlas.Size();
  vtkTypeInt64 coefficients = 0;
  for (const LineCoefficients& set : voxels.Types)
  {
    coefficients += CountOf(set, this->NumberOfOccupiedBricks);
  }
  const long long starts =
    static_cast<long long>(voxels.Types.size()) * this->NumberOfOccupiedBricks * this->Grid.VoxelsOfBrick() +
    1;
  const long long most = std::min(largest * largest, static_cast<long long>(VTK_INT_MAX));
  if (std::max(atlas.x, atlas.y) > largest || coefficients > most || starts > most)
  {
    return "The anisotropic voxels have " + std::to_string(coefficients) + " coefficients in " +
      std::to_string(this->NumberOfOccupiedBricks) + " occupied bricks, more than textures of " +
      std::to_string(largest) + " x " + std::to_string(largest) +
      " hold. Raise CoefficientTolerance, lower MaximumOrder or SampleDimensions, or draw by "
      "vtkAnisotropicVoxelEvaluator.";
  }
  return "";
}

//------------------------------------------------------------------------------
template <class Value>
void LineTextures::UploadList(
  TermTexture& texture, std::vector<Value> values, const Format& format, vtkOpenGLRenderWindow* window)
{
  const long long texels = std::max<long long>(values.size() / format.Channels, 1);
  const int largest = vtkTextureObject::GetMaximumTextureSize(window);
  int width = 1;
  while (width < largest && static_cast<long long>(width) * width < texels)
  {
    width *= 2;
  }
  const long long height = (texels + width - 1) / width;
  values.resize(static_cast<std::size_t>(width * height * format.Channels));
  texture.Renew(window);
  texture->SetInternalFormat(format.Internal);
  texture->SetFormat(format.External);
  texture->SetDataType(format.Number);
  texture->Create2DFromRaw(
    width, static_cast<unsigned int>(height), format.Channels, format.VTKType, values.data());
  this->MemorySize += static_cast<std::size_t>(width * height * format.Bytes);
}

//------------------------------------------------------------------------------
void LineTextures::UploadBricks(const LineVoxels& voxels, vtkOpenGLRenderWindow* window)
{
  const long long count = this->Grid.NumberOfBricks();
  std::vector<float> texels(3 * count, -1.0F);
  for (std::size_t tile = 0; tile < this->Atlas.Tiles.size(); ++tile)
  {
    const glm::vec2 texel = this->Atlas.TexelOf(static_cast<long long>(tile));
    texels[3 * this->Atlas.Tiles[tile]] = texel.x;
    texels[3 * this->Atlas.Tiles[tile] + 1] = texel.y;
  }
  for (long long brick = 0; brick < count; ++brick)
  {
    texels[3 * brick + 2] = static_cast<float>(voxels.BrickIndices[brick]);
  }
  const glm::ivec3 size = this->Grid.Bricks();
  this->Bricks.Renew(window);
  this->Bricks->Create3DFromRaw(size.x, size.y, size.z, 3, VTK_FLOAT, texels.data());
  this->MemorySize += sizeof(float) * texels.size();
}

//------------------------------------------------------------------------------
void LineTextures::UploadTiles(vtkOpenGLRenderWindow* window)
{
  std::vector<float> voxels;
  for (const long long brick : this->Atlas.Tiles)
  {
    const glm::vec3 first = this->Grid.FirstVoxelOf(brick);
    voxels.insert(voxels.end(), { first.x, first.y, first.z });
  }
  this->UploadList(this->Tiles, voxels, { GL_RGB32F, GL_RGB, GL_FLOAT, 3, VTK_FLOAT, 12 }, window);
}

//------------------------------------------------------------------------------
// A voxel without lines starts where the next one does.
void LineTextures::UploadStarts(const LineVoxels& voxels, vtkOpenGLRenderWindow* window)
{
  std::vector<std::int32_t> starts;
  vtkTypeInt64 before = 0; // coefficients of the types before this one
  for (const LineCoefficients& set : voxels.Types)
  {
    for (int brick = 0; brick < this->NumberOfOccupiedBricks; ++brick)
    {
      vtkTypeInt64 voxel = set.BrickStarts[brick];
      for (int place = 0; place < this->Grid.VoxelsOfBrick(); ++place)
      {
        starts.push_back(static_cast<std::int32_t>(before + set.VoxelStarts[voxel]));
        voxel += voxel < set.BrickStarts[brick + 1] && set.Places[voxel] == place ? 1 : 0;
      }
    }
    before += CountOf(set, this->NumberOfOccupiedBricks);
  }
  starts.push_back(static_cast<std::int32_t>(before));
  this->UploadList(this->Starts, starts, { GL_R32I, GL_RED_INTEGER, GL_INT, 1, VTK_INT, 4 }, window);
}

//------------------------------------------------------------------------------
void LineTextures::UploadCoefficients(const LineVoxels& voxels, int bits, vtkOpenGLRenderWindow* window)
{
  this->Types.clear();
  this->HasProduct = false;
  for (const LineCoefficients& set : voxels.Types)
  {
    const float largest = LargestOf(set, CountOf(set, this->NumberOfOccupiedBricks));
    this->Types.push_back({ set.Type, bits == 32 ? 1.0F : largest / LargestStored, glm::vec3(set.LeastColor),
      glm::vec3(set.LargestColor) });
    this->HasProduct = this->HasProduct || set.Channels > Product;
  }
  std::vector<float> texels, products;
  std::vector<std::uint8_t> harmonics;
  for (std::size_t t = 0; t < this->Types.size(); ++t)
  {
    const LineCoefficients& set = voxels.Types[t];
    const vtkTypeInt64 count = CountOf(set, this->NumberOfOccupiedBricks);
    harmonics.insert(harmonics.end(), set.Harmonics, set.Harmonics + count);
    for (vtkTypeInt64 i = 0; i < count; ++i)
    {
      const float* values = set.Values + i * set.Channels;
      for (int channel = 0; channel <= Depth; ++channel)
      {
        texels.push_back(Finite(values[channel]) / this->Types[t].Scale);
      }
      if (this->HasProduct)
      {
        products.push_back(Finite(values[std::min(set.Channels - 1, Product)]) / this->Types[t].Scale);
      }
    }
  }
  const bool isHalf = bits == 16;
  this->UploadList(this->Harmonics, harmonics,
    { GL_R8UI, GL_RED_INTEGER, GL_UNSIGNED_BYTE, 1, VTK_UNSIGNED_CHAR, 1 }, window);
  this->UploadList(this->Coefficients, texels,
    { static_cast<unsigned int>(isHalf ? GL_RGBA16F : GL_RGBA32F), GL_RGBA, GL_FLOAT, 4, VTK_FLOAT,
      bits / 2 },
    window);
  if (this->HasProduct)
  {
    this->UploadList(this->Products, products,
      { static_cast<unsigned int>(isHalf ? GL_R16F : GL_R32F), GL_RED, GL_FLOAT, 1, VTK_FLOAT, bits / 8 },
      window);
  }
}

//------------------------------------------------------------------------------
void LineTextures::Release(vtkWindow* window)
{
  for (TermTexture* texture :
    { &this->Bricks, &this->Tiles, &this->Starts, &this->Harmonics, &this->Coefficients, &this->Products })
  {
    texture->Release(window);
  }
  this->MemorySize = 0;
}
