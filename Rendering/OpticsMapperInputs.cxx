// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// What the mapper is given beside the volume and hands on, and what it tells of its terms.

#include "OpticsTerms.h"

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::SetOptics(vtkOpticsVolumeProperty* optics)
{
  if (this->Terms->Optics != optics)
  {
    this->Terms->Optics = optics;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkOpticsVolumeProperty* vtkOpticsVolumeMapper::GetOptics()
{
  return this->Terms->Optics;
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::SetNormalsInputConnection(vtkAlgorithmOutput* output)
{
  this->Terms->Frames.Provider.NormalsInput = FrameProvider::Connection(output);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::SetNormalsInputData(vtkImageData* normals)
{
  this->Terms->Frames.Provider.NormalsInput = FrameProvider::Connection(normals);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::SetAnisotropyInputConnection(vtkAlgorithmOutput* output)
{
  this->Terms->Frames.Provider.AnisotropyInput = FrameProvider::Connection(output);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::SetAnisotropyInputData(vtkImageData* anisotropy)
{
  this->Terms->Frames.Provider.AnisotropyInput = FrameProvider::Connection(anisotropy);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::SetLineBlockInputConnection(vtkAlgorithmOutput* output)
{
  this->Terms->Lines.BlockInput = FrameProvider::Connection(output);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::SetLineBlockInputData(vtkImageData* voxels)
{
  this->Terms->Lines.BlockInput = FrameProvider::Connection(voxels);
  this->Modified();
}

//------------------------------------------------------------------------------
vtkImageData* vtkOpticsVolumeMapper::GetLineBlock()
{
  return this->Terms->Lines.GetBlock();
}

//------------------------------------------------------------------------------
vtkSobelNormalFilter* vtkOpticsVolumeMapper::GetSobelNormalFilter()
{
  return this->Terms->Frames.Provider.Sobel;
}

//------------------------------------------------------------------------------
vtkAmbientCovarianceFilter* vtkOpticsVolumeMapper::GetAmbientCovarianceFilter()
{
  return this->Terms->Frames.Provider.Covariance;
}

//------------------------------------------------------------------------------
vtkPrincipalCurvatureFilter* vtkOpticsVolumeMapper::GetPrincipalCurvatureFilter()
{
  return this->Terms->Frames.Provider.Curvature;
}

//------------------------------------------------------------------------------
vtkVisibilitySweep* vtkOpticsVolumeMapper::GetOcclusionSweep()
{
  return this->Terms->Occlusion.GetSweep();
}

//------------------------------------------------------------------------------
int vtkOpticsVolumeMapper::GetShadowSweepCount()
{
  return this->Terms->Shadows.GetSweepCount();
}

//------------------------------------------------------------------------------
std::string vtkOpticsVolumeMapper::GetActiveTerms()
{
  return this->Terms->ActiveTerms;
}

//------------------------------------------------------------------------------
unsigned long vtkOpticsVolumeMapper::GetTermMemorySize()
{
  std::size_t bytes = 0;
  for (OpticsTerm* term : this->Terms->All)
  {
    bytes += term->GetMemorySize();
  }
  return static_cast<unsigned long>((bytes + 1023) / 1024);
}

//------------------------------------------------------------------------------
int vtkOpticsVolumeMapper::GetProgramLinkCount()
{
  return this->Terms->Pass->GetProgramLinkCount();
}

//------------------------------------------------------------------------------
std::string vtkOpticsVolumeMapper::GetFragmentShader()
{
  return this->Terms->Pass->GetFragmentShader();
}
