// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMacrocellGrid
 * @brief Where a volume is empty, as far as its transfer function is concerned.
 *
 * The voxels of an image in cubes, the macrocells: of each the range of the scalars that a ray can meet in it
 * by interpolation, so with one voxel more on each side. The ranges are found once for the scalars
 * (Update()); which cells are empty depends on the transfer function too, and is found from the ranges alone,
 * without the voxels (Classify()), together with each cell's distance to the nearest one that is not empty:
 * how far a ray may leap. Distances are those of the largest coordinate, in cells.
 *
 * Where opacity depends on the gradient's magnitude, the largest one that a ray can meet in each cell is found once for
 * the scalars, too (UpdateGradients()): where the function hides all smaller ones, the cell is empty.
 *
 * Work is shared among threads (vtkSMPTools); Update() and UpdateGradients() invoke StartEvent, ProgressEvent (call
 * data: double in [0, 1]) and EndEvent. Takes GetMemorySize() bytes: 10 for each cell, so 1/50 of a byte for each voxel
 * where a cell has 8 of them on each axis, and 4 more with gradients. Independent of OpenGL.
 */

#ifndef vtkMacrocellGrid_h
#define vtkMacrocellGrid_h

#include "vtkObject.h"
#include "vtkSmartPointer.h"       // for members
#include "vtkVolumeOpticsModule.h" // for export macro

#include <vector> // for members

class VisibleScalars;
class vtkDataArray;

class VTKVOLUMEOPTICS_EXPORT vtkMacrocellGrid : public vtkObject
{
public:
  static vtkMacrocellGrid* New();
  vtkTypeMacro(vtkMacrocellGrid, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Voxels of a cell on each axis, in [2, 64]. Default 8.
   */
  vtkSetClampMacro(CellSize, int, 2, 64);
  vtkGetMacro(CellSize, int);
  ///@}

  /**
   * The smallest of 2, 4, 8, ... 64 with which a volume of these dimensions has at most 2^18 cells, as 512^3 voxels
   * in cells of 8^3 have: small cells leave less to see, and Classify() still takes milliseconds.
   */
  static int FindCellSize(const int dimensions[3]);

  ///@{
  /**
   * The scalars, x running fastest, and their number on each axis, of which the product is the number of
   * tuples. Default none, 0.
   */
  void SetScalars(vtkDataArray* scalars);
  vtkDataArray* GetScalars();
  vtkSetVector3Macro(Dimensions, int);
  vtkGetVector3Macro(Dimensions, int);
  ///@}

  ///@{
  /**
   * The component of the scalars that opacity depends on, at least 0. Default 0.
   */
  vtkSetClampMacro(Component, int, 0, VTK_INT_MAX);
  vtkGetMacro(Component, int);
  ///@}

  ///@{
  /**
   * Gradient magnitude of a difference of 1 between the two neighbours of a voxel on each axis. Magnitudes are lengths
   * of such differences, clamped to 1 as VTK clamps those that it looks gradient opacity up by. Default 0.
   */
  vtkSetVector3Macro(GradientScale, double);
  vtkGetVector3Macro(GradientScale, double);
  ///@}

  /**
   * Finds the ranges if something has changed. False, with one error until the next change, if there are no
   * scalars of these dimensions and with this component; the grid is empty then.
   */
  bool Update();

  /**
   * Finds the gradient magnitudes, after Update(), unless they are known. Until then any cell has any magnitude.
   */
  void UpdateGradients();

  /** Number of cells on each axis, after Update(). */
  vtkGetVector3Macro(GridSize, int);

  /**
   * Range of a cell's scalars that are numbers, after Update(); where there are none the first is larger than
   * the last.
   */
  void GetCellRange(int i, int j, int k, double range[2]);

  /**
   * The largest gradient magnitude that a sample in a cell has by VTK's shader and linear interpolation, in [0, 1], or
   * a little more: steps between voxels count by 1 / (n - 1), n being the voxels on the axis, where VTK looks beyond a
   * voxel, and by 1/256, the accuracy of texture coordinates; what differs in codes of 8 and 16 bits by 3 codes, which
   * interpolation may round. 1 beside a scalar that is not finite, or where UpdateGradients() was not called.
   */
  float GetCellGradient(int i, int j, int k);

  /** Whether a cell has a scalar that is not finite. */
  bool GetCellHasNonFinite(int i, int j, int k);

  /**
   * Distance in cells to the nearest one that is not empty, after Classify(): 0 of one that is not empty
   * itself, at most 255.
   */
  int GetCellDistance(int i, int j, int k);

  /**
   * First and last cell on each axis between which all lie that are not empty, after Classify(); the first is behind
   * the last where all are empty.
   */
  vtkGetVector6Macro(VisibleExtent, int);

  /** Part of the cells that are empty, in [0, 1], after Classify(). */
  vtkGetMacro(EmptyFraction, double);

  /** Part of the cells that are empty with all cells around them, in [0, 1], after Classify(). */
  vtkGetMacro(DeepEmptyFraction, double);

  /** Bytes of ranges, gradients and distances. */
  std::size_t GetMemorySize();

  /** When Update() found the ranges last. */
  vtkMTimeType GetUpdateTime() { return this->UpdateTime.GetMTime(); }

  /** When Classify() changed the distances last. */
  vtkMTimeType GetClassifyTime() { return this->ClassifyTime.GetMTime(); }

#ifndef __VTK_WRAP__
  /**
   * Finds the cells without a scalar that can be seen with their gradients, and the distances to the others. Of a cell
   * of one scalar alone visibleWhereConstant tells: in data space it is empty even where the function is opaque.
   */
  void Classify(const VisibleScalars& visible, const VisibleScalars& visibleWhereConstant);

  /** One of each cell, x running fastest. */
  const std::vector<unsigned char>& GetDistances() const
  {
    return this->Distances;
  }
#endif

protected:
  vtkMacrocellGrid();
  ~vtkMacrocellGrid() override;

private:
  vtkMacrocellGrid(const vtkMacrocellGrid&) = delete;
  void operator=(const vtkMacrocellGrid&) = delete;

  bool IsUsable();
  void FindRanges();
  void FindGradients();
  void FindVisibleExtent();
  std::size_t Index(int i, int j, int k) const;

  int CellSize = 8;
  vtkSmartPointer<vtkDataArray> Scalars;
  int Dimensions[3] = { 0, 0, 0 };
  int Component = 0;
  double GradientScale[3] = { 0.0, 0.0, 0.0 };

  int GridSize[3] = { 0, 0, 0 };
  std::vector<float> Lowest; // rounded outwards
  std::vector<float> Highest;
  std::vector<unsigned char> NonFinite;
  std::vector<float> Gradients; // rounded upwards; empty until they are asked for
  std::vector<unsigned char> Distances;
  int VisibleExtent[6] = { 0, -1, 0, -1, 0, -1 };
  double EmptyFraction = 0.0;
  double DeepEmptyFraction = 0.0;
  vtkTimeStamp UpdateTime;
  vtkTimeStamp ClassifyTime;
};

#endif
