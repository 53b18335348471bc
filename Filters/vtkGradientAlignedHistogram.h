// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class vtkGradientAlignedHistogram
 * @brief How often pairs of scalars lie opposite each other across a voxel, along its gradient.
 *
 * Each voxel with a value counts once, at S1 = s(x + h g), S2 = s(x - h g) [Lum2004], g the unit
 * gradient in world axes by vtkSobelNormalFilter's operator, h the StepLength; scalars between voxels
 * are trilinear, outside of the volume they are the border's. Where the gradient is 0, S1 = S2 = s.
 * Materials lie on the diagonal, boundaries off it, at S1 > S2.
 *
 * Output 0: a 2D image of NumberOfBins x NumberOfBins, x is S1 and y is S2, whose points are the bins'
 * centres: origin and spacing are in scalars. Its array `Counts` (double, exact integers) is active.
 * Output 1: the same of the scalar s (x) and the gradient's magnitude (y) from 0 to the range's width
 * over twice the finest spacing, a step between neighbours; the last bin has what is above.
 *
 * Left out: blanked points, NaN and infinities, voxels one of whose two samples is next to them, points
 * that another piece owns (DUPLICATEPOINT), and voxels with one of the scalars outside ScalarRange.
 * The filter works on the input's whole extent. Processes that share the volume (SetController()) each
 * count their own piece, and all have the histogram of the whole. Histograms are sums: those of pieces with at least
 * StepLength + 1 ghost voxels, with the same ScalarRange set, add up to the whole's.
 *
 * Of the superclass's parameters OutputPrecision and PassInputArrays do not matter.
 *
 * @sa vtkLightingTransferFunction vtkLightingTransferFunctionItem
 */

#ifndef vtkGradientAlignedHistogram_h
#define vtkGradientAlignedHistogram_h

#include "vtkOpticsImageFilter.h"
#include "vtkVolumeOpticsModule.h" // for export macro

#include <memory> // for the counts

class VTKVOLUMEOPTICS_EXPORT vtkGradientAlignedHistogram : public vtkOpticsImageFilter
{
public:
  static vtkGradientAlignedHistogram* New();
  vtkTypeMacro(vtkGradientAlignedHistogram, vtkOpticsImageFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Bins along each axis. In [1, 4096]; default 256.
   */
  void SetNumberOfBins(int number);
  vtkGetMacro(NumberOfBins, int);
  ///@}

  ///@{
  /**
   * Scalars from the start of the first bin to the end of the last, which belongs to it. Default: an
   * empty one (1, 0), which stands for the finite values of the input's whole extent. A range of zero
   * width is widened by half a unit to both sides, or by a millionth of the value where that is more.
   */
  void SetScalarRange(double least, double largest);
  void SetScalarRange(const double range[2]) { this->SetScalarRange(range[0], range[1]); }
  void SetScalarRangeToWholeExtent() { this->SetScalarRange(1.0, 0.0); }
  vtkGetVector2Macro(ScalarRange, double);
  ///@}

  ///@{
  /**
   * Distance h from the voxel to each of the samples, in units of the finest spacing. Longer than the
   * blur of the boundaries, it reaches the materials on both sides. In [0.01, 1000]; default 1.
   */
  void SetStepLength(double length);
  vtkGetMacro(StepLength, double);
  ///@}

  ///@{
  /**
   * Whether every process that shares the volume has the result, or the first one alone, the others an empty
   * output: for programs that put together what all processes have, such as ParaView. Default on.
   */
  vtkSetMacro(ResultOnAllProcesses, bool);
  vtkGetMacro(ResultOnAllProcesses, bool);
  vtkBooleanMacro(ResultOnAllProcesses, bool);
  ///@}

protected:
  vtkGradientAlignedHistogram();
  ~vtkGradientAlignedHistogram() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int GetNumberOfInputPieces(vtkInformation* output) override;
  void GetReach(const volumeoptics::ImageGrid& grid, int reach[3]) override;
  void GetExtentToCompute(
    const volumeoptics::ImageGrid& grid, vtkInformation* output, int extent[6]) override;
  bool ComputeArrays(const volumeoptics::ImageGrid& grid, const volumeoptics::ImageRows& rows,
    vtkInformationVector** inputs, volumeoptics::Batches& batches, vtkImageData* output) override;
  bool IsOnInputGrid() const override { return false; }

private:
  vtkGradientAlignedHistogram(const vtkGradientAlignedHistogram&) = delete;
  void operator=(const vtkGradientAlignedHistogram&) = delete;

  struct Run;
  bool FindRange(const volumeoptics::ProcessGroup& processes, vtkInformationVector** inputs, Run& run);
  bool Join(const volumeoptics::ProcessGroup& processes, bool isRight);
  void Store(vtkInformationVector* outputs);

  int NumberOfBins = 256;
  double ScalarRange[2] = { 1.0, 0.0 };
  double StepLength = 1.0;
  bool ResultOnAllProcesses = true;
  std::unique_ptr<Run> Current; // in an update
};

#endif
