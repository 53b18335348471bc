// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkDataSpaceRayCastFunction
 * @brief Ray cast function that tells vtkDataSpaceRayIntegrator the gradients, for silhouettes.
 *
 * A vtkUnstructuredGridBunykRayCastFunction, VTK's default, that hands on lengths times the cell's
 * gradient magnitude, the change of the scalar that a ray along the gradient would see. It does so
 * where the mapper's integrator is a vtkDataSpaceRayIntegrator and the volume's property asks for
 * silhouettes, and is its superclass otherwise. Hand it to
 * vtkUnstructuredGridVolumeRayCastMapper::SetRayCastFunction(). Lengths and gradients are the world's:
 * a volume's matrix may scale axes unequally.
 *
 * Source: [Kraus2005] eqs 15 and 17, see Module/References.md.
 *
 * @sa vtkDataSpaceRayIntegrator
 */

#ifndef vtkDataSpaceRayCastFunction_h
#define vtkDataSpaceRayCastFunction_h

#include "vtkUnstructuredGridBunykRayCastFunction.h"
#include "vtkVolumeOpticsModule.h" // for export macro

#include <vector> // for the gradients

class VTKVOLUMEOPTICS_EXPORT vtkDataSpaceRayCastFunction : public vtkUnstructuredGridBunykRayCastFunction
{
public:
  static vtkDataSpaceRayCastFunction* New();
  vtkTypeMacro(vtkDataSpaceRayCastFunction, vtkUnstructuredGridBunykRayCastFunction);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Called by the mapper before it casts rays.
   */
  void Initialize(vtkRenderer* renderer, vtkVolume* volume) override;

  /**
   * Called by the mapper, once a thread.
   */
  VTK_NEWINSTANCE vtkUnstructuredGridVolumeRayCastIterator* NewIterator() override;

  /**
   * Whether the lengths of the current frame are multiplied by gradients.
   */
  vtkGetMacro(MultipliesByGradient, bool);

  /**
   * |grad s| in the world, of a cell; 0 for those that are not drawn.
   */
  double GetGradientMagnitude(vtkIdType cell) const { return this->GradientMagnitudes[cell]; }

  /**
   * World length over the length in the grid's own coordinates, along the ray of a pixel.
   */
  double GetLengthScale(int x, int y) const;

protected:
  vtkDataSpaceRayCastFunction() = default;
  ~vtkDataSpaceRayCastFunction() override = default;

private:
  vtkDataSpaceRayCastFunction(const vtkDataSpaceRayCastFunction&) = delete;
  void operator=(const vtkDataSpaceRayCastFunction&) = delete;

  void ComputeGradientMagnitudes();

  bool MultipliesByGradient = false;
  std::vector<double> GradientMagnitudes;
};

#endif
