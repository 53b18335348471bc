// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// A scene by a seed: data, functions, every setting within and outside of its range, lights, camera and what cuts.

#ifndef RandomScene_h
#define RandomScene_h

#include "TestScene.h"
#include "vtkAmbientCovarianceFilter.h"

#include "vtkLight.h"
#include "vtkMatrix3x3.h"
#include "vtkMultiSampleClassification.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkTransform.h"

#include <cstdint>
#include <limits>
#include <random>

namespace
{
// The same everywhere: the library's distributions are not.
class Dice
{
public:
  explicit Dice(std::uint32_t seed)
    : Engine(seed)
  {
  }
  // In [0, count).
  int Number(int count) { return static_cast<int>(this->Engine() % static_cast<std::uint32_t>(count)); }
  bool Is(double probability) { return this->Between(0.0, 1.0) < probability; }
  double Between(double least, double largest)
  {
    return least + (largest - least) * (static_cast<double>(this->Engine()) / 4294967296.0);
  }
  double PowerOfTen(double least, double largest) { return std::pow(10.0, this->Between(least, largest)); }

  // Mostly in the range, sometimes at its ends, beyond them, or no number at all.
  double Setting(double least, double largest)
  {
    const double infinity = std::numeric_limits<double>::infinity();
    switch (this->Number(12))
    {
      case 0:
        return least;
      case 1:
        return largest;
      case 2:
        return this->Is(0.5) ? largest + 1.0 : least - 1.0;
      case 3:
        return this->Is(0.5) ? infinity : -1.0e300;
      case 4:
        return std::numeric_limits<double>::quiet_NaN();
      default:
        return this->Between(least, largest);
    }
  }
  // Of so many choices; rarely one that there is not.
  int Choice(int count) { return this->Is(0.05) ? (this->Is(0.5) ? -1 : count) : this->Number(count); }

private:
  std::mt19937 Engine;
};

class RandomScene : public TestScene
{
public:
  explicit RandomScene(std::uint32_t seed)
    : Random(seed)
  {
    this->Window->SetSize(1 + this->Random.Number(20), 1 + this->Random.Number(20));
    this->SetData();
    this->SetFunctions();
    this->SetProperty();
    this->SetVisibility();
    this->SetLight();
    this->SetKnobs();
    this->SetLights();
    this->SetVolume();
    this->SetCamera();
  }

private:
  // Along one axis up to 65 points, so that no scene takes long.
  void SetDimensions(int (&size)[3])
  {
    for (int& points : size)
    {
      points = 1 + this->Random.Number(this->Random.Is(0.1) ? 3 : 12);
    }
    if (this->Random.Is(0.2))
    {
      size[this->Random.Number(3)] = 1 + this->Random.Number(65);
    }
  }

  void SetData()
  {
    const int types[] = { VTK_FLOAT, VTK_DOUBLE, VTK_UNSIGNED_CHAR, VTK_SIGNED_CHAR, VTK_SHORT,
      VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT };
    const int type = types[this->Random.Number(8)];
    int size[3];
    this->SetDimensions(size);
    vtkNew<vtkImageData> image;
    image->SetDimensions(size);
    const double scale = this->Random.PowerOfTen(-6.0, 6.0);
    image->SetSpacing(scale * this->Random.PowerOfTen(-1.0, 1.0), scale * this->Random.PowerOfTen(-1.0, 1.0),
      scale * this->Random.PowerOfTen(-1.0, 1.0));
    image->SetOrigin(scale * this->Random.Between(-9.0, 9.0), 0.0, scale * this->Random.Between(-9.0, 9.0));
    if (this->Random.Is(0.2))
    {
      const double turned[9] = { 0.8, -0.6, 0.0, 0.6, 0.8, 0.0, 0.0, 0.0, 1.0 };
      image->SetDirectionMatrix(turned);
    }
    const int components = this->Random.Is(0.8) ? 1 : 1 + this->Random.Number(4);
    this->Property->SetIndependentComponents(components % 2 == 1 || this->Random.Is(0.2)); // as VTK demands
    image->AllocateScalars(type, components);
    this->SetRange(type);
    this->Fill(image->GetPointData()->GetScalars(), type == VTK_FLOAT || type == VTK_DOUBLE);
    this->Mapper->SetInputData(image);
    this->Property->SetScalarOpacityUnitDistance(scale * this->Random.PowerOfTen(-2.0, 2.0));
    this->Mapper->SetAutoAdjustSampleDistances(this->Random.Is(0.3));
    this->Mapper->SetSampleDistance(static_cast<float>(scale * this->Random.PowerOfTen(-1.0, 1.0)));
  }

  void SetRange(int type)
  {
    const bool isReal = type == VTK_FLOAT || type == VTK_DOUBLE;
    this->Width = isReal ? this->Random.PowerOfTen(-30.0, 30.0) : 100.0;
    this->Low = isReal && this->Random.Is(0.3) ? this->Width * this->Random.Between(-3.0, 3.0) : 0.0;
  }

  void Fill(vtkDataArray* scalars, bool isReal)
  {
    const bool isConstant = this->Random.Is(0.05);
    const bool hasHoles = isReal && this->Random.Is(0.2);
    for (vtkIdType i = 0; i < scalars->GetNumberOfValues(); ++i)
    {
      double value = this->Low + this->Width * (isConstant ? 0.5 : this->Random.Between(0.0, 1.0));
      if (hasHoles && this->Random.Is(0.1))
      {
        value = this->Random.Is(0.5) ? std::numeric_limits<double>::quiet_NaN()
                                     : std::numeric_limits<double>::infinity();
      }
      scalars->SetComponent(
        i / scalars->GetNumberOfComponents(), static_cast<int>(i % scalars->GetNumberOfComponents()), value);
    }
  }

  double Scalar() { return this->Low + this->Width * this->Random.Between(-0.2, 1.2); }

  // One, two, some or hundreds of points.
  void SetFunctions()
  {
    const int counts[] = { 1, 2, 5, 300 };
    this->Opacity->RemoveAllPoints();
    this->Color->RemoveAllPoints();
    for (int i = counts[this->Random.Number(4)]; i > 0; --i)
    {
      this->Opacity->AddPoint(this->Scalar(), this->Random.Is(0.3) ? 0.0 : this->Random.Between(0.0, 1.0));
    }
    for (int i = counts[this->Random.Number(4)]; i > 0; --i)
    {
      this->Color->AddRGBPoint(this->Scalar(), this->Random.Between(0.0, 1.0), this->Random.Between(0.0, 1.0),
        this->Random.Between(0.0, 1.0));
    }
    if (this->Random.Is(0.15))
    {
      vtkNew<vtkPiecewiseFunction> gradient;
      gradient->AddPoint(0.0, this->Random.Between(0.0, 1.0));
      gradient->AddPoint(this->Width, 1.0);
      this->Property->SetGradientOpacity(gradient);
    }
  }

  void SetProperty()
  {
    this->Property->SetReflectanceModel(
      this->Random.Choice(vtkOpticsVolumeProperty::NumberOfReflectanceModels));
    this->Property->SetShade(this->Random.Is(0.8));
    for (int model = vtkOpticsVolumeProperty::BlinnPhong; model <= vtkOpticsVolumeProperty::Lafortune;
         ++model)
    {
      this->Property->SetGlossiness(model, this->Random.Setting(1.0e-4, model == 3 ? 1.0 : 1.0e5));
    }
    this->Property->SetAnisotropyScale(vtkOpticsVolumeProperty::Ward, this->Random.Setting(0.0, 1.0e4));
    this->Property->SetAnisotropyScale(vtkOpticsVolumeProperty::Lafortune, this->Random.Setting(0.0, 1.0e4));
    this->Property->SetSpecularFromExtinction(this->Random.Is(0.7));
    this->Property->SetFrameSource(this->Random.Choice(2));
    this->Property->SetScatteringAnisotropy(static_cast<float>(this->Random.Setting(-1.0, 1.0)));
    this->Property->SetSpecular(this->Random.Between(0.0, 1.0));
    this->Property->SetSpecularPower(this->Random.Between(1.0, 128.0));
    this->Property->SetInterpolationType(this->Random.Number(2));
    this->Property->SetIntegrationSpace(this->Random.Choice(2));
    this->Property->SetClassification(this->Random.Choice(2));
    this->Property->SetScalarOpacityUnitInterval(this->Width * this->Random.Setting(0.0, 1.0));
    this->Property->SetSilhouette(this->Random.Choice(4));
    this->Property->SetTransmittedLight(this->Random.Choice(3));
    const int surfaces[] = { 0, 0, 1, 3, 100 };
    for (int i = surfaces[this->Random.Number(5)]; i > 0; --i)
    {
      const double opacity = this->Random.Setting(0.0, 1.0);
      this->Property->AddIsosurface(this->Scalar(), 0.9, 0.2, this->Random.Setting(0.0, 1.0), opacity);
    }
  }

  void SetVisibility()
  {
    this->Property->SetOcclusion(this->Random.Is(0.25));
    this->Property->SetOcclusionAngle(this->Random.Setting(0.0, 80.0));
    this->Property->SetShadows(this->Random.Is(0.25));
    this->Property->SetShadowAngle(this->Random.Is(0.5) ? 0.0 : this->Random.Setting(0.0, 80.0));
    if (this->Random.Is(0.2))
    {
      this->Property->SetAmbientColor(
        this->Random.Setting(0.0, 1.0), this->Random.Setting(0.0, 1.0), this->Random.Setting(0.0, 1.0));
    }
  }

  void SetLight()
  {
    const double low[2] = { this->Scalar(), this->Scalar() }, high[2] = { this->Scalar(), this->Scalar() };
    if (this->Random.Is(0.25))
    {
      vtkNew<vtkLightingTransferFunction> function;
      function->AddBoundary(low, high, 0.2, this->Random.Setting(0.0, 1.0), this->Random.Between(0.0, 1.0));
      this->Property->SetLightingTransferFunction(function);
    }
    if (this->Random.Is(0.15))
    {
      vtkNew<vtkMultiSampleClassification> rules;
      rules->AddRule(
        low, high, high, 0.9, 0.2, this->Random.Setting(0.0, 1.0), this->Random.Between(0.0, 1.0));
      this->Property->SetMultiSampleClassification(rules);
    }
    this->Property->SetGradientStepLength(this->Random.Setting(0.0, 10.0));
    this->Property->SetLightScale(this->Random.Setting(0.0, 10.0));
    this->Property->SetHybridNormals(this->Random.Is(0.3));
  }

  void SetKnobs()
  {
    const int bits[] = { 8, 16, 32, 7 }, samples[] = { 4, 8, 16, 5 };
    this->Optics->SetFrameResolutionFactor(this->Random.Setting(0.25, 1.0));
    this->Optics->SetFramePrecision(bits[this->Random.Number(4)]);
    this->Optics->GetAmbientCovarianceFilter()->SetStorage(this->Random.Choice(3));
    this->Optics->SetExtinctionGradient(this->Random.Number(2));
    this->Optics->SetScalarGradient(this->Random.Number(3));
    this->Optics->SetLightingTableSize(1 + this->Random.Number(300));
    this->Optics->SetLightingSamples(this->Random.Number(2));
    this->Optics->SetPreIntegrationTableSize(this->Random.Number(300));
    this->Optics->SetTablePrecision(bits[this->Random.Number(4)]);
    this->Optics->SetVisibilityGridSize(this->Random.Number(24));
    this->Optics->SetVisibilitySliceDistance(this->Random.Setting(0.5, 10.0));
    this->Optics->SetVisibilitySamples(samples[this->Random.Number(4)]);
    this->Optics->SetVisibilityAlgorithm(this->Random.Number(3));
    this->Optics->SetVisibilityPrecision(bits[this->Random.Number(4)]);
    this->Optics->SetSkipEmptySpace(this->Random.Is(0.5));
    this->Optics->SetMacrocellSize(this->Random.Number(12));
    this->Mapper->SetUseJittering(this->Random.Is(0.3));
  }

  void SetLights()
  {
    const double* center = this->Mapper->GetCenter();
    const double size = std::max(this->Mapper->GetLength(), 1.0e-30);
    for (int i = this->Random.Number(4); i > 0; --i)
    {
      vtkNew<vtkLight> light;
      light->SetLightType(1 + this->Random.Number(3));
      const double reach = size * this->Random.PowerOfTen(-1.0, 1.0);
      light->SetPosition(center[0] + reach * this->Random.Between(-1.0, 1.0),
        center[1] + reach * this->Random.Between(-1.0, 1.0),
        center[2] + reach * this->Random.Between(-1.0, 1.0));
      light->SetFocalPoint(center[0], center[1], center[2]);
      light->SetPositional(this->Random.Is(0.5));
      light->SetConeAngle(this->Random.Between(1.0, 180.0));
      light->SetIntensity(this->Random.Between(0.0, 2.0));
      light->SetAttenuationValues(this->Random.Number(2), this->Random.Between(0.0, 1.0) / size, 0.0);
      light->SetShadowAttenuation(static_cast<float>(this->Random.Between(0.0, 1.0)));
      this->Renderer->AddLight(light);
    }
    this->Renderer->SetTwoSidedLighting(this->Random.Is(0.7));
  }

  void SetVolume()
  {
    const double* center = this->Mapper->GetCenter();
    const double size = this->Mapper->GetLength();
    if (this->Random.Is(0.2))
    {
      vtkNew<vtkTransform> transform;
      transform->RotateWXYZ(this->Random.Between(0.0, 360.0), 1.0, 2.0, 3.0);
      transform->Scale(this->Random.PowerOfTen(-1.0, 1.0), 1.0, this->Random.Is(0.3) ? -1.0 : 1.0);
      this->Volume->SetUserTransform(transform);
    }
    if (this->Random.Is(0.2))
    {
      this->Mapper->SetCropping(1);
      this->Mapper->SetCroppingRegionPlanes(center[0] - 0.2 * size, center[0] + 0.1 * size,
        center[1] - 0.1 * size, center[1] + 0.2 * size, center[2] - 0.1 * size, center[2] + 0.1 * size);
      this->Mapper->SetCroppingRegionFlags(this->Random.Number(1 << 27));
    }
    if (this->Random.Is(0.2))
    {
      vtkNew<vtkPlane> plane;
      plane->SetOrigin(center[0], center[1], center[2]);
      plane->SetNormal(this->Random.Between(-1.0, 1.0), this->Random.Between(-1.0, 1.0), 1.0);
      this->Mapper->AddClippingPlane(plane);
    }
    this->Mapper->SetBlendMode(this->Random.Is(0.9) ? 0 : this->Random.Number(4));
  }

  void SetCamera()
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(this->Random.Between(-1.0, 1.0), this->Random.Between(-1.0, 1.0), 1.0);
    camera->SetViewUp(0.0, 1.0, 0.0);
    camera->SetParallelProjection(this->Random.Is(0.3));
    this->Renderer->ResetCamera();
    camera->Dolly(this->Random.Is(0.3) ? this->Random.PowerOfTen(0.0, 1.5) : 1.0); // into the volume, too
    this->Renderer->ResetCameraClippingRange();
  }

  Dice Random;
  double Low = 0.0;
  double Width = 1.0;
};
}

#endif
