// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkOpticsVolumeMapper
 * @brief VTK's GPU ray caster with the optical models of vtkOpticsVolumeProperty.
 */

#ifndef vtkOpticsVolumeMapper_h
#define vtkOpticsVolumeMapper_h

#include "vtkOpenGLGPUVolumeRayCastMapper.h"
#include "vtkVolumeOpticsModule.h" // for export macro

class VTKVOLUMEOPTICS_EXPORT vtkOpticsVolumeMapper : public vtkOpenGLGPUVolumeRayCastMapper
{
public:
  static vtkOpticsVolumeMapper* New();
  vtkTypeMacro(vtkOpticsVolumeMapper, vtkOpenGLGPUVolumeRayCastMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkOpticsVolumeMapper() = default;
  ~vtkOpticsVolumeMapper() override = default;

private:
  vtkOpticsVolumeMapper(const vtkOpticsVolumeMapper&) = delete;
  void operator=(const vtkOpticsVolumeMapper&) = delete;
};

#endif
