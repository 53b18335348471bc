// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Everything a picture depends on: volume, optics, lights, camera, quadrature.
//
// All of it is in dataset space but for the distance to positional lights, which is measured in the
// world. A volume's matrix may move, turn and scale alike along all axes; other matrices bend angles,
// which is not modelled.

#ifndef Scene_h
#define Scene_h

#include "FrameField.h"

#include "vtkColorTransferFunction.h"
#include "vtkLightingTransferFunction.h"
#include "vtkMultiSampleClassification.h"
#include "vtkPiecewiseFunction.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <memory>
#include <vector>

class vtkRenderer;
class vtkVolume;

namespace reference
{
// As vtkOpticsVolumeProperty::ReflectanceModelType.
enum class Reflectance
{
  VTK = 0,
  None,
  BlinnPhong,
  Ward,
  Lafortune
};

// Where the extinction's gradient comes from.
enum class GradientEstimate
{
  StoredNormal = 0,  // normal and magnitude of the scalar, sign and size from the opacity function
  CentralDifferences // of the classified optical depth over one voxel, [Ament2015]'s way
};

// As vtkOpticsVolumeProperty's choices of these names.
enum class IntegrationSpace
{
  Physical = 0,
  Data
};
enum class Classification
{
  Post = 0,
  PreIntegrated // by quadrature between two samples, without a table
};
enum class Silhouette
{
  Off = 0,
  Exact,
  Clamped,
  Gradient
};
enum class TransmittedLight
{
  Off = 0,
  Diffuse,
  DiffuseAndSpecular
};

// Infinitely thin: a ray meets it where the field has this value.
struct Isosurface
{
  double value = 0.0;
  Vector color = Vector(1.0);
  double opacity = 0.5;
};

struct Light
{
  bool positional = false;
  bool headlight = false;
  Vector toLight = Vector(0.0, 0.0, 1.0); // unit, of a directional light
  Vector position = Vector(0.0);
  Vector coneAxis = Vector(0.0, 0.0, -1.0); // unit, away from a positional light
  double coneAngle = 180.0;                 // half angle in degrees; above 90 there is no cone
  double exponent = 1.0;
  Vector attenuation = Vector(1.0, 0.0, 0.0); // constant, linear, quadratic; per world length
  double shadowAttenuation = 1.0;             // of its light, in a full shadow
  Vector ambient = Vector(0.0);               // colours times intensity
  Vector diffuse = Vector(1.0);
  Vector specular = Vector(1.0);
};

// A pinhole or a parallel camera by the matrix that takes normalised device coordinates to dataset
// space.
struct Camera
{
  glm::dmat4 deviceToDataset = glm::dmat4(1.0);
  Vector eye = Vector(0.0);
  int width = 1;
  int height = 1;
  double nearOffset = 0.0; // rays begin so far behind the near plane, in dataset space
};

struct Scene
{
  std::shared_ptr<const Field> field;
  std::shared_ptr<const FrameField> frames; // may be null for the models VTK and None
  Grid grid;                                // where the field is drawn, and its voxels
  double worldScale = 1.0;                  // world length of a length of dataset space
  Camera camera;
  std::vector<Light> lights;
  bool twoSided = true;

  vtkSmartPointer<vtkPiecewiseFunction> opacity; // per unitDistance
  vtkSmartPointer<vtkColorTransferFunction> color;
  double unitDistance = 1.0; // VTK's ScalarOpacityUnitDistance
  bool shade = false;
  double ambient = 0.1;
  double diffuse = 0.7;
  double specular = 0.2;
  double specularPower = 10.0;
  Reflectance reflectance = Reflectance::VTK;
  double glossiness = 30.0;      // of the current model
  double anisotropyScale = 10.0; // gamma
  double scatteringAnisotropy = 0.0;
  bool specularFromExtinction = true;
  GradientEstimate gradientEstimate = GradientEstimate::StoredNormal;

  vtkSmartPointer<vtkLightingTransferFunction> lighting;
  vtkSmartPointer<vtkMultiSampleClassification> rules; // in physical space alone
  // Of the scalar, along which lighting and rules look: of the frames, or of the field.
  GradientEstimate pairGradient = GradientEstimate::CentralDifferences;
  double gradientStepLength = 1.0; // in units of the smallest spacing
  double lightScale = 1.0;
  bool hybridNormals = false;
  double densityFade = 1.0; // difference of opacities over which light changes sides

  IntegrationSpace integrationSpace = IntegrationSpace::Physical;
  Classification classification = Classification::Post;
  double unitInterval = 0.0; // of data, that opacities belong to; 0: a hundredth of the function's range
  std::vector<Isosurface> isosurfaces;
  Silhouette silhouette = Silhouette::Off; // of surfaces, and of everything in data space
  TransmittedLight transmittedLight = TransmittedLight::Off;

  // Share of the ambient light that reaches a point in front of the eye, [Schott2009] eq. 10; empty: all of it.
  std::function<double(const Vector& point, const Vector& toViewer)> visibility;
  Vector ambientColor = Vector(1.0); // radiance of the ambient light
  // Share of a light that reaches a point; empty: all of it.
  std::function<double(const Light& light, const Vector& point)> shadow;

  double step = 1.0;
  // Where the first sample lies, in steps behind the entry: 1 as VTK, 0.5 for the midpoint rule.
  double firstSample = 1.0;
  bool terminatesEarly = true; // at an opacity of 1 - 1/255, as VTK
  // Above 0: where the integral goes by segments, each is halved until the field in its middle is the mean of
  // its ends up to this fraction of the opacity function's range. Pre-integrated, that is the truth.
  double linearity = 0.0;

  double RangeOfOpacity() const; // of the function's nodes; 1 if it has only one
  double EffectiveUnitInterval() const;
  double Opacity(double scalar) const { return this->opacity->GetValue(scalar); }
  Vector Color(double scalar) const;
};

// The scene of a renderer with one volume, whose input is an image: camera, lights, matrix, property
// (also those of vtkOpticsVolumeProperty), sample distance of the mapper. Exact or stored frames are
// the caller's to set; the field is the image's. Call it after Render(), so that lights follow.
Scene SceneFromVTK(vtkRenderer* renderer, vtkVolume* volume, int width, int height);
}

#endif
