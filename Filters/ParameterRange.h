// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Setting a parameter that has a range, or is one of a few. Outside of its range a value becomes the
// nearest one inside; one that is no number, or none of the few, changes nothing. Either is said in a
// warning of the object.

#ifndef ParameterRange_h
#define ParameterRange_h

#include "vtkObject.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace volumeoptics
{
template <typename T>
void SetWithinRange(
  vtkObject* object, const char* name, double value, double least, double largest, T& parameter)
{
  if (std::isnan(value))
  {
    vtkWarningWithObjectMacro(object, << name << " is not a number; it stays " << parameter
                                      << ". Its range is [" << least << ", " << largest << "].");
    return;
  }
  const double nearest = std::clamp(value, least, largest);
  if (nearest != value)
  {
    vtkWarningWithObjectMacro(object, << name << " " << value << " is outside its range [" << least << ", "
                                      << largest << "]; it is set to " << nearest << ".");
  }
  if (static_cast<T>(nearest) != parameter)
  {
    parameter = static_cast<T>(nearest);
    object->Modified();
  }
}

// A range that may be empty; ends that are not finite change nothing.
inline void SetFiniteRange(
  vtkObject* object, const char* name, double least, double largest, double (&range)[2])
{
  if (!std::isfinite(least) || !std::isfinite(largest))
  {
    vtkWarningWithObjectMacro(object, << name << " " << least << ", " << largest
                                      << " is not finite; it stays " << range[0] << ", " << range[1] << ".");
    return;
  }
  if (least != range[0] || largest != range[1])
  {
    range[0] = least;
    range[1] = largest;
    object->Modified();
  }
}

// names: of the values 0, 1, ...
template <int Count>
void SetChoice(
  vtkObject* object, const char* name, int value, const char* const (&names)[Count], int& parameter)
{
  if (value < 0 || value >= Count)
  {
    std::ostringstream choices;
    for (int i = 0; i < Count; ++i)
    {
      choices << (i > 0 ? ", " : "") << names[i] << " (" << i << ")";
    }
    vtkWarningWithObjectMacro(object,
      << name << " " << value << " is none of " << choices.str() << "; it stays " << names[parameter] << ".");
    return;
  }
  if (value != parameter)
  {
    parameter = value;
    object->Modified();
  }
}

// Bits of a stored number.
inline void SetPrecision(vtkObject* object, const char* name, int bits, int& parameter)
{
  if (bits != 8 && bits != 16 && bits != 32)
  {
    vtkWarningWithObjectMacro(
      object, << name << " " << bits << " is none of 8, 16, 32 bits; it stays " << parameter << ".");
    return;
  }
  if (bits != parameter)
  {
    parameter = bits;
    object->Modified();
  }
}
}

#endif
