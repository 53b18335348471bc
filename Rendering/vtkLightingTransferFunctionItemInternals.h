// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef vtkLightingTransferFunctionItemInternals_h
#define vtkLightingTransferFunctionItemInternals_h

#include "LightingEditor.h"
#include "LightingEditorPanels.h"
#include "LightingEditorPictures.h"
#include "vtkLightingTransferFunctionItem.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"

class vtkLightingTransferFunctionItem::Internals
{
public:
  volumeoptics::LightingEditor Editor;
  volumeoptics::LightingEditorPanels Panels;
  volumeoptics::LightingEditorPictures Pictures;
  vtkNew<vtkCallbackCommand> Observer;
};

#endif
