// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LightingTableTexture.h"

#include "TextureCodec.h"
#include "vtkLightingTransferFunction.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkPiecewiseFunction.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace
{
// Light changes sides over this share of the largest difference of densities in the table.
const float FadeShare = 1.0F / 16.0F;

bool IsSame(const LightingTableTexture::Request& a, const LightingTableTexture::Request& b)
{
  return a.Function == b.Function && a.Density == b.Density && a.Range[0] == b.Range[0] &&
    a.Range[1] == b.Range[1] && a.Size == b.Size && a.Bits == b.Bits;
}

vtkMTimeType TimeOf(const LightingTableTexture::Request& request)
{
  const vtkMTimeType time = request.Function->GetMTime();
  return request.Density ? std::max(time, request.Density->GetMTime()) : time;
}

template <typename Code>
std::vector<Code> Encode(const std::vector<float>& rgba)
{
  using Codec = volumeoptics::TextureCodec<Code>;
  std::vector<Code> codes(rgba.size());
  for (std::size_t i = 0; i < rgba.size(); ++i)
  {
    codes[i] = i % 4 == 3 ? Codec::Signed(rgba[i]) : Codec::Unsigned(rgba[i]);
  }
  return codes;
}

float LargestFourth(const std::vector<float>& rgba)
{
  float largest = 0.0F;
  for (std::size_t i = 3; i < rgba.size(); i += 4)
  {
    largest = std::max(largest, std::abs(rgba[i]));
  }
  return largest;
}
}

//------------------------------------------------------------------------------
void LightingTableTexture::Update(const Request& request, vtkOpenGLRenderWindow* window)
{
  const vtkMTimeType time = TimeOf(request);
  if (this->Texture.IsAlive(window) && IsSame(request, this->Uploaded) && time == this->UploadedTime)
  {
    return;
  }
  this->Upload(request, window);
  this->Uploaded = request;
  this->UploadedTime = time;
}

//------------------------------------------------------------------------------
void LightingTableTexture::Upload(const Request& request, vtkOpenGLRenderWindow* window)
{
  std::vector<float> rgba;
  request.Function->GetTable(request.Range, request.Size, rgba, request.Density);
  this->LargestDifference = LargestFourth(rgba);
  this->Texture.Renew(window);
  const auto create = [&](auto codes, int type) {
    this->Texture->Create2DFromRaw(request.Size, request.Size, 4, type, codes.data());
  };
  if (request.Bits == 16)
  {
    create(Encode<std::uint16_t>(rgba), VTK_UNSIGNED_SHORT);
  }
  else
  {
    create(rgba, VTK_FLOAT);
  }
  this->Texture.Interpolate();
}

//------------------------------------------------------------------------------
void LightingTableTexture::SetUniforms(vtkShaderProgram* program)
{
  program->SetUniform2f(
    "in_opticsLightingTableCode", volumeoptics::SignedTextureCode(this->Uploaded.Bits).ScaleAndBias);
  program->SetUniformf("in_opticsDensityFade", std::max(FadeShare * this->LargestDifference, 1.0e-6F));
  this->Texture.Bind("in_opticsLightingTable", program);
}

//------------------------------------------------------------------------------
std::size_t LightingTableTexture::GetMemorySize() const
{
  return this->Texture ? std::size_t(4) * this->Uploaded.Size * this->Uploaded.Size * this->Uploaded.Bits / 8
                       : 0;
}
