// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PreIntegratedTexture.h"

#include "RayUniforms.h"
#include "SceneNeeds.h"
#include "TransferFunctionTerm.h"
#include "vtkOpticsVolumeMapper.h"
#include "vtkOpticsVolumeProperty.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkPiecewiseFunction.h"
#include "vtkShaderProgram.h"
#include "vtkVolume.h"
#include "vtk_glew.h"

#include <algorithm>
#include <vector>

namespace
{
bool AreEqual(vtkColorTransferFunction* a, vtkColorTransferFunction* b)
{
  bool isEqual = a->GetSize() == b->GetSize() && a->GetColorSpace() == b->GetColorSpace() &&
    a->GetClamping() == b->GetClamping();
  for (int i = 0; isEqual && i < a->GetSize(); ++i)
  {
    double nodes[2][6];
    a->GetNodeValue(i, nodes[0]);
    b->GetNodeValue(i, nodes[1]);
    isEqual = std::equal(nodes[0], nodes[0] + 6, nodes[1]);
  }
  return isEqual;
}
}

//------------------------------------------------------------------------------
void PreIntegratedTexture::SetFunctions(const OpticsScene& scene)
{
  vtkVolumeProperty* property = scene.Volume->GetProperty();
  double range[2];
  TransferFunctionTerm::GetOpacityRange(scene, range);
  this->Table->SetRange(range);
  this->Table->SetOpacityFunction(property->GetScalarOpacity());
  this->Table->SetColorFunction(this->ColorInRange(scene, range));
  this->Table->SetSize(scene.Mapper->GetPreIntegrationTableSize());
  this->Table->SetUnitInterval(scene.Optics->GetScalarOpacityUnitInterval());
  this->Table->SetSegmentLength(
    IntegratesInData(scene) ? 0.0 : scene.Mapper->GetFrameSampleDistance(scene.Volume) / UnitDistance(scene));
}

//------------------------------------------------------------------------------
// VTK stretches the functions over the range of the scalars, each as its own range type says: the table's
// colour function is the one that has the colours at the opacity function's scalars.
vtkColorTransferFunction* PreIntegratedTexture::ColorInRange(const OpticsScene& scene, const double range[2])
{
  vtkColorTransferFunction* source = scene.Volume->GetProperty()->GetRGBTransferFunction();
  double from[2];
  TransferFunctionTerm::GetColorRange(scene, from);
  const bool isSame = (from[0] == range[0] && from[1] == range[1]) || !(from[1] > from[0]);
  if (isSame)
  {
    return source;
  }
  vtkNew<vtkColorTransferFunction> stretched;
  stretched->DeepCopy(source);
  stretched->RemoveAllPoints();
  const double stretch = (range[1] - range[0]) / (from[1] - from[0]);
  for (int i = 0; i < source->GetSize(); ++i)
  {
    double node[6];
    source->GetNodeValue(i, node);
    stretched->AddRGBPoint(
      range[0] + (node[0] - from[0]) * stretch, node[1], node[2], node[3], node[4], node[5]);
  }
  if (!AreEqual(stretched, this->Stretched))
  {
    this->Stretched->DeepCopy(stretched);
  }
  return this->Stretched;
}

//------------------------------------------------------------------------------
void PreIntegratedTexture::Update(const OpticsScene& scene)
{
  this->SetFunctions(scene);
  this->Table->Update();
  const int bits = scene.Mapper->GetTablePrecision();
  if (!this->Texture.IsAlive(scene.Window) || this->UploadedTime != this->Table->GetBuildTime() ||
    this->UploadedBits != bits)
  {
    this->UploadedTime = this->Table->GetBuildTime();
    this->UploadedBits = bits;
    this->UploadEntries(scene);
    this->UploadDepths(scene);
  }
}

//------------------------------------------------------------------------------
// Without a table there is one clear entry.
void PreIntegratedTexture::UploadEntries(const OpticsScene& scene)
{
  const float* entries = this->Table->GetEntries();
  const int size = entries ? this->Table->GetSize() : 1;
  std::vector<float> texels(std::size_t(4) * size * size);
  this->LargestAttenuation = this->Table->GetLargestMean();
  const double scale = this->LargestAttenuation > 0.0 ? 1.0 / this->LargestAttenuation : 0.0;
  for (std::size_t i = 0; entries && i < texels.size(); ++i)
  {
    texels[i] = i % 4 == 3 ? static_cast<float>(entries[i] * scale) : entries[i];
  }
  this->Texture.Renew(scene.Window);
  this->Texture->SetInternalFormat(this->UploadedBits == 16 ? GL_RGBA16F : GL_RGBA32F);
  this->Texture->Create2DFromRaw(size, size, 4, VTK_FLOAT, texels.data());
  this->Texture.Interpolate();
}

//------------------------------------------------------------------------------
void PreIntegratedTexture::UploadDepths(const OpticsScene& scene)
{
  const float* depths = this->Table->GetDepthsBehind();
  const int size = depths ? this->Table->GetSize() : 1;
  std::vector<float> texels(std::size_t(2) * size);
  if (depths)
  {
    std::copy(depths, depths + texels.size(), texels.begin());
  }
  this->DepthsBehind.Renew(scene.Window);
  this->DepthsBehind->Create1DFromRaw(size, 2, VTK_FLOAT, texels.data());
  this->DepthsBehind.Interpolate();
}

//------------------------------------------------------------------------------
void PreIntegratedTexture::SetUniforms(const OpticsScene& scene, vtkShaderProgram* program)
{
  const float size = static_cast<float>(this->Texture->GetWidth());
  if (IsPreIntegrated(scene))
  {
    this->Texture.Bind("in_opticsSegmentTable", program);
    program->SetUniformf("in_opticsSegmentTableSize", size);
    program->SetUniformf("in_opticsLargestAttenuation", static_cast<float>(this->LargestAttenuation));
  }
  if (TransmitsLight(scene))
  {
    this->DepthsBehind.Bind("in_opticsDepthsBehind", program);
    program->SetUniformf("in_opticsDepthsBehindSize", size);
  }
}

//------------------------------------------------------------------------------
void PreIntegratedTexture::Unbind()
{
  this->Texture.Unbind();
  this->DepthsBehind.Unbind();
}

//------------------------------------------------------------------------------
void PreIntegratedTexture::Release(vtkWindow* window)
{
  this->Texture.Release(window);
  this->DepthsBehind.Release(window);
}

//------------------------------------------------------------------------------
std::size_t PreIntegratedTexture::GetMemorySize() const
{
  if (!this->Texture)
  {
    return 0;
  }
  const std::size_t size = this->Texture->GetWidth();
  return 4 * size * size * this->UploadedBits / 8 + 2 * size * sizeof(float);
}
