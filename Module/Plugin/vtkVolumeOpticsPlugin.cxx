// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The module as a VTK plugin. VTK loads every library in the folders of VTK_AUTOLOAD_PATH when it
// makes its first factory; from then on vtkGPUVolumeRayCastMapper::New() gives vtkOpticsVolumeMapper,
// in programs that know nothing of this module. VOLUMEOPTICS_PRESET names the JSON file of the optics
// of their plain vtkVolumeProperty objects, and VOLUMEOPTICS_HEADLESS renders without a display.

#include "vtkHeadlessRenderWindow.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpticsPreset.h"
#include "vtkOpticsVolumeMapper.h"
#include "vtkOpticsVolumeProperty.h"
#include "vtkVersion.h"

#include <cstdlib>

// VTK 9.2 made some functions const, and later ones have the name of it.
#ifndef VTK_FUTURE_CONST
#define VTK_FUTURE_CONST
#endif

// What VTK asks of a plugin. The overrides themselves are in the module's own factory, which puts
// itself before VTK's; this one is appended by VTK and would come too late.
class vtkVolumeOpticsPlugin : public vtkObjectFactory
{
public:
  static vtkVolumeOpticsPlugin* New();
  vtkTypeMacro(vtkVolumeOpticsPlugin, vtkObjectFactory);
  const char* GetVTKSourceVersion() VTK_FUTURE_CONST override { return VTK_SOURCE_VERSION; }
  const char* GetDescription() VTK_FUTURE_CONST override { return "VolumeOptics plugin"; }

protected:
  vtkVolumeOpticsPlugin()
  {
    vtkOpticsVolumeMapper::SetGlobalOverride(true);
    vtkHeadlessRenderWindow::SetGlobalOverrideFromEnvironment();
    const char* preset = std::getenv("VOLUMEOPTICS_PRESET");
    vtkNew<vtkOpticsVolumeProperty> optics;
    if (preset && *preset && vtkOpticsPreset::Read(preset, optics))
    {
      vtkOpticsVolumeMapper::SetDefaultOptics(optics);
    }
  }
};
vtkStandardNewMacro(vtkVolumeOpticsPlugin);

VTK_FACTORY_INTERFACE_IMPLEMENT(vtkVolumeOpticsPlugin);
