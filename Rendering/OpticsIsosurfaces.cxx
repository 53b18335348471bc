// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// vtkOpticsVolumeProperty: the list of isosurfaces, and the unit of data space.

#include "vtkOpticsVolumeProperty.h"

#include "ParameterRange.h"

#include "vtkPiecewiseFunction.h"

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
double vtkOpticsVolumeProperty::GetEffectiveScalarOpacityUnitInterval()
{
  if (this->ScalarOpacityUnitInterval > 0.0)
  {
    return this->ScalarOpacityUnitInterval;
  }
  const double* range = this->GetScalarOpacity()->GetRange();
  return (range[1] - range[0]) / 100.0;
}

//------------------------------------------------------------------------------
bool vtkOpticsVolumeProperty::AcceptsIsovalue(double value)
{
  if (!std::isfinite(value))
  {
    vtkWarningMacro(<< "An isosurface of value " << value
                    << " is not added: give a value within the range of the data.");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
int vtkOpticsVolumeProperty::InsertIsosurface(const Isosurface& surface)
{
  this->Isosurfaces.push_back(surface);
  this->Modified();
  return this->GetNumberOfIsosurfaces() - 1;
}

//------------------------------------------------------------------------------
int vtkOpticsVolumeProperty::AddIsosurface(double value, double r, double g, double b, double opacity)
{
  if (!this->AcceptsIsovalue(value))
  {
    return -1;
  }
  Isosurface surface = { value, { 0.0, 0.0, 0.0 }, 0.0, true };
  volumeoptics::SetWithinRange(this, "Red of an isosurface", r, 0.0, 1.0, surface.Color[0]);
  volumeoptics::SetWithinRange(this, "Green of an isosurface", g, 0.0, 1.0, surface.Color[1]);
  volumeoptics::SetWithinRange(this, "Blue of an isosurface", b, 0.0, 1.0, surface.Color[2]);
  volumeoptics::SetWithinRange(this, "Opacity of an isosurface", opacity, 0.0, 1.0, surface.Opacity);
  return this->InsertIsosurface(surface);
}

//------------------------------------------------------------------------------
int vtkOpticsVolumeProperty::AddIsosurface(double value, double opacity)
{
  if (!this->AcceptsIsovalue(value))
  {
    return -1;
  }
  Isosurface surface = { value, { 1.0, 1.0, 1.0 }, 0.0, false };
  volumeoptics::SetWithinRange(this, "Opacity of an isosurface", opacity, 0.0, 1.0, surface.Opacity);
  return this->InsertIsosurface(surface);
}

//------------------------------------------------------------------------------
bool vtkOpticsVolumeProperty::HasIsosurface(int index)
{
  const bool isThere = index >= 0 && index < this->GetNumberOfIsosurfaces();
  if (!isThere)
  {
    vtkWarningMacro(<< "There is no isosurface " << index << ": there are " << this->GetNumberOfIsosurfaces()
                    << ", counted from 0.");
  }
  return isThere;
}

//------------------------------------------------------------------------------
double vtkOpticsVolumeProperty::GetIsosurfaceValue(int index)
{
  return this->HasIsosurface(index) ? this->Isosurfaces[index].Value : 0.0;
}

//------------------------------------------------------------------------------
double vtkOpticsVolumeProperty::GetIsosurfaceOpacity(int index)
{
  return this->HasIsosurface(index) ? this->Isosurfaces[index].Opacity : 0.0;
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeProperty::GetIsosurfaceColor(int index, double rgb[3])
{
  if (this->HasIsosurface(index))
  {
    std::copy_n(this->Isosurfaces[index].Color, 3, rgb);
  }
}

//------------------------------------------------------------------------------
bool vtkOpticsVolumeProperty::GetIsosurfaceHasColor(int index)
{
  return this->HasIsosurface(index) && this->Isosurfaces[index].HasColor;
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeProperty::RemoveIsosurface(int index)
{
  if (this->HasIsosurface(index))
  {
    this->Isosurfaces.erase(this->Isosurfaces.begin() + index);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeProperty::RemoveAllIsosurfaces()
{
  if (!this->Isosurfaces.empty())
  {
    this->Isosurfaces.clear();
    this->Modified();
  }
}
