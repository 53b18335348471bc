// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkDataSpaceProjectedTetrahedraMapper
 * @brief Draws tetrahedral grids by the volume rendering integral in data space.
 *
 * Attenuation and colour belong to a change of the scalar, not to a length: what is seen of a cell
 * depends on the scalars where a ray enters and leaves it alone, not on the cell's size, the world's
 * scale or the gradient, and a table of two dimensions holds all that a cell can show. Cells in which
 * the scalar is constant are not seen.
 *
 * The volume's property gives the transfer functions: an opacity is that of crossing the unit interval
 * of data (vtkOpticsVolumeProperty::SetScalarOpacityUnitInterval(); a hundredth of the opacity
 * function's range for a plain vtkVolumeProperty). A vtkOpticsVolumeProperty also gives isosurfaces of
 * exact opacity, and silhouettes. Whatever the property's integration space, this class integrates in
 * data space; it has no shading. Gray functions count as colours.
 *
 * The cells are drawn one by one from back to front, each in its own projection, on a target of
 * float. The scalars where the ray of a pixel enters and leaves are computed in the pixel, also in
 * perspective; so cells are uploaded once, and only their order each frame. Opaque geometry cuts the
 * ray where it stands. The order is that of VisibilitySort, vtkCellCenterDepthSort by default, which is
 * not always the true one; it matters for colours, not for the total opacity.
 *
 * The input is a vtkUnstructuredGrid of VTK_TETRA alone, with scalars of the points; other cells are an
 * error (vtkDataSetTriangleFilter is the remedy), with one message, and nothing is drawn. Flat cells,
 * those with a scalar that is no finite number, ghosts and blanked cells are left out. Of several
 * components the first is drawn; at most 1024 isosurfaces are. In a hardware selection the volume is left out.
 *
 * Source: [Kraus2005] sections 3.2.1 and 6, [Weiler2003]; see Module/References.md.
 *
 * @sa vtkDataSpaceRayIntegrator
 */

#ifndef vtkDataSpaceProjectedTetrahedraMapper_h
#define vtkDataSpaceProjectedTetrahedraMapper_h

#include "vtkProjectedTetrahedraMapper.h"
#include "vtkVolumeOpticsModule.h" // for export macro

#include <memory> // for members
#include <string> // for members
#include <vector> // for members

class DataSpaceClassification;
class ProjectedTetrahedraPainter;
class TetrahedraVertices;
class vtkDataArray;

class VTKVOLUMEOPTICS_EXPORT vtkDataSpaceProjectedTetrahedraMapper : public vtkProjectedTetrahedraMapper
{
public:
  static vtkDataSpaceProjectedTetrahedraMapper* New();
  vtkTypeMacro(vtkDataSpaceProjectedTetrahedraMapper, vtkProjectedTetrahedraMapper);
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
   * Draws the volume; called by vtkVolume.
   */
  void Render(vtkRenderer* renderer, vtkVolume* volume) override;

  void ReleaseGraphicsResources(vtkWindow* window) override;

  /**
   * Whether the window is one of OpenGL.
   */
  bool IsSupported(vtkRenderWindow* window) override;

protected:
  vtkDataSpaceProjectedTetrahedraMapper();
  ~vtkDataSpaceProjectedTetrahedraMapper() override;

private:
  vtkDataSpaceProjectedTetrahedraMapper(const vtkDataSpaceProjectedTetrahedraMapper&) = delete;
  void operator=(const vtkDataSpaceProjectedTetrahedraMapper&) = delete;

  bool IsUsable(vtkRenderer* renderer);
  bool UpdateVertices(vtkDataArray* scalars, const double range[2]);
  vtkDataArray* FindScalars(vtkVolume* volume);
  bool Prepare(vtkVolume* volume);
  bool Sort(vtkRenderer* renderer, vtkVolume* volume);
  void WarnOnce(const std::string& text);
  void FailOnce(const std::string& text);

  int TableSize = 256;
  std::unique_ptr<DataSpaceClassification> Classification;
  std::unique_ptr<TetrahedraVertices> Vertices;
  std::unique_ptr<ProjectedTetrahedraPainter> Painter;
  std::vector<unsigned int> Order;
  vtkDataArray* DrawnScalars = nullptr;
  vtkTimeStamp VerticesTime;
  std::string Warned;
  std::string Failed;
};

#endif
