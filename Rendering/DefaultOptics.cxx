// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "DefaultOptics.h"

#include "vtkOpticsVolumeProperty.h"
#include "vtkSmartPointer.h"

namespace
{
vtkSmartPointer<vtkOpticsVolumeProperty>& Property()
{
  static vtkSmartPointer<vtkOpticsVolumeProperty> property;
  return property;
}
}

//------------------------------------------------------------------------------
void DefaultOptics::Set(vtkOpticsVolumeProperty* property)
{
  Property() = property;
}

//------------------------------------------------------------------------------
vtkOpticsVolumeProperty* DefaultOptics::Get()
{
  return Property();
}
