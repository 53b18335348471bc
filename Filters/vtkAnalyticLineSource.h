// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class vtkAnalyticLineSource
 * @brief Vortex spirals in [-1, 1]^3: dense, thin lines for tests, benchmarks and examples.
 *
 * After the artificial spirals of [Schussman2004] figure 4: lines wind around a few bent axes, close to
 * an axis at its beginning and far from it at its end. Each line is one cell; the cells have the array
 * LineType (0 or 1, by the axis), the points Progress, from 0 to 1 along the line. Any number of segments,
 * by pieces: each line follows from its number alone.
 */

#ifndef vtkAnalyticLineSource_h
#define vtkAnalyticLineSource_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkVolumeOpticsModule.h" // for export macro

class VTKVOLUMEOPTICS_EXPORT vtkAnalyticLineSource : public vtkPolyDataAlgorithm
{
public:
  static vtkAnalyticLineSource* New();
  vtkTypeMacro(vtkAnalyticLineSource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Segments of all lines together, at least 0; the last line may be shorter. Default 100000.
   */
  vtkSetClampMacro(NumberOfSegments, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(NumberOfSegments, vtkIdType);
  ///@}

  ///@{
  /**
   * Segments of a line, at least 1. Default 500.
   */
  vtkSetClampMacro(SegmentsPerLine, int, 1, VTK_INT_MAX);
  vtkGetMacro(SegmentsPerLine, int);
  ///@}

  ///@{
  /**
   * Axes that lines wind around, in [1, 64]. Default 6.
   */
  vtkSetClampMacro(NumberOfAxes, int, 1, 64);
  vtkGetMacro(NumberOfAxes, int);
  ///@}

protected:
  vtkAnalyticLineSource() { this->SetNumberOfInputPorts(0); }
  ~vtkAnalyticLineSource() override = default;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkAnalyticLineSource(const vtkAnalyticLineSource&) = delete;
  void operator=(const vtkAnalyticLineSource&) = delete;

  vtkIdType NumberOfSegments = 100000;
  int SegmentsPerLine = 500;
  int NumberOfAxes = 6;
};

#endif
