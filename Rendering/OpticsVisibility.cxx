// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// vtkOpticsVolumeProperty: occlusion and shadows.

#include "vtkOpticsVolumeProperty.h"

#include "ParameterRange.h"

#include <algorithm>

namespace
{
// Beyond it a cone is nearly the half space, whose rim no distance along its axis reaches.
constexpr double LargestHalfAngle = 80.0;
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeProperty::SetOcclusionAngle(double degrees)
{
  volumeoptics::SetWithinRange(this, "OcclusionAngle", degrees, 0.0, LargestHalfAngle, this->OcclusionAngle);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeProperty::SetAmbientColor(double red, double green, double blue)
{
  volumeoptics::SetWithinRange(this, "The red of AmbientColor", red, 0.0, 1.0, this->AmbientColor[0]);
  volumeoptics::SetWithinRange(this, "The green of AmbientColor", green, 0.0, 1.0, this->AmbientColor[1]);
  volumeoptics::SetWithinRange(this, "The blue of AmbientColor", blue, 0.0, 1.0, this->AmbientColor[2]);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeProperty::SetShadowAngle(double degrees)
{
  volumeoptics::SetWithinRange(this, "ShadowAngle", degrees, 0.0, LargestHalfAngle, this->ShadowAngle);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeProperty::CopyVisibility(vtkOpticsVolumeProperty* source)
{
  this->Occlusion = source->Occlusion;
  this->OcclusionAngle = source->OcclusionAngle;
  std::copy(std::begin(source->AmbientColor), std::end(source->AmbientColor), this->AmbientColor);
  this->Shadows = source->Shadows;
  this->ShadowAngle = source->ShadowAngle;
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeProperty::PrintVisibility(ostream& os, vtkIndent indent)
{
  const double* rgb = this->AmbientColor;
  os << indent << "Occlusion: " << (this->Occlusion ? "on" : "off") << "\n";
  os << indent << "OcclusionAngle: " << this->OcclusionAngle << "\n";
  os << indent << "AmbientColor: (" << rgb[0] << ", " << rgb[1] << ", " << rgb[2] << ")\n";
  os << indent << "Shadows: " << (this->Shadows ? "on" : "off") << "\n";
  os << indent << "ShadowAngle: " << this->ShadowAngle << "\n";
}
