// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkLineVoxelView.h"

#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkLineVoxelView);

namespace
{
const int NumberOfTypes = 256;
}

//------------------------------------------------------------------------------
vtkLineVoxelView::vtkLineVoxelView()
{
  vtkNew<vtkCamera> camera;
  this->SetCamera(camera);
}

//------------------------------------------------------------------------------
void vtkLineVoxelView::SetCameraPosition(double x, double y, double z)
{
  this->GetCamera()->SetPosition(x, y, z);
}

//------------------------------------------------------------------------------
void vtkLineVoxelView::SetCameraFocalPoint(double x, double y, double z)
{
  this->GetCamera()->SetFocalPoint(x, y, z);
}

//------------------------------------------------------------------------------
void vtkLineVoxelView::SetParallelProjection(bool parallel)
{
  this->GetCamera()->SetParallelProjection(parallel);
}

//------------------------------------------------------------------------------
void vtkLineVoxelView::SetRadiusScaleOfAll(double scale)
{
  for (int type = 0; type < NumberOfTypes; ++type)
  {
    this->SetRadiusScale(type, scale);
  }
}

//------------------------------------------------------------------------------
void vtkLineVoxelView::SetOpacityScaleOfAll(double scale)
{
  for (int type = 0; type < NumberOfTypes; ++type)
  {
    this->SetOpacityScale(type, scale);
  }
}

//------------------------------------------------------------------------------
void vtkLineVoxelView::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
