// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkOpticsVolumeProperty.h"

#include "ParameterRange.h"
#include "vtkLightingTransferFunction.h"
#include "vtkMultiSampleClassification.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkOpticsVolumeProperty);

namespace
{
const char* const ReflectanceModelNames[] = { "VTK", "None", "BlinnPhong", "Ward", "Lafortune" };
const char* const FrameSourceNames[] = { "Covariance", "Curvature" };
const char* const IntegrationSpaceNames[] = { "Physical", "Data" };
const char* const ClassificationNames[] = { "Post", "PreIntegrated" };
const char* const SilhouetteNames[] = { "Off", "Exact", "Clamped", "Gradient" };
const char* const TransmittedLightNames[] = { "Off", "Diffuse", "DiffuseAndSpecular" };

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
vtkOpticsVolumeProperty::vtkOpticsVolumeProperty() = default;

//------------------------------------------------------------------------------
vtkOpticsVolumeProperty::~vtkOpticsVolumeProperty() = default;

//------------------------------------------------------------------------------
void vtkOpticsVolumeProperty::SetReflectanceModel(int model)
{
  volumeoptics::SetChoice(this, "ReflectanceModel", model, ReflectanceModelNames, this->ReflectanceModel);
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
  volumeoptics::SetWithinRange(this, "Glossiness", glossiness, isRoughness ? 1.0e-4 : 0.01,
    isRoughness ? 1.0 : 1.0e5, this->Glossiness[model]);
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
  volumeoptics::SetWithinRange(this, "AnisotropyScale", scale, 0.0, 1.0e4, this->AnisotropyScale[model]);
}

//------------------------------------------------------------------------------
double vtkOpticsVolumeProperty::GetAnisotropyScale(int model)
{
  return HasAnisotropyScale(model) ? this->AnisotropyScale[model] : 0.0;
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeProperty::SetFrameSource(int source)
{
  volumeoptics::SetChoice(this, "FrameSource", source, FrameSourceNames, this->FrameSource);
}

//------------------------------------------------------------------------------
const char* vtkOpticsVolumeProperty::GetFrameSourceAsString()
{
  return FrameSourceNames[this->FrameSource];
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeProperty::SetScatteringAnisotropy(float anisotropy)
{
  volumeoptics::SetWithinRange(this, "ScatteringAnisotropy", anisotropy, -1.0, 1.0, this->PhaseAnisotropy);
}

//------------------------------------------------------------------------------
float vtkOpticsVolumeProperty::GetScatteringAnisotropy() const
{
  return this->PhaseAnisotropy;
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeProperty::SetIntegrationSpace(int space)
{
  volumeoptics::SetChoice(this, "IntegrationSpace", space, IntegrationSpaceNames, this->IntegrationSpace);
}

//------------------------------------------------------------------------------
const char* vtkOpticsVolumeProperty::GetIntegrationSpaceAsString()
{
  return IntegrationSpaceNames[this->IntegrationSpace];
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeProperty::SetClassification(int classification)
{
  volumeoptics::SetChoice(this, "Classification", classification, ClassificationNames, this->Classification);
}

//------------------------------------------------------------------------------
const char* vtkOpticsVolumeProperty::GetClassificationAsString()
{
  return ClassificationNames[this->Classification];
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeProperty::SetSilhouette(int silhouette)
{
  volumeoptics::SetChoice(this, "Silhouette", silhouette, SilhouetteNames, this->Silhouette);
}

//------------------------------------------------------------------------------
const char* vtkOpticsVolumeProperty::GetSilhouetteAsString()
{
  return SilhouetteNames[this->Silhouette];
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeProperty::SetTransmittedLight(int light)
{
  volumeoptics::SetChoice(this, "TransmittedLight", light, TransmittedLightNames, this->TransmittedLight);
}

//------------------------------------------------------------------------------
const char* vtkOpticsVolumeProperty::GetTransmittedLightAsString()
{
  return TransmittedLightNames[this->TransmittedLight];
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeProperty::SetScalarOpacityUnitInterval(double interval)
{
  volumeoptics::SetWithinRange(
    this, "ScalarOpacityUnitInterval", interval, 0.0, VTK_DOUBLE_MAX, this->ScalarOpacityUnitInterval);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeProperty::SetLightingTransferFunction(vtkLightingTransferFunction* function)
{
  if (this->LightingTransferFunction != function)
  {
    this->LightingTransferFunction = function;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkLightingTransferFunction* vtkOpticsVolumeProperty::GetLightingTransferFunction()
{
  return this->LightingTransferFunction;
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeProperty::SetMultiSampleClassification(vtkMultiSampleClassification* classification)
{
  if (this->MultiSampleClassification != classification)
  {
    this->MultiSampleClassification = classification;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkMultiSampleClassification* vtkOpticsVolumeProperty::GetMultiSampleClassification()
{
  return this->MultiSampleClassification;
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeProperty::SetGradientStepLength(double length)
{
  volumeoptics::SetWithinRange(this, "GradientStepLength", length, 0.0, 1.0e4, this->GradientStepLength);
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeProperty::SetLightScale(double scale)
{
  volumeoptics::SetWithinRange(this, "LightScale", scale, 0.0, 1.0e6, this->LightScale);
}

//------------------------------------------------------------------------------
vtkMTimeType vtkOpticsVolumeProperty::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  for (vtkObject* object : { static_cast<vtkObject*>(this->LightingTransferFunction),
         static_cast<vtkObject*>(this->MultiSampleClassification) })
  {
    time = object ? std::max(time, object->GetMTime()) : time;
  }
  return time;
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
  this->IntegrationSpace = optics->IntegrationSpace;
  this->Classification = optics->Classification;
  this->ScalarOpacityUnitInterval = optics->ScalarOpacityUnitInterval;
  this->Isosurfaces = optics->Isosurfaces;
  this->Silhouette = optics->Silhouette;
  this->TransmittedLight = optics->TransmittedLight;
  this->CopyLightingTransferFunction(optics);
  this->CopyVisibility(optics);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkOpticsVolumeProperty::CopyLightingTransferFunction(vtkOpticsVolumeProperty* source)
{
  this->LightingTransferFunction = nullptr;
  if (source->LightingTransferFunction)
  {
    this->LightingTransferFunction = vtkSmartPointer<vtkLightingTransferFunction>::New();
    this->LightingTransferFunction->ShallowCopy(source->LightingTransferFunction);
  }
  this->MultiSampleClassification = source->MultiSampleClassification;
  this->GradientStepLength = source->GradientStepLength;
  this->LightScale = source->LightScale;
  this->HybridNormals = source->HybridNormals;
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
  os << indent << "IntegrationSpace: " << this->GetIntegrationSpaceAsString() << "\n";
  os << indent << "Classification: " << this->GetClassificationAsString() << "\n";
  os << indent << "ScalarOpacityUnitInterval: " << this->ScalarOpacityUnitInterval << "\n";
  for (const Isosurface& surface : this->Isosurfaces)
  {
    const double* rgb = surface.Color;
    os << indent << "Isosurface: value " << surface.Value << ", opacity " << surface.Opacity << ", colour ";
    surface.HasColor ? os << "(" << rgb[0] << ", " << rgb[1] << ", " << rgb[2] << ")\n"
                     : os << "of the data\n";
  }
  os << indent << "Silhouette: " << this->GetSilhouetteAsString() << "\n";
  os << indent << "TransmittedLight: " << this->GetTransmittedLightAsString() << "\n";
  os << indent << "LightingTransferFunction: " << this->LightingTransferFunction.Get() << "\n";
  os << indent << "MultiSampleClassification: " << this->MultiSampleClassification.Get() << "\n";
  os << indent << "GradientStepLength: " << this->GradientStepLength << "\n";
  os << indent << "LightScale: " << this->LightScale << "\n";
  os << indent << "HybridNormals: " << (this->HybridNormals ? "on" : "off") << "\n";
  this->PrintVisibility(os, indent);
}
