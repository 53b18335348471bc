// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The optics of volumes whose property is a plain vtkVolumeProperty.

#ifndef DefaultOptics_h
#define DefaultOptics_h

class vtkOpticsVolumeProperty;

namespace DefaultOptics
{
/** Null, the initial value, leaves such volumes to VTK's own model. */
void Set(vtkOpticsVolumeProperty* property);
vtkOpticsVolumeProperty* Get();
}

#endif
