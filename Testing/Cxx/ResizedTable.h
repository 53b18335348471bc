// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// A 2D transfer function whose opacities VTK itself takes beyond 0 and 1.

#ifndef ResizedTable_h
#define ResizedTable_h

#include "TestScene.h"

namespace
{
// VTK resizes the table's rows to 1024 by a window that overshoots where they change: its opacities are below 0 and above 1.
inline void UseTable2D(TestScene& scene)
{
  vtkNew<vtkImageData> table;
  table->SetDimensions(8, 8, 1);
  table->AllocateScalars(VTK_FLOAT, 4);
  auto* values = static_cast<float*>(table->GetScalarPointer());
  for (int texel = 0; texel < 64; ++texel)
  {
    std::fill(values + 4 * texel, values + 4 * texel + 4, texel / 8 % 4 < 2 ? 1.0F : 0.0F);
  }
  scene.Property->SetTransferFunctionMode(vtkVolumeProperty::TF_2D);
  scene.Property->SetTransferFunction2D(table);
}
}

#endif
