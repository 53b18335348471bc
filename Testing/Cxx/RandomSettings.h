// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Every setting of the property, within and outside of its range: functions, VTK's own settings, and the models'.

#ifndef RandomSettings_h
#define RandomSettings_h

#include "RandomData.h"

#include "vtkContourValues.h"
#include "vtkMultiSampleClassification.h"
#include "vtkPlane.h"

namespace
{
class RandomSettings
{
public:
  RandomSettings(Dice& dice, TestScene& scene, RandomData& data)
    : Random(dice)
    , Property(scene.Property)
    , Data(data)
  {
  }

  // All of them anew.
  void Change()
  {
    for (int component = 0; component < this->Data.GetNumberOfComponents(); ++component)
    {
      this->SetFunctions(component);
      this->SetMaterial(component);
    }
    this->SetLabels();
    this->SetVTK();
    this->SetReflectance();
    this->SetIntegral();
    this->SetVisibility();
    this->SetLight();
  }

private:
  // Of a range of scalars; sometimes no finite number.
  double End()
  {
    const double odd[] = { std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::infinity(),
      1.0e300 };
    return this->Random.Is(0.03) ? this->Random.Of(odd) : this->Data.Scalar();
  }

  // One, two, some or hundreds of points.
  int CountOfPoints()
  {
    const int counts[] = { 1, 2, 5, 300 };
    return this->Random.Of(counts);
  }

  vtkSmartPointer<vtkPiecewiseFunction> Opacities()
  {
    auto function = vtkSmartPointer<vtkPiecewiseFunction>::New();
    for (int i = this->CountOfPoints(); i > 0; --i)
    {
      function->AddPoint(this->Data.Scalar(), this->Random.Is(0.3) ? 0.0 : this->Random.Between(0.0, 1.0));
    }
    return function;
  }

  vtkSmartPointer<vtkColorTransferFunction> Colors()
  {
    auto function = vtkSmartPointer<vtkColorTransferFunction>::New();
    for (int i = this->CountOfPoints(); i > 0; --i)
    {
      function->AddRGBPoint(this->Data.Scalar(), this->Random.Between(0.0, 1.0),
        this->Random.Between(0.0, 1.0), this->Random.Between(0.0, 1.0));
    }
    return function;
  }

  vtkSmartPointer<vtkPiecewiseFunction> GradientOpacities()
  {
    auto function = vtkSmartPointer<vtkPiecewiseFunction>::New();
    function->AddPoint(0.0, this->Random.Between(0.0, 1.0));
    function->AddPoint(this->Data.GetWidth(), this->Random.Between(0.0, 1.0));
    return function;
  }

  // Colour, table and depth by colour components 0 to 3 of RGBA.
  vtkSmartPointer<vtkImageData> Table()
  {
    auto table = vtkSmartPointer<vtkImageData>::New();
    table->SetDimensions(1 + this->Random.Number(64), 1 + this->Random.Number(32), 1);
    table->AllocateScalars(VTK_FLOAT, 4);
    auto* values = static_cast<float*>(table->GetScalarPointer());
    for (vtkIdType i = 0; i < 4 * table->GetNumberOfPoints(); ++i)
    {
      values[i] = static_cast<float>(this->Random.Is(0.3) ? 0.0 : this->Random.Between(0.0, 1.0));
    }
    return table;
  }

  void SetFunctions(int component)
  {
    this->Property->SetScalarOpacity(component, this->Opacities());
    if (this->Random.Is(0.1))
    {
      this->Property->SetColor(component, this->Opacities()); // as shades of grey
    }
    else
    {
      this->Property->SetColor(component, this->Colors());
    }
    const bool hasGradient = this->Random.Is(0.15);
    this->Property->SetGradientOpacity(component, hasGradient ? this->GradientOpacities() : nullptr);
    this->Property->SetDisableGradientOpacity(component, this->Random.Is(0.2));
    const bool hasTable = this->Random.Is(component == 0 ? 0.08 : 0.0);
    this->Property->SetTransferFunctionMode(hasTable ? vtkVolumeProperty::TF_2D : vtkVolumeProperty::TF_1D);
    if (hasTable)
    {
      this->Property->SetTransferFunction2D(component, this->Table());
    }
  }

  void SetMaterial(int component)
  {
    this->Property->SetScalarOpacityUnitDistance(
      component, this->Data.GetScale() * this->Random.PowerOfTen(-2.0, 2.0));
    this->Property->SetComponentWeight(component, this->Random.Between(0.0, 1.0));
    this->Property->SetShade(component, this->Random.Is(0.8));
    this->Property->SetAmbient(component, this->Random.Between(0.0, 1.0));
    this->Property->SetDiffuse(component, this->Random.Between(0.0, 1.0));
    this->Property->SetSpecular(component, this->Random.Between(0.0, 1.0));
    this->Property->SetSpecularPower(component, this->Random.Between(1.0, 128.0));
  }

  // Of labels 1 to 3, not all of which need to have functions.
  void SetLabels()
  {
    for (int label = 1; label <= 3; ++label)
    {
      if (this->Random.Is(0.3))
      {
        this->Property->SetLabelColor(label, this->Colors());
        this->Property->SetLabelScalarOpacity(label, this->Opacities());
      }
      if (this->Random.Is(0.02))
      {
        this->Property->SetLabelGradientOpacity(label, this->GradientOpacities());
      }
    }
  }

  // What blend modes other than composite need is there.
  void SetVTK()
  {
    this->Property->SetInterpolationType(this->Random.Number(2));
    this->Property->SetUseClippedVoxelIntensity(this->Random.Is(0.1));
    this->Property->SetClippedVoxelIntensity(this->Data.Scalar());
    this->Property->GetIsoSurfaceValues()->SetValue(0, this->Data.Scalar());
    vtkNew<vtkPlane> plane;
    plane->SetNormal(this->Random.Between(-1.0, 1.0), this->Random.Between(-1.0, 1.0), 1.0);
    this->Property->SetSliceFunction(plane);
  }

  void SetReflectance()
  {
    using P = vtkOpticsVolumeProperty;
    this->Property->SetReflectanceModel(this->Random.Choice(P::NumberOfReflectanceModels));
    for (int model = P::BlinnPhong; model <= P::Lafortune; ++model)
    {
      this->Property->SetGlossiness(model, this->Random.Setting(1.0e-4, model == P::Ward ? 1.0 : 1.0e5));
    }
    this->Property->SetGlossiness(this->Random.Choice(P::NumberOfReflectanceModels), 0.5); // some have none
    this->Property->SetAnisotropyScale(P::Ward, this->Random.Setting(0.0, 1.0e4));
    this->Property->SetAnisotropyScale(P::Lafortune, this->Random.Setting(0.0, 1.0e4));
    this->Property->SetSpecularFromExtinction(this->Random.Is(0.7));
    this->Property->SetFrameSource(this->Random.Choice(2));
    this->Property->SetScatteringAnisotropy(static_cast<float>(this->Random.Setting(-1.0, 1.0)));
  }

  void SetIntegral()
  {
    this->Property->SetIntegrationSpace(this->Random.Choice(2));
    this->Property->SetClassification(this->Random.Choice(2));
    this->Property->SetScalarOpacityUnitInterval(this->Data.GetWidth() * this->Random.Setting(0.0, 1.0));
    this->Property->SetSilhouette(this->Random.Choice(4));
    this->Property->SetTransmittedLight(this->Random.Choice(3));
    this->Property->RemoveAllIsosurfaces();
    const int surfaces[] = { 0, 0, 0, 0, 1, 1, 3, 3, 100, 1025 };
    for (int i = this->Random.Of(surfaces); i > 0; --i)
    {
      const double value = this->End(), opacity = this->Random.Setting(0.0, 1.0);
      this->Random.Is(0.3)
        ? this->Property->AddIsosurface(value, opacity)
        : this->Property->AddIsosurface(value, 0.9, 0.2, this->Random.Setting(0.0, 1.0), opacity);
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
    this->Property->SetLightingTransferFunction(this->Random.Is(0.25) ? this->Lighting() : nullptr);
    this->Property->SetMultiSampleClassification(this->Random.Is(0.12) ? this->Rules() : nullptr);
    this->Property->SetGradientStepLength(this->Random.Setting(0.0, 10.0));
    this->Property->SetLightScale(this->Random.Setting(0.0, 10.0));
    this->Property->SetHybridNormals(this->Random.Is(0.3));
  }

  vtkSmartPointer<vtkLightingTransferFunction> Lighting()
  {
    auto function = vtkSmartPointer<vtkLightingTransferFunction>::New();
    for (int i = this->Random.Number(5); i > 0; --i)
    {
      const double low[2] = { this->End(), this->Data.Scalar() };
      const double high[2] = { this->Data.Scalar(), this->End() };
      const int boundary = function->AddBoundary(low, high, this->Random.Setting(0.0, 1.0),
        this->Random.Setting(0.0, 1.0), this->Random.Between(0.0, 1.0));
      function->SetSoftness(boundary, this->Data.GetWidth() * this->Random.Setting(0.0, 1.0));
    }
    return function;
  }

  vtkSmartPointer<vtkMultiSampleClassification> Rules()
  {
    auto rules = vtkSmartPointer<vtkMultiSampleClassification>::New();
    for (int i = this->Random.Number(4); i > 0; --i)
    {
      const double low[2] = { this->End(), this->Data.Scalar() };
      const double high[2] = { this->Data.Scalar(), std::numeric_limits<double>::infinity() };
      const int rule = rules->AddRule(low, high, this->Random.Is(0.5) ? low : high, 0.9, 0.2,
        this->Random.Setting(0.0, 1.0), this->Random.Setting(0.0, 1.0));
      rules->SetSoftness(
        rule, this->Random.Number(3), this->Data.GetWidth() * this->Random.Setting(0.0, 1.0));
    }
    return rules;
  }

  Dice& Random;
  vtkOpticsVolumeProperty* Property;
  RandomData& Data;
};
}

#endif
