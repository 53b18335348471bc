// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Lights and material of lines, and the light that a cylinder sends to a viewer.

#ifndef LineLighting_h
#define LineLighting_h

#include <glm/glm.hpp>

#include <vector>

class vtkLightCollection;
class vtkProperty;

namespace volumeoptics
{
// Directional, as in [Schussman2004].
struct LineLight
{
  enum KindType
  {
    Headlight = 0, // along the view direction
    FixedToEye,    // direction in the eye's frame: right, up, to the viewer
    FixedInWorld
  };
  int Kind = Headlight;
  glm::dvec3 Direction = glm::dvec3(0.0, 0.0, 1.0); // to the light
  glm::dvec3 Diffuse = glm::dvec3(1.0);
  glm::dvec3 Specular = glm::dvec3(1.0);
};

// Those that are on; without a collection one white headlight.
std::vector<LineLight> ReadLights(vtkLightCollection* lights);

// Direction to the light for a view direction. viewUp fixes the eye's frame.
glm::dvec3 DirectionToLight(const LineLight& light, const glm::dvec3& toViewer, const glm::dvec3& viewUp);

// Coefficients times colours; Ambient times the ambient light, too.
struct LineMaterial
{
  glm::dvec3 Ambient = glm::dvec3(0.0);
  glm::dvec3 Diffuse = glm::dvec3(1.0);
  glm::dvec3 Specular = glm::dvec3(0.0);
  double Exponent = 1.0; // in [1, 1000]
};

// hasColors: the lines bring colours for ambient and diffuse light.
LineMaterial ReadMaterial(vtkProperty* property, const glm::dvec3& ambientLight, bool hasColors);

// Integrals of cos^(exponent + 1) from a table, linear between 4096 angles.
class CosinePowerTable
{
public:
  explicit CosinePowerTable(double exponent);
  double Integral(double from, double to) const { return this->At(to) - this->At(from); }

private:
  double At(double angle) const;
  std::vector<double> Values;
};

// Mean radiance over the visible side of a cylinder for light 1 and coefficients 1.
struct CylinderRadiance
{
  double Diffuse;
  double Specular;
};

CylinderRadiance RadianceOfCylinder(const glm::dvec3& tangent, const glm::dvec3& toViewer,
  const glm::dvec3& toLight, double exponent, const CosinePowerTable& table);
}

#endif
