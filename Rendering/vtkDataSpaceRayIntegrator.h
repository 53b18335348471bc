// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkDataSpaceRayIntegrator
 * @brief The volume rendering integral in data space, for VTK's ray caster of unstructured grids.
 *
 * Attenuation and colour belong to a change of the scalar, not to a length: what a ray sees of a cell
 * depends on the scalars where it enters and leaves it alone, not on the cell's size or the gradient.
 * Cells in which the scalar is constant are not seen; so a grid with cell scalars shows nothing, and
 * the integrator says so (vtkCellDataToPointData is the remedy). Hand it to
 * vtkUnstructuredGridVolumeRayCastMapper::SetRayIntegrator().
 *
 * The volume's property gives the transfer functions: an opacity is that of crossing the unit interval
 * of data (vtkOpticsVolumeProperty::SetScalarOpacityUnitInterval(); a hundredth of the opacity
 * function's range for a plain vtkVolumeProperty). A vtkOpticsVolumeProperty also gives isosurfaces of
 * exact opacity, and silhouettes. Silhouettes need the gradient of each cell, which VTK's own ray cast
 * function does not hand on: hand a vtkDataSpaceRayCastFunction to the mapper, too. Without it the
 * integrator says so once, and draws without silhouettes. Whatever the property's integration space,
 * this class integrates in data space. Independent components only; the first one is drawn.
 *
 * VTK's mapper stores what it draws in 8 bits, rounded down, and interpolates integer scalars in their
 * own type: convert them to float for a smooth picture.
 *
 * Source: [Kraus2005] section 3, see Module/References.md.
 *
 * @sa vtkDataSpaceProjectedTetrahedraMapper, vtkDataSpaceRayCastFunction
 */

#ifndef vtkDataSpaceRayIntegrator_h
#define vtkDataSpaceRayIntegrator_h

#include "vtkUnstructuredGridVolumeRayIntegrator.h"
#include "vtkVolumeOpticsModule.h" // for export macro

#include <memory> // for the classification

class DataSpaceClassification;

class VTKVOLUMEOPTICS_EXPORT vtkDataSpaceRayIntegrator : public vtkUnstructuredGridVolumeRayIntegrator
{
public:
  static vtkDataSpaceRayIntegrator* New();
  vtkTypeMacro(vtkDataSpaceRayIntegrator, vtkUnstructuredGridVolumeRayIntegrator);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Entries along each axis of the table of pre-integrated segments, in [2, 4096]. Default 256.
   * Time to build it and memory grow with the square.
   */
  void SetTableSize(int size);
  vtkGetMacro(TableSize, int);
  ///@}

  /**
   * Called by the mapper before it casts rays.
   */
  void Initialize(vtkVolume* volume, vtkDataArray* scalars) override;

  /**
   * Called by the mapper along each ray, by several threads at once. color: associated, of what lies
   * in front; the segments are added behind it.
   */
  void Integrate(vtkDoubleArray* intersectionLengths, vtkDataArray* nearIntersections,
    vtkDataArray* farIntersections, float color[4]) override;

protected:
  vtkDataSpaceRayIntegrator();
  ~vtkDataSpaceRayIntegrator() override;

private:
  vtkDataSpaceRayIntegrator(const vtkDataSpaceRayIntegrator&) = delete;
  void operator=(const vtkDataSpaceRayIntegrator&) = delete;

  void WarnOnce(bool& isSaid, const char* text);
  void Check(vtkVolume* volume, vtkDataArray* scalars);

  int TableSize = 256;
  std::unique_ptr<DataSpaceClassification> Classification;
  double Range[2] = { 0.0, 0.0 };
  bool IsVisible = false;        // the scalars change somewhere
  bool HasGradientSteps = false; // lengths are |grad s| times the length
  bool IsSilhouetteWarned = false;
  bool IsComponentWarned = false;
  bool IsCellWarned = false;
};

#endif
