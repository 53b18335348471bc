// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkDistributedAmbientCovariance
 * @brief vtkAmbientCovarianceFilter of an image whose pieces lie on several processes.
 *
 * Without a ScalarRange of its own it takes the one of the whole data, on all processes.
 */

#ifndef vtkDistributedAmbientCovariance_h
#define vtkDistributedAmbientCovariance_h

#include "vtkAmbientCovarianceFilter.h"
#include "vtkVolumeOpticsParaViewModule.h" // for export macro

class VTKVOLUMEOPTICSPARAVIEW_EXPORT vtkDistributedAmbientCovariance : public vtkAmbientCovarianceFilter
{
public:
  static vtkDistributedAmbientCovariance* New();
  vtkTypeMacro(vtkDistributedAmbientCovariance, vtkAmbientCovarianceFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkDistributedAmbientCovariance() = default;
  ~vtkDistributedAmbientCovariance() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkDistributedAmbientCovariance(const vtkDistributedAmbientCovariance&) = delete;
  void operator=(const vtkDistributedAmbientCovariance&) = delete;
};

#endif
