// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ProcessRange.h"

#include "vtkCommunicator.h"
#include "vtkDataArray.h"
#include "vtkMultiProcessController.h"

//------------------------------------------------------------------------------
void FindRangeOfProcesses(vtkDataArray* scalars, int component, double range[2])
{
  double own[2] = { VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX };
  if (scalars && component < scalars->GetNumberOfComponents() && scalars->GetNumberOfTuples() > 0)
  {
    scalars->GetFiniteRange(own, component);
  }
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  controller->AllReduce(&own[0], &range[0], 1, vtkCommunicator::MIN_OP);
  controller->AllReduce(&own[1], &range[1], 1, vtkCommunicator::MAX_OP);
  if (range[0] > range[1])
  {
    range[0] = 1.0;
    range[1] = 0.0;
  }
}

//------------------------------------------------------------------------------
int CountProcesses()
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  return controller ? controller->GetNumberOfProcesses() : 1;
}
