// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Errors of a VTK object that reads or writes JSON.

#ifndef JsonErrors_h
#define JsonErrors_h

#include "JsonDocument.h"

#include "vtkObject.h"

namespace volumeoptics
{
// Does what may throw a JsonError, which becomes an error of the object. False after an error. subject and
// name say what is read or written.
template <typename Action>
bool TellJsonErrors(vtkObject* object, const char* subject, const char* name, const Action& action)
{
  try
  {
    action();
  }
  catch (const JsonError& error)
  {
    vtkErrorWithObjectMacro(object, << subject << " " << (name ? name : "(no name)") << ": " << error.what());
    return false;
  }
  return true;
}
}

#endif
