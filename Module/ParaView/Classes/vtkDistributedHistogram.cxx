// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkDistributedHistogram.h"

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
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  const int processes = controller ? controller->GetNumberOfProcesses() : 1;
  const double* range = this->GetScalarRange();
  if (processes > 1 && !(range[0] <= range[1]))
  {
    vtkErrorMacro("ScalarRange is not set: each process would count over the range of its own piece. Set it "
                  "to the range of the whole data.");
    return 0;
  }
  const int result = this->Superclass::RequestData(request, inputs, outputs);
  if (processes == 1)
  {
    return result;
  }
  const int rank = controller->GetLocalProcessId();
  const int candidate = FindCounts(vtkImageData::GetData(outputs, 0)) ? rank : processes;
  int owner = processes;
  controller->AllReduce(&candidate, &owner, 1, vtkCommunicator::MIN_OP);
  const vtkIdType bins = static_cast<vtkIdType>(this->GetNumberOfBins()) * this->GetNumberOfBins();
  for (int port = 0; port < 2 && owner < processes; ++port)
  {
    AddUp(controller, vtkImageData::GetData(outputs, port), bins, rank == owner);
  }
  return result;
}

//------------------------------------------------------------------------------
void vtkDistributedHistogram::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
