// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class vtkOpticsImageFilter
 * @brief Superclass of the filters that estimate optical properties of an image's voxels.
 *
 * Works on one component of one array of point scalars, of any VTK type (SetInputArrayToProcess(),
 * default the active scalars). Blanked points (vtkGhostType HIDDENPOINT), NaN and infinities have no
 * value and are left out; DUPLICATEPOINT marks valid values of a neighbouring piece, which are used.
 * Spacing and direction matrix are honoured: vectors are in world axes, lengths round in world space.
 * The output has the new arrays, and the input's only with PassInputArrays.
 *
 * Filters stream: a piece requests its extent and the neighbourhood that it needs, and pieces are
 * bit for bit parts of the whole. They run on all threads (vtkSMPTools), report progress from the
 * calling thread and look for AbortExecute about every 30 ms; an aborted filter has an empty output.
 *
 * Distributed data: a numbered piece (UpdatePiece(), and all of ParaView) follows the piece of the input,
 * which is asked for the ghost layers that the neighbourhood needs; ghost layers that are asked of
 * the output are computed and marked. Pieces are bit for bit parts of the whole. Where the input has
 * fewer layers than it was asked for, a warning says how many, and the piece's edge is that of a volume.
 * A process whose piece is empty has an empty output.
 *
 * A number outside its range is set to the nearest one of the range, with a warning; a choice that does
 * not exist leaves the former one, with a warning. An image without the array gives an error and an
 * empty output.
 */

#ifndef vtkOpticsImageFilter_h
#define vtkOpticsImageFilter_h

#include "vtkImageAlgorithm.h"
#include "vtkSmartPointer.h"       // for the controller
#include "vtkVolumeOpticsModule.h" // for export macro

class vtkDataArray;
class vtkMultiProcessController;

namespace volumeoptics
{
class Batches;
class ImageRows;
class ProcessGroup;
struct ImageGrid;
}

class VTKVOLUMEOPTICS_EXPORT vtkOpticsImageFilter : public vtkImageAlgorithm
{
public:
  vtkTypeMacro(vtkOpticsImageFilter, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Resolution of the output relative to the input: voxel i of the output lies at input index
   * i / ResolutionFactor, its scalar is interpolated linearly and its spacing is larger by
   * 1 / ResolutionFactor. In [0.01, 1]; default 1, the input's own voxels. [Ament2015] section 5
   * uses 1/2, 3/4 and 1.
   */
  void SetResolutionFactor(double factor);
  vtkGetMacro(ResolutionFactor, double);
  ///@}

  ///@{
  /**
   * Standard deviation of a Gaussian that the scalars are smoothed with first, in voxels of the
   * input's finest spacing. In [0, 100]; 0 is none. Default 0 (vtkPrincipalCurvatureFilter: 1).
   */
  void SetSmoothing(double standardDeviation);
  vtkGetMacro(Smoothing, double);
  ///@}

  ///@{
  /**
   * Component of the scalars to work on, from 0; default 0. Asking for one that the array does not
   * have is an error at execution.
   */
  void SetInputComponent(int component);
  vtkGetMacro(InputComponent, int);
  ///@}

  ///@{
  /**
   * Bits of the normalised integers that the output is rounded to: 8, 16, or 32 for none. The array
   * is of float all the same; this shows what an upload in that precision will do. Default 32.
   */
  void SetOutputPrecision(int bits);
  void SetOutputPrecisionTo8Bits() { this->SetOutputPrecision(8); }
  void SetOutputPrecisionTo16Bits() { this->SetOutputPrecision(16); }
  void SetOutputPrecisionTo32Bits() { this->SetOutputPrecision(32); }
  vtkGetMacro(OutputPrecision, int);
  ///@}

  ///@{
  /**
   * The processes that share the volume, each with the piece of its own number of as many pieces.
   * Filters that need numbers of the whole volume (the scalar range, a histogram) find them together:
   * then all processes must update the filter, as in any parallel filter of VTK. Blocks of composite data stand
   * alone. Default: the global controller at the filter's construction, none in programs of one process.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController() const;
  ///@}

  /**
   * Layers of voxels around a piece of an image that the piece's result depends on; resolutionFactor as above.
   * An upper bound: that of voxels that are cubes.
   */
  int GetGhostLayers(double resolutionFactor);

  ///@{
  /**
   * Whether the output also has the input's point arrays, so that it can be drawn; with a ResolutionFactor
   * of 1 alone. Default off.
   */
  vtkSetMacro(PassInputArrays, bool);
  vtkGetMacro(PassInputArrays, bool);
  vtkBooleanMacro(PassInputArrays, bool);
  ///@}

protected:
  vtkOpticsImageFilter();
  ~vtkOpticsImageFilter() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  /**
   * Whether the input is composite data, which the executive passes on block by block.
   */
  static bool IsComposite(vtkInformationVector** inputs);

  /**
   * Whether the input has a whole extent; else an error.
   */
  bool HasExtent(vtkInformationVector** inputs);

  /**
   * The extent of the grid that the arrays are computed on: the one requested of the output, unless
   * overridden.
   */
  virtual void GetExtentToCompute(const volumeoptics::ImageGrid& grid, vtkInformation* output, int extent[6]);

  /**
   * Pieces that the input is asked for: as many as the output, unless overridden.
   */
  virtual int GetNumberOfInputPieces(vtkInformation* output);

  /**
   * The processes that share the update of this output.
   */
  volumeoptics::ProcessGroup GetProcesses(vtkInformation* output);

  /**
   * Ghost layers of the input around a numbered piece.
   */
  int GetGhostLevels(const volumeoptics::ImageGrid& grid, vtkInformation* output);
  int CountGhostLayers(const volumeoptics::ImageGrid& grid, int layersOfOutput);

  /**
   * The array to work on, if it has what it takes.
   */
  vtkDataArray* FindScalars(vtkInformationVector** inputs);

  /**
   * The range of the finite values of the input's data, joined with that of the other processes; (1, 0)
   * where there is none. False on abort.
   */
  bool FindScalarRange(
    const volumeoptics::ProcessGroup& processes, vtkInformationVector** inputs, double range[2]);

  /**
   * Voxels of the output's grid around a voxel whose scalars it needs, smoothing left out.
   */
  virtual void GetReach(const volumeoptics::ImageGrid& grid, int reach[3]) = 0;

  /**
   * Adds the arrays to the output, whose extent and geometry are set. False on abort or error.
   */
  virtual bool ComputeArrays(const volumeoptics::ImageGrid& grid, const volumeoptics::ImageRows& rows,
    vtkInformationVector** inputs, volumeoptics::Batches& batches, vtkImageData* output) = 0;

  /**
   * Whether the output has voxels of the input, so that the input's arrays may be passed.
   */
  virtual bool IsOnInputGrid() const { return this->ResolutionFactor == 1.0; }

  /**
   * The grid of the output, from the information of input port 0.
   */
  volumeoptics::ImageGrid GetGrid(vtkInformationVector** inputs);

  /**
   * The extent of the input that an extent of the output is computed from.
   */
  void GetNeededExtent(const volumeoptics::ImageGrid& grid, const int output[6], int input[6]);

  /**
   * The point array to work on; without one, nullptr and an error.
   */
  vtkDataArray* GetScalars(vtkInformationVector** inputs);

  /**
   * A new float array of the output's points.
   */
  static float* AddArray(vtkImageData* output, const char* name, int components);

  vtkSmartPointer<vtkMultiProcessController> Controller;
  double ResolutionFactor = 1.0;
  double Smoothing = 0.0;
  int InputComponent = 0;
  int OutputPrecision = 32;
  bool PassInputArrays = false;

private:
  struct Part;
  // An empty name, which ParaView passes where it does not know the input's arrays yet, stands for the active
  // scalars of the points.
  vtkDataArray* GetChosenArray(vtkInformationVector** inputs, int& association);
  Part GetPart(const volumeoptics::ImageGrid& whole, vtkInformation* output, vtkImageData* input);
  vtkOpticsImageFilter(const vtkOpticsImageFilter&) = delete;
  void operator=(const vtkOpticsImageFilter&) = delete;
};

#endif
