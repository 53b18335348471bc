// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkLitLineVoxelizer.h"

#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkObjectFactory.h"
#include "vtkProperty.h"

#include <string>

vtkStandardNewMacro(vtkLitLineVoxelizer);

namespace
{
const int NumberOfTypes = 256;

const char* NameOrNone(const char* name)
{
  return name && std::string(name) != "None" ? name : nullptr;
}
}

//------------------------------------------------------------------------------
vtkLitLineVoxelizer::vtkLitLineVoxelizer()
{
  for (int type = 0; type < NumberOfTypes; ++type)
  {
    this->SetMaterial(type, this->Material);
  }
}

//------------------------------------------------------------------------------
vtkLitLineVoxelizer::~vtkLitLineVoxelizer() = default;

//------------------------------------------------------------------------------
void vtkLitLineVoxelizer::SetAmbient(double ambient)
{
  this->Material->SetAmbient(ambient);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkLitLineVoxelizer::SetDiffuse(double diffuse)
{
  this->Material->SetDiffuse(diffuse);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkLitLineVoxelizer::SetSpecular(double specular)
{
  this->Material->SetSpecular(specular);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkLitLineVoxelizer::SetHighlightExponent(double exponent)
{
  for (int type = 0; type < NumberOfTypes; ++type)
  {
    this->SetSpecularPower(type, exponent);
  }
}

//------------------------------------------------------------------------------
void vtkLitLineVoxelizer::SetColor(double red, double green, double blue)
{
  this->Material->SetColor(red, green, blue);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkLitLineVoxelizer::SetLightDirection(double x, double y, double z)
{
  if (x == 0.0 && y == 0.0 && z == 0.0)
  {
    this->SetLights(nullptr);
    return;
  }
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(-x, -y, -z);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  vtkNew<vtkLightCollection> lights;
  lights->AddItem(light);
  this->SetLights(lights);
}

//------------------------------------------------------------------------------
void vtkLitLineVoxelizer::SelectRadiusArray(const char* name)
{
  this->SetRadiusArray(NameOrNone(name));
}

//------------------------------------------------------------------------------
void vtkLitLineVoxelizer::SelectLineTypeArray(const char* name)
{
  this->SetLineTypeArray(NameOrNone(name));
}

//------------------------------------------------------------------------------
void vtkLitLineVoxelizer::SelectColorArray(const char* name)
{
  this->SetColorArray(NameOrNone(name));
}

//------------------------------------------------------------------------------
void vtkLitLineVoxelizer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Material:\n";
  this->Material->PrintSelf(os, indent.GetNextIndent());
}
