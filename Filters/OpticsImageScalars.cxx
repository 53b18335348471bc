// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Which numbers of its input a filter works on.

#include "vtkOpticsImageFilter.h"

#include "Batches.h"
#include "ProcessGroup.h"
#include "RangeSearch.h"
#include "ScalarSource.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkPointData.h"

#include <algorithm>

//------------------------------------------------------------------------------
vtkDataArray* vtkOpticsImageFilter::GetChosenArray(vtkInformationVector** inputs, int& association)
{
  association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  vtkDataArray* scalars = this->GetInputArrayToProcess(0, inputs, association);
  const char* name = this->GetInputArrayInformation(0)->Get(vtkDataObject::FIELD_NAME());
  vtkImageData* input = vtkImageData::GetData(inputs[0]);
  if (!scalars && input && name && !*name)
  {
    association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
    scalars = input->GetPointData()->GetScalars();
  }
  return scalars;
}

//------------------------------------------------------------------------------
vtkDataArray* vtkOpticsImageFilter::GetScalars(vtkInformationVector** inputs)
{
  int association;
  vtkDataArray* scalars = this->GetChosenArray(inputs, association);
  if (!scalars || scalars->GetNumberOfTuples() == 0)
  {
    vtkErrorMacro("The input has no scalars to work on. Give it point scalars, or name an array by "
                  "SetInputArrayToProcess().");
    return nullptr;
  }
  if (association != vtkDataObject::FIELD_ASSOCIATION_POINTS)
  {
    vtkErrorMacro("Array \"" << (scalars->GetName() ? scalars->GetName() : "")
                             << "\" is not of the points. Convert it first, for example by "
                                "vtkCellDataToPointData.");
    return nullptr;
  }
  if (this->InputComponent >= scalars->GetNumberOfComponents())
  {
    vtkErrorMacro(<< "InputComponent " << this->InputComponent << " is not one of the array's "
                  << scalars->GetNumberOfComponents() << " components. Set it to 0 to "
                  << scalars->GetNumberOfComponents() - 1 << ".");
    return nullptr;
  }
  return scalars;
}

//------------------------------------------------------------------------------
vtkDataArray* vtkOpticsImageFilter::FindScalars(vtkInformationVector** inputs)
{
  int association;
  vtkDataArray* scalars = this->GetChosenArray(inputs, association);
  const bool isUsable = scalars && scalars->GetNumberOfTuples() > 0 &&
    association == vtkDataObject::FIELD_ASSOCIATION_POINTS &&
    this->InputComponent < scalars->GetNumberOfComponents();
  return isUsable ? scalars : nullptr;
}

//------------------------------------------------------------------------------
bool vtkOpticsImageFilter::FindScalarRange(
  const volumeoptics::ProcessGroup& processes, vtkInformationVector** inputs, double range[2])
{
  volumeoptics::RangeSearch search;
  bool isComplete = true;
  if (vtkDataArray* scalars = this->FindScalars(inputs))
  {
    const volumeoptics::ImageRows rows(vtkImageData::GetData(inputs[0]), scalars, this->InputComponent);
    search.Start(rows.GetBox(), rows.GetBox());
    volumeoptics::Batches batches(this);
    isComplete = search.Add(batches, rows);
  }
  std::copy(search.GetRange(), search.GetRange() + 2, range);
  processes.Unite(range);
  return isComplete;
}
