// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkOpticsVolumeMapper.h"

#include "DefaultOptics.h"
#include "OpticsFactory.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkOpticsVolumeMapper);

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::SetGlobalOverride(bool enabled)
{
  OpticsFactory::SetEnabled("vtkGPUVolumeRayCastMapper", enabled);
}

//------------------------------------------------------------------------------
bool vtkOpticsVolumeMapper::GetGlobalOverride()
{
  return OpticsFactory::GetEnabled("vtkGPUVolumeRayCastMapper");
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::SetDefaultOptics(vtkOpticsVolumeProperty* property)
{
  DefaultOptics::Set(property);
}

//------------------------------------------------------------------------------
vtkOpticsVolumeProperty* vtkOpticsVolumeMapper::GetDefaultOptics()
{
  return DefaultOptics::Get();
}
