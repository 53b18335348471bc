// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkDistributedHistogram.h"

#include "ProcessRange.h"

#include "vtkCommunicator.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"

#include <algorithm>
#include <vector>

vtkStandardNewMacro(vtkDistributedHistogram);

namespace
{
vtkDoubleArray* FindCounts(vtkImageData* histogram)
{
  return vtkDoubleArray::SafeDownCast(histogram->GetPointData()->GetArray("Counts"));
}

// A process without a piece adds nothing, but takes part.
void AddUp(vtkMultiProcessController* controller, vtkImageData* histogram, vtkIdType bins, bool isOwner)
{
  vtkDoubleArray* counts = FindCounts(histogram);
  std::vector<double> own(static_cast<std::size_t>(bins), 0.0);
  if (counts)
  {
    own.assign(counts->GetPointer(0), counts->GetPointer(0) + bins);
  }
  std::vector<double> sum(own.size(), 0.0);
  controller->AllReduce(own.data(), sum.data(), bins, vtkCommunicator::SUM_OP);
  if (isOwner)
  {
    std::copy(sum.begin(), sum.end(), counts->GetPointer(0));
    counts->Modified();
  }
  else
  {
    histogram->Initialize();
  }
}
}

//------------------------------------------------------------------------------
int vtkDistributedHistogram::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (CountProcesses() == 1)
  {
    return this->Superclass::RequestData(request, inputs, outputs);
  }
  const double range[2] = { this->ScalarRange[0], this->ScalarRange[1] };
  if (!(range[0] <= range[1]))
  {
    int association;
    FindRangeOfProcesses(this->FindScalars(inputs, association), this->InputComponent, this->ScalarRange);
  }
  const int result = this->Superclass::RequestData(request, inputs, outputs);
  std::copy(range, range + 2, this->ScalarRange);
  this->AddUpProcesses(outputs);
  return result;
}

//------------------------------------------------------------------------------
void vtkDistributedHistogram::AddUpProcesses(vtkInformationVector* outputs)
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  const int processes = controller->GetNumberOfProcesses();
  const int rank = controller->GetLocalProcessId();
  const int candidate = FindCounts(vtkImageData::GetData(outputs, 0)) ? rank : processes;
  int owner = processes;
  controller->AllReduce(&candidate, &owner, 1, vtkCommunicator::MIN_OP);
  const vtkIdType bins = static_cast<vtkIdType>(this->GetNumberOfBins()) * this->GetNumberOfBins();
  for (int port = 0; port < 2 && owner < processes; ++port)
  {
    AddUp(controller, vtkImageData::GetData(outputs, port), bins, rank == owner);
  }
}

//------------------------------------------------------------------------------
void vtkDistributedHistogram::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
