// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Rows of docs/support.md: a name, and what makes of a TestScene a scene with that setting.

#ifndef SupportedSettings_h
#define SupportedSettings_h

#include "TestScene.h"

#include "vtkActor.h"
#include "vtkCellData.h"
#include "vtkConeSource.h"
#include "vtkContourValues.h"
#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkLODProp3D.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"
#include "vtkTransform.h"
#include "vtkUnsignedCharArray.h"

#include <functional>

namespace
{
using Setting = std::function<void(TestScene&)>;

inline vtkSmartPointer<vtkImageData> Field(TestScene& scene)
{
  scene.Source->Update();
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->ShallowCopy(scene.Source->GetOutput());
  return image;
}

// 0 below the middle plane, 255 above.
inline vtkSmartPointer<vtkImageData> Mask(TestScene& scene, unsigned char inside)
{
  auto mask = vtkSmartPointer<vtkImageData>::New();
  vtkSmartPointer<vtkImageData> field = Field(scene);
  mask->CopyStructure(field);
  vtkNew<vtkUnsignedCharArray> values;
  values->SetNumberOfTuples(field->GetNumberOfPoints());
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    values->SetValue(i, field->GetPoint(i)[0] > 0.0 ? inside : 0);
  }
  mask->GetPointData()->SetScalars(values);
  return mask;
}

inline void UseCellData(TestScene& scene)
{
  vtkSmartPointer<vtkImageData> points = Field(scene);
  vtkNew<vtkImageData> cells;
  cells->CopyStructure(points);
  const int* size = points->GetDimensions();
  cells->SetDimensions(size[0] + 1, size[1] + 1, size[2] + 1);
  cells->GetCellData()->SetScalars(points->GetPointData()->GetScalars());
  scene.Mapper->SetInputData(cells);
}

// Luminance and opacity, or colour and opacity, as components that belong together.
inline void UseDependentComponents(TestScene& scene, int components)
{
  vtkSmartPointer<vtkImageData> image = Field(scene);
  vtkNew<vtkUnsignedCharArray> values;
  values->SetNumberOfComponents(components);
  values->SetNumberOfTuples(image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    const double scalar = image->GetPointData()->GetScalars()->GetComponent(i, 0);
    for (int c = 0; c < components; ++c)
    {
      values->SetComponent(i, c, std::floor(255.0 * (c == components - 1 ? scalar : 0.3 + 0.2 * c)));
    }
  }
  image->GetPointData()->SetScalars(values);
  scene.Mapper->SetInputData(image);
  scene.Property->IndependentComponentsOff();
  scene.Property->SetScalarOpacityUnitDistance(components - 1, 0.05);
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(100.0, 0.0);
  scene.Opacity->AddPoint(150.0, 0.9);
  scene.Color->AddRGBPoint(255.0, 0.9, 0.7, 0.5);
}

// Points of one half of the volume are hidden.
inline void Blank(TestScene& scene)
{
  vtkSmartPointer<vtkImageData> image = Field(scene);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfTuples(image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < ghosts->GetNumberOfTuples(); ++i)
  {
    ghosts->SetValue(i, image->GetPoint(i)[2] > 0.1 ? vtkDataSetAttributes::HIDDENPOINT : 0);
  }
  image->GetPointData()->AddArray(ghosts);
  scene.Mapper->SetInputData(image);
}

// A turn by 30 degrees about the axis z.
inline void Rotate(vtkMatrix3x3* matrix)
{
  matrix->SetElement(0, 0, 0.8660254037844386);
  matrix->SetElement(0, 1, -0.5);
  matrix->SetElement(1, 0, 0.5);
  matrix->SetElement(1, 1, 0.8660254037844386);
}

inline void UseDirectionMatrix(TestScene& scene)
{
  vtkSmartPointer<vtkImageData> image = Field(scene);
  vtkNew<vtkMatrix3x3> direction;
  Rotate(direction);
  double* origin = image->GetOrigin();
  double turned[3];
  direction->MultiplyPoint(origin, turned);
  image->SetDirectionMatrix(direction);
  image->SetOrigin(turned);
  scene.Mapper->SetInputData(image);
}

// The same turn as UseDirectionMatrix, of the volume instead of the image.
inline void UseRotation(TestScene& scene)
{
  vtkNew<vtkMatrix3x3> direction;
  Rotate(direction);
  vtkNew<vtkMatrix4x4> matrix;
  for (int i = 0; i < 9; ++i)
  {
    matrix->SetElement(i / 3, i % 3, direction->GetElement(i / 3, i % 3));
  }
  scene.Volume->SetUserMatrix(matrix);
}

inline void Use2DFunction(TestScene& scene)
{
  vtkNew<vtkImageData> table;
  table->SetDimensions(64, 32, 1);
  table->AllocateScalars(VTK_FLOAT, 4);
  for (int y = 0; y < 32; ++y)
  {
    for (int x = 0; x < 64; ++x)
    {
      auto* texel = static_cast<float*>(table->GetScalarPointer(x, y, 0));
      texel[0] = 0.9F;
      texel[1] = 0.6F;
      texel[2] = 0.3F;
      texel[3] = x > 30 ? 0.3F + 0.01F * y : 0.0F;
    }
  }
  scene.Property->SetTransferFunctionMode(vtkVolumeProperty::TF_2D);
  scene.Property->SetTransferFunction2D(table);
}

inline vtkSmartPointer<vtkActor> AddCone(TestScene& scene)
{
  vtkNew<vtkConeSource> cone;
  cone->SetCenter(0.2, -0.3, 0.0);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(cone->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  scene.Renderer->AddActor(actor);
  return actor;
}

inline void PeelDepth(TestScene& scene)
{
  AddCone(scene)->GetProperty()->SetOpacity(0.4);
  scene.Renderer->UseDepthPeelingOn();
  scene.Renderer->UseDepthPeelingForVolumesOn();
  scene.Window->SetAlphaBitPlanes(1);
}

inline void UseLevelOfDetail(TestScene& scene)
{
  vtkNew<vtkLODProp3D> prop;
  prop->AddLOD(scene.Mapper, scene.Property, 0.0);
  scene.Renderer->RemoveVolume(scene.Volume);
  scene.Renderer->AddViewProp(prop);
}

struct Row
{
  const char* Name;
  Setting Apply;
};

const Row Rows[] = {
  { "plain", [](TestScene&) {} },
  { "cropping",
    [](TestScene& scene) {
      scene.Mapper->SetCropping(1);
      scene.Mapper->SetCroppingRegionPlanes(-0.1, 0.5, -0.3, 0.3, -0.4, 0.6);
      scene.Mapper->SetCroppingRegionFlagsToInvertedCross();
    } },
  { "clipping planes",
    [](TestScene& scene) {
      vtkNew<vtkPlane> plane;
      plane->SetNormal(1.0, 0.2, 0.0);
      vtkNew<vtkPlaneCollection> planes;
      planes->AddItem(plane);
      scene.Mapper->SetClippingPlanes(planes);
    } },
  { "2D transfer function", Use2DFunction },
  { "gradient opacity",
    [](TestScene& scene) {
      vtkNew<vtkPiecewiseFunction> function;
      function->AddPoint(0.0, 0.5);
      function->AddPoint(0.3, 1.0);
      scene.Property->SetGradientOpacity(function);
    } },
  { "jitter", [](TestScene& scene) { scene.Mapper->SetUseJittering(1); } },
  { "parallel projection",
    [](TestScene& scene) {
      scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
      scene.Renderer->GetActiveCamera()->SetParallelScale(1.0);
    } },
  { "camera inside",
    [](TestScene& scene) {
      scene.Renderer->GetActiveCamera()->SetPosition(0.6, 0.1, 0.1);
      scene.Renderer->ResetCameraClippingRange();
    } },
  { "opaque geometry", [](TestScene& scene) { AddCone(scene); } },
  { "depth peeling", PeelDepth },
  { "LOD actor", UseLevelOfDetail },
  { "stereo",
    [](TestScene& scene) {
      scene.Window->SetStereoTypeToAnaglyph();
      scene.Window->StereoRenderOn();
    } },
  { "image sample distance", [](TestScene& scene) { scene.Mapper->SetImageSampleDistance(2.0F); } },
  { "partitions",
    [](TestScene& scene) {
      vtkOpenGLGPUVolumeRayCastMapper::SafeDownCast(scene.Mapper)->SetPartitions(2, 1, 2);
    } },
  { "user matrix",
    [](TestScene& scene) {
      vtkNew<vtkTransform> transform;
      transform->RotateWXYZ(40.0, 1.0, 2.0, 3.0);
      transform->Scale(1.2, 0.8, 1.0);
      scene.Volume->SetUserTransform(transform);
    } },
  { "direction matrix", UseDirectionMatrix },
  { "blanked points", Blank },
  { "cell data", UseCellData },
  { "binary mask",
    [](TestScene& scene) {
      scene.Mapper->SetMaskTypeToBinary();
      scene.Mapper->SetMaskInput(Mask(scene, 255));
    } },
  { "label map",
    [](TestScene& scene) {
      scene.Mapper->SetMaskTypeToLabelMap();
      scene.Mapper->SetMaskInput(Mask(scene, 1));
      vtkNew<vtkColorTransferFunction> color;
      color->AddRGBPoint(0.0, 0.1, 0.9, 0.1);
      scene.Property->SetLabelColor(1, color);
      vtkNew<vtkPiecewiseFunction> opacity;
      opacity->AddPoint(0.3, 0.0);
      opacity->AddPoint(0.5, 0.3);
      scene.Property->SetLabelScalarOpacity(1, opacity);
    } },
  { "luminance and opacity", [](TestScene& scene) { UseDependentComponents(scene, 2); } },
  { "colour and opacity", [](TestScene& scene) { UseDependentComponents(scene, 4); } },
  { "depth pass",
    [](TestScene& scene) {
      scene.Mapper->SetUseDepthPass(1);
      scene.Mapper->GetDepthPassContourValues()->SetValue(0, 0.4);
    } },
  { "final colour window",
    [](TestScene& scene) {
      scene.Mapper->SetFinalColorWindow(0.7F);
      scene.Mapper->SetFinalColorLevel(0.6F);
    } },
  { "shader property",
    [](TestScene& scene) {
      scene.Volume->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Cropping::Exit", true,
        "//VTK::Cropping::Exit\n  g_fragColor.rgb = 0.5 * g_fragColor.grb;\n", false);
    } },
  { "two viewports",
    [](TestScene& scene) {
      scene.Renderer->SetViewport(0.5, 0.0, 1.0, 1.0);
      vtkNew<vtkRenderer> other;
      other->SetViewport(0.0, 0.0, 0.5, 1.0);
      scene.Window->AddRenderer(other);
    } },
};
}

#endif
