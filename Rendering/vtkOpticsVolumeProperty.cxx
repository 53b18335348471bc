// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkOpticsVolumeProperty.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkOpticsVolumeProperty);

namespace
{
const char* const ReflectanceModelNames[] = { "VTK", "None", "BlinnPhong", "Ward", "Lafortune" };
const char* const FrameSourceNames[] = { "Covariance", "Curvature" };

bool HasGlossiness(int model)
{
  return model >= vtkOpticsVolumeProperty::BlinnPhong && model <= vtkOpticsVolumeProperty::Lafortune;
}

bool HasAnisotropyScale(int model)
{
  return model == vtkOpticsVolumeProperty::Ward || model == vtkOpticsVolumeProperty::Lafortune;
}
}

//------------------------------------------------------------------------------
double vtkOpticsVolumeProperty::WithinRange(
  const char* name, double value, double least, double largest, double current)
{
  if (std::isnan(value))
  {
    vtkWarningMacro(<< name << " is not a number; it stays " << current << ". Its range is [" << least << ", "
                    << largest << "].");
    return current;
  }
  const double nearest = std::clamp(value, least, largest);
  if (nearest != value)
  {
    vtkWarningMacro(<< name << " " << value << " is outside its range [" << least << ", " << largest
                    << "]; it is set to " << nearest << ".");
  }
  return nearest;
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeProperty::SetReflectanceModel(int model)
{
  if (model < VTK || model >= NumberOfReflectanceModels)
  {
    vtkWarningMacro(<< "Reflectance model " << model
                    << " is none of VTK (0), None (1), BlinnPhong (2), Ward (3), Lafortune (4); it stays "
                    << this->GetReflectanceModelAsString() << ".");
    return;
  }
  if (model != this->ReflectanceModel)
  {
    this->ReflectanceModel = model;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
const char* vtkOpticsVolumeProperty::GetReflectanceModelAsString()
{
  return ReflectanceModelNames[this->ReflectanceModel];
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeProperty::SetGlossiness(int model, double glossiness)
{
  if (!HasGlossiness(model))
  {
    vtkWarningMacro(<< "Glossiness " << glossiness << " is not set: reflectance model " << model
                    << " has none. Choose BlinnPhong, Ward or Lafortune first, or name one of them.");
    return;
  }
  const bool isRoughness = model == Ward;
  const double value = this->WithinRange("Glossiness", glossiness, isRoughness ? 1.0e-4 : 0.01,
    isRoughness ? 1.0 : 1.0e5, this->Glossiness[model]);
  if (value != this->Glossiness[model])
  {
    this->Glossiness[model] = value;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
double vtkOpticsVolumeProperty::GetGlossiness(int model)
{
  return HasGlossiness(model) ? this->Glossiness[model] : 0.0;
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeProperty::SetAnisotropyScale(int model, double scale)
{
  if (!HasAnisotropyScale(model))
  {
    vtkWarningMacro(<< "AnisotropyScale " << scale << " is not set: reflectance model " << model
                    << " has none. Choose Ward or Lafortune first, or name one of them.");
    return;
  }
  const double value = this->WithinRange("AnisotropyScale", scale, 0.0, 1.0e4, this->AnisotropyScale[model]);
  if (value != this->AnisotropyScale[model])
  {
    this->AnisotropyScale[model] = value;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
double vtkOpticsVolumeProperty::GetAnisotropyScale(int model)
{
  return HasAnisotropyScale(model) ? this->AnisotropyScale[model] : 0.0;
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeProperty::SetFrameSource(int source)
{
  if (source != Covariance && source != Curvature)
  {
    vtkWarningMacro(<< "Frame source " << source << " is none of Covariance (0), Curvature (1); it stays "
                    << this->GetFrameSourceAsString() << ".");
    return;
  }
  if (source != this->FrameSource)
  {
    this->FrameSource = source;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
const char* vtkOpticsVolumeProperty::GetFrameSourceAsString()
{
  return FrameSourceNames[this->FrameSource];
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeProperty::SetScatteringAnisotropy(float anisotropy)
{
  const float value = static_cast<float>(
    this->WithinRange("ScatteringAnisotropy", anisotropy, -1.0, 1.0, this->PhaseAnisotropy));
  if (value != this->PhaseAnisotropy)
  {
    this->PhaseAnisotropy = value;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
float vtkOpticsVolumeProperty::GetScatteringAnisotropy() const
{
  return this->PhaseAnisotropy;
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeProperty::DeepCopy(vtkVolumeProperty* source)
{
  this->Superclass::DeepCopy(source);
  auto* optics = vtkOpticsVolumeProperty::SafeDownCast(source);
  if (!optics || optics == this)
  {
    return;
  }
  this->ReflectanceModel = optics->ReflectanceModel;
  std::copy(std::begin(optics->Glossiness), std::end(optics->Glossiness), this->Glossiness);
  std::copy(std::begin(optics->AnisotropyScale), std::end(optics->AnisotropyScale), this->AnisotropyScale);
  this->SpecularFromExtinction = optics->SpecularFromExtinction;
  this->FrameSource = optics->FrameSource;
  this->PhaseAnisotropy = optics->PhaseAnisotropy;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeProperty::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ReflectanceModel: " << this->GetReflectanceModelAsString() << "\n";
  for (int model = BlinnPhong; model <= Lafortune; ++model)
  {
    os << indent << "Glossiness of " << ReflectanceModelNames[model] << ": " << this->Glossiness[model]
       << "\n";
    os << indent << "AnisotropyScale of " << ReflectanceModelNames[model] << ": "
       << this->AnisotropyScale[model] << "\n";
  }
  os << indent << "SpecularFromExtinction: " << (this->SpecularFromExtinction ? "on" : "off") << "\n";
  os << indent << "FrameSource: " << this->GetFrameSourceAsString() << "\n";
  os << indent << "ScatteringAnisotropy: " << this->PhaseAnisotropy << "\n";
}
