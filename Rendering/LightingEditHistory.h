// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Undo and redo of the edits of a lighting transfer function.

#ifndef LightingEditHistory_h
#define LightingEditHistory_h

#include "vtkLightingTransferFunction.h"
#include "vtkSmartPointer.h"

#include <vector>

namespace volumeoptics
{
class LightingEditHistory
{
public:
  // Call before an edit.
  void Record(vtkLightingTransferFunction* function)
  {
    this->Past.push_back(Copy(function));
    this->Future.clear();
    if (this->Past.size() > LargestNumberOfEdits)
    {
      this->Past.erase(this->Past.begin());
    }
  }

  void Clear()
  {
    this->Past.clear();
    this->Future.clear();
  }

  // False if there is nothing to go back or forward to.
  bool Undo(vtkLightingTransferFunction* function) { return Move(this->Past, this->Future, function); }
  bool Redo(vtkLightingTransferFunction* function) { return Move(this->Future, this->Past, function); }

private:
  using States = std::vector<vtkSmartPointer<vtkLightingTransferFunction>>;

  static const std::size_t LargestNumberOfEdits = 200;

  static vtkSmartPointer<vtkLightingTransferFunction> Copy(vtkLightingTransferFunction* function)
  {
    auto copy = vtkSmartPointer<vtkLightingTransferFunction>::New();
    copy->ShallowCopy(function);
    return copy;
  }

  static bool Move(States& from, States& to, vtkLightingTransferFunction* function)
  {
    if (from.empty())
    {
      return false;
    }
    to.push_back(Copy(function));
    function->ShallowCopy(from.back());
    from.pop_back();
    return true;
  }

  States Past;
  States Future;
};
}

#endif
