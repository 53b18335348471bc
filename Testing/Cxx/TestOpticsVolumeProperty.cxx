// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The property: defaults, ranges, copies.

#include "vtkNew.h"
#include "vtkOpticsVolumeProperty.h"

#include <cstdlib>

int TestOpticsVolumeProperty(int, char*[])
{
  vtkNew<vtkOpticsVolumeProperty> property;
  property->SetReflectanceModelToWard();
  return property->GetGlossiness() == 0.2 ? EXIT_SUCCESS : EXIT_FAILURE;
}
