// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// One call lets VTK's own class names give this module's mapper, and another one takes it back; a
// switched-off override leaves other factories as they were.

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
int Failures = 0;

void Check(bool holds, const char* what)
{
  if (!holds)
  {
    std::cout << "Not so: " << what << "\n";
    ++Failures;
  }
}

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
  Check(mapper != nullptr, "there is a mapper");
  const bool isOptics = vtkOpticsVolumeMapper::SafeDownCast(mapper) != nullptr;
  Check(smart->IsOptics() == isOptics, "vtkSmartVolumeMapper uses the same mapper");
  return isOptics;
}
}

int TestOpticsOverride(int, char*[])
{
  Check(!GivesOptics(), "VTK's own mapper is the default");
  Check(!vtkOpticsVolumeMapper::GetGlobalOverride(), "the override is off by default");
  for (int i = 0; i < 2; ++i)
  {
    vtkOpticsVolumeMapper::SetGlobalOverride(true);
    Check(vtkOpticsVolumeMapper::GetGlobalOverride() && GivesOptics(), "the override is on");
    vtkOpticsVolumeMapper::SetGlobalOverride(false);
    Check(!vtkOpticsVolumeMapper::GetGlobalOverride() && !GivesOptics(), "the override is off again");
  }

  Check(!vtkOpticsVolumeMapper::GetDefaultOptics(), "there are no default optics");
  vtkNew<vtkOpticsVolumeProperty> optics;
  vtkOpticsVolumeMapper::SetDefaultOptics(optics);
  Check(vtkOpticsVolumeMapper::GetDefaultOptics() == optics, "default optics are kept");
  vtkOpticsVolumeMapper::SetDefaultOptics(nullptr);
  Check(!vtkOpticsVolumeMapper::GetDefaultOptics(), "default optics are taken back");
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
