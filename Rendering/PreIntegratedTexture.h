// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// A vtkPreIntegratedTable of a scene's transfer functions on the GPU: its entries, and the depths behind a
// scalar that transmitted light needs.

#ifndef PreIntegratedTexture_h
#define PreIntegratedTexture_h

#include "OpticsScene.h"
#include "TermTexture.h"
#include "vtkPreIntegratedTable.h"

#include "vtkColorTransferFunction.h"
#include "vtkNew.h"

class vtkShaderProgram;
class vtkWindow;

class PreIntegratedTexture
{
public:
  /** After VTK has loaded the volume. Builds and uploads what has changed. */
  void Update(const OpticsScene& scene);
  void SetUniforms(const OpticsScene& scene, vtkShaderProgram* program);
  void Unbind();
  void Release(vtkWindow* window);
  std::size_t GetMemorySize() const;

private:
  void SetFunctions(const OpticsScene& scene);
  vtkColorTransferFunction* ColorInRange(const OpticsScene& scene, const double range[2]);
  void UploadEntries(const OpticsScene& scene);
  void UploadDepths(const OpticsScene& scene);

  vtkNew<vtkPreIntegratedTable> Table;
  vtkNew<vtkColorTransferFunction> Stretched;
  TermTexture Texture;
  TermTexture DepthsBehind;
  vtkMTimeType UploadedTime = 0;
  int UploadedBits = 0;
  double LargestAttenuation = 0.0;
};

#endif
