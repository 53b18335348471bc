// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// One call lets VTK's own class names give this module's mapper, and another one takes it back; a
// switched-off override leaves other factories as they were.

#include "Check.h"

#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpticsVolumeMapper.h"
#include "vtkOpticsVolumeProperty.h"
#include "vtkSmartPointer.h"
#include "vtkSmartVolumeMapper.h"

#include <cstdlib>
#include <iostream>

namespace
{
Check check;

// vtkSmartVolumeMapper makes its own ray caster.
class SmartMapper : public vtkSmartVolumeMapper
{
public:
  static SmartMapper* New();
  vtkTypeMacro(SmartMapper, vtkSmartVolumeMapper);
  bool IsOptics() { return vtkOpticsVolumeMapper::SafeDownCast(this->GPUMapper) != nullptr; }
};
vtkStandardNewMacro(SmartMapper);

bool GivesOptics()
{
  auto mapper = vtkSmartPointer<vtkGPUVolumeRayCastMapper>::New();
  vtkNew<SmartMapper> smart;
  check.That(mapper != nullptr, "there is a mapper");
  const bool isOptics = vtkOpticsVolumeMapper::SafeDownCast(mapper) != nullptr;
  check.That(smart->IsOptics() == isOptics, "vtkSmartVolumeMapper uses the same mapper");
  return isOptics;
}
}

int TestOpticsOverride(int, char*[])
{
  check.That(!GivesOptics(), "VTK's own mapper is the default");
  check.That(!vtkOpticsVolumeMapper::GetGlobalOverride(), "the override is off by default");
  for (int i = 0; i < 2; ++i)
  {
    vtkOpticsVolumeMapper::SetGlobalOverride(true);
    check.That(vtkOpticsVolumeMapper::GetGlobalOverride() && GivesOptics(), "the override is on");
    vtkOpticsVolumeMapper::SetGlobalOverride(false);
    check.That(!vtkOpticsVolumeMapper::GetGlobalOverride() && !GivesOptics(), "the override is off again");
  }

  check.That(!vtkOpticsVolumeMapper::GetDefaultOptics(), "there are no default optics");
  vtkNew<vtkOpticsVolumeProperty> optics;
  vtkOpticsVolumeMapper::SetDefaultOptics(optics);
  check.That(vtkOpticsVolumeMapper::GetDefaultOptics() == optics, "default optics are kept");
  vtkOpticsVolumeMapper::SetDefaultOptics(nullptr);
  check.That(!vtkOpticsVolumeMapper::GetDefaultOptics(), "default optics are taken back");
  return check.ExitCode();
}
