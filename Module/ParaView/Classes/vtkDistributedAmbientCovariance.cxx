// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkDistributedAmbientCovariance.h"

#include "ProcessRange.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkDistributedAmbientCovariance);

//------------------------------------------------------------------------------
int vtkDistributedAmbientCovariance::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (CountProcesses() == 1 || this->HasScalarRange())
  {
    return this->Superclass::RequestData(request, inputs, outputs);
  }
  int association;
  FindRangeOfProcesses(this->FindScalars(inputs, association), this->InputComponent, this->ScalarRange);
  const int result = this->Superclass::RequestData(request, inputs, outputs);
  this->ScalarRange[0] = 1.0;
  this->ScalarRange[1] = 0.0;
  return result;
}

//------------------------------------------------------------------------------
void vtkDistributedAmbientCovariance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
