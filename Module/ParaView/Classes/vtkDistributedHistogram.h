// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkDistributedHistogram
 * @brief vtkGradientAlignedHistogram of an image whose pieces lie on several processes.
 *
 * The counts of all processes are added up; the first one with a piece has the result, the others have
 * nothing. Without a ScalarRange of its own it takes the one of the whole data, on all processes.
 */

#ifndef vtkDistributedHistogram_h
#define vtkDistributedHistogram_h

#include "vtkGradientAlignedHistogram.h"
#include "vtkVolumeOpticsParaViewModule.h" // for export macro

class VTKVOLUMEOPTICSPARAVIEW_EXPORT vtkDistributedHistogram : public vtkGradientAlignedHistogram
{
public:
  static vtkDistributedHistogram* New();
  vtkTypeMacro(vtkDistributedHistogram, vtkGradientAlignedHistogram);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkDistributedHistogram() = default;
  ~vtkDistributedHistogram() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkDistributedHistogram(const vtkDistributedHistogram&) = delete;
  void operator=(const vtkDistributedHistogram&) = delete;

  void AddUpProcesses(vtkInformationVector* outputs);
};

#endif
