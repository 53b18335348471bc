// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FrameTextures.h"

#include "TextureCodec.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkSMPTools.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>

namespace
{
using volumeoptics::TextureCodec;

template <typename Code, typename Channels>
std::vector<Code> Encode(const Channels& channels, vtkIdType voxels)
{
  const std::size_t count = channels.size();
  std::vector<Code> codes(static_cast<std::size_t>(voxels) * count);
  vtkSMPTools::For(0, voxels, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType voxel = begin; voxel < end; ++voxel)
    {
      for (std::size_t i = 0; i < count; ++i)
      {
        const auto& channel = channels[i];
        const double given = channel.Values[voxel * channel.Stride] * channel.Scale;
        const double value = std::isnan(given) ? 0.0 : given;
        codes[voxel * count + i] =
          channel.IsSigned ? TextureCodec<Code>::Signed(value) : TextureCodec<Code>::Unsigned(value);
      }
    }
  });
  return codes;
}

// Index coordinates start at the extent's first voxel, texture coordinates at its outer face.
void ComputeDataToTexture(vtkImageData* grid, double matrix[16])
{
  int extent[6];
  int size[3];
  grid->GetExtent(extent);
  grid->GetDimensions(size);
  vtkNew<vtkMatrix4x4> indexToTexture;
  for (int axis = 0; axis < 3; ++axis)
  {
    indexToTexture->SetElement(axis, axis, 1.0 / size[axis]);
    indexToTexture->SetElement(axis, 3, (0.5 - extent[2 * axis]) / size[axis]);
  }
  vtkMatrix4x4::Multiply4x4(indexToTexture->GetData(), grid->GetPhysicalToIndexMatrix()->GetData(), matrix);
}
}

//------------------------------------------------------------------------------
bool FrameTextures::Update(const FrameGrid& grid, int bits, vtkOpenGLRenderWindow* window)
{
  int size[3];
  grid.Geometry->GetDimensions(size);
  if (*std::max_element(size, size + 3) > vtkTextureObject::GetMaximumTextureSize3D(window))
  {
    return false;
  }
  ComputeDataToTexture(grid.Geometry, this->DataToTexture);
  const auto stamp = [](vtkObject* source) { return Stamp{ source, source ? source->GetMTime() : 0 }; };
  const std::array<Stamp, 4> current = { stamp(window), stamp(grid.Normals), stamp(grid.Magnitude),
    stamp(grid.Anisotropy) };
  // a window's time changes with its size: only which window counts
  std::array<Stamp, 4> stamps = current;
  stamps[0].Time = 0;
  // a new window may have the address of one that took its textures along
  const bool isAlive =
    this->Normals && this->Normals->GetContext() == window && this->Normals->GetHandle() != 0;
  if (isAlive && stamps == this->Uploaded && bits == this->UploadedBits)
  {
    return true;
  }
  this->Bits = bits;
  this->UploadAll(grid, window);
  this->Uploaded = stamps;
  this->UploadedBits = bits;
  return true;
}

//------------------------------------------------------------------------------
void FrameTextures::UploadAll(const FrameGrid& grid, vtkOpenGLRenderWindow* window)
{
  double range[2];
  grid.Magnitude->GetFiniteRange(range);
  this->LargestMagnitude = range[1] > 0.0 ? range[1] : 1.0;

  const float* normals = grid.Normals->GetPointer(0);
  const float* magnitude = grid.Magnitude->GetPointer(0);
  this->Normals =
    this->Upload({ { normals, 3, true, 1.0 }, { normals + 1, 3, true, 1.0 }, { normals + 2, 3, true, 1.0 },
                   { magnitude, 1, false, 1.0 / this->LargestMagnitude } },
      grid, window);

  this->Anisotropy = nullptr;
  this->AnisotropyMixed = nullptr;
  if (!grid.Anisotropy)
  {
    return;
  }
  const int components = grid.Anisotropy->GetNumberOfComponents();
  const float* codes = grid.Anisotropy->GetPointer(0);
  const auto channel = [&](int component) { return Channel{ codes + component, components, true, 1.0 }; };
  this->Anisotropy = this->Upload({ channel(0), channel(1), channel(2) }, grid, window);
  if (components == 5)
  {
    this->AnisotropyMixed = this->Upload({ channel(3), channel(4) }, grid, window);
  }
}

//------------------------------------------------------------------------------
FrameTextures::Texture FrameTextures::Upload(
  const std::vector<Channel>& channels, const FrameGrid& grid, vtkOpenGLRenderWindow* window)
{
  auto texture = Texture::New();
  texture->SetContext(window);
  int size[3];
  grid.Geometry->GetDimensions(size);
  const vtkIdType voxels = grid.Normals->GetNumberOfTuples();
  const int count = static_cast<int>(channels.size());
  const auto create = [&](auto codes, int type) {
    texture->Create3DFromRaw(size[0], size[1], size[2], count, type, codes.data());
  };
  if (this->Bits == 8)
  {
    create(Encode<std::uint8_t>(channels, voxels), VTK_UNSIGNED_CHAR);
  }
  else if (this->Bits == 16)
  {
    create(Encode<std::uint16_t>(channels, voxels), VTK_UNSIGNED_SHORT);
  }
  else
  {
    create(Encode<float>(channels, voxels), VTK_FLOAT);
  }
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  texture->SetWrapR(vtkTextureObject::ClampToEdge);
  texture->SetMinificationFilter(vtkTextureObject::Linear);
  texture->SetMagnificationFilter(vtkTextureObject::Linear);
  return texture;
}

//------------------------------------------------------------------------------
void FrameTextures::SetUniforms(vtkShaderProgram* program, double stepPerRange)
{
  program->SetUniform2f("in_opticsFrameCode", volumeoptics::SignedTextureCode(this->Bits).ScaleAndBias);
  // finite as a float, too
  const double scale = std::min(this->LargestMagnitude * stepPerRange, 1.0e30);
  program->SetUniformf("in_opticsMagnitudeScale", static_cast<float>(scale));

  vtkNew<vtkMatrix4x4> dataToTexture;
  dataToTexture->DeepCopy(this->DataToTexture);
  dataToTexture->Transpose(); // OpenGL reads columns
  program->SetUniformMatrix("in_opticsDataToFrame", dataToTexture);

  const char* const names[] = { "in_opticsNormals", "in_opticsAnisotropy", "in_opticsAnisotropyMixed" };
  const std::vector<Texture> textures = this->GetTextures();
  for (std::size_t i = 0; i < textures.size(); ++i)
  {
    textures[i]->Activate();
    program->SetUniformi(names[i], textures[i]->GetTextureUnit());
  }
}

//------------------------------------------------------------------------------
std::vector<FrameTextures::Texture> FrameTextures::GetTextures() const
{
  std::vector<Texture> textures;
  for (const Texture& texture : { this->Normals, this->Anisotropy, this->AnisotropyMixed })
  {
    if (texture)
    {
      textures.push_back(texture);
    }
  }
  return textures;
}

//------------------------------------------------------------------------------
void FrameTextures::Unbind()
{
  for (const Texture& texture : this->GetTextures())
  {
    texture->Deactivate();
  }
}

//------------------------------------------------------------------------------
void FrameTextures::Release(vtkWindow* window)
{
  for (const Texture& texture : this->GetTextures())
  {
    texture->ReleaseGraphicsResources(window);
  }
  this->Normals = this->Anisotropy = this->AnisotropyMixed = nullptr;
  this->Uploaded = {};
}

//------------------------------------------------------------------------------
std::size_t FrameTextures::GetMemorySize() const
{
  std::size_t bytes = 0;
  for (const Texture& texture : this->GetTextures())
  {
    bytes += std::size_t(1) * texture->GetWidth() * texture->GetHeight() * texture->GetDepth() *
      texture->GetComponents() * this->Bits / 8;
  }
  return bytes;
}
