// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkOpticsVolumeMapper.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkOpticsVolumeMapper);

//------------------------------------------------------------------------------
void vtkOpticsVolumeMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
