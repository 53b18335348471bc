// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The integral within what VTK makes of a scene: sample distances that it adjusts, ranges of the functions,
// depths, translucent geometry, components.

#include "TestScene.h"

#include "vtkActor.h"
#include "vtkFloatArray.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

namespace
{
const int Size = 24;

// The last component rises along y from 0 to 1, one before it along x; within [-0.5, 0.5]^3.
void UseRamps(TestScene& scene, int components)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(Size, Size, Size);
  image->SetSpacing(1.0 / (Size - 1), 1.0 / (Size - 1), 1.0 / (Size - 1));
  image->SetOrigin(-0.5, -0.5, -0.5);
  vtkNew<vtkFloatArray> values;
  values->SetNumberOfComponents(components);
  values->SetNumberOfTuples(image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    values->SetComponent(i, 0, image->GetPoint(i)[0] + 0.5);
    values->SetComponent(i, components - 1, image->GetPoint(i)[1] + 0.5);
  }
  image->GetPointData()->SetScalars(values);
  scene.Mapper->SetInputData(image);
}

// Parallel rays along y, within the face; nothing but isosurfaces is seen.
void LookAlongY(TestScene& scene)
{
  scene.Window->SetSize(20, 20);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(0.0, -2.5, 0.0);
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.4);
  scene.Renderer->ResetCameraClippingRange();
  scene.Renderer->SetBackground(0.0, 0.0, 0.0);
  scene.Property->ShadeOff();
  scene.Property->SetIntegrationSpaceToData();
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(0.0, 0.0);
  scene.Opacity->AddPoint(1.0, 0.0);
}

// Colours of long segments depend on their length: the table's is the length that VTK steps by.
void CheckAdjustedDistances(Check& check)
{
  const auto draw = [](bool adjusts, bool locks, double distance) {
    TestScene scene;
    scene.Window->SetSize(40, 40);
    scene.Source->SetDimensions(8, 8, 8);
    scene.Opacity->RemoveAllPoints();
    scene.Opacity->AddPoint(0.0, 0.5);
    scene.Color->RemoveAllPoints();
    scene.Color->AddRGBPoint(0.0, 1.0, 0.0, 0.0);
    scene.Color->AddRGBPoint(1.0, 0.0, 1.0, 0.0);
    scene.Property->SetScalarOpacityUnitDistance(0.05);
    scene.Property->ShadeOff();
    scene.Property->SetClassificationToPreIntegrated();
    scene.Volume->SetScale(1.0, 2.0, 1.5);
    scene.Mapper->SetAutoAdjustSampleDistances(adjusts);
    scene.Mapper->SetLockSampleDistanceToInputSpacing(locks);
    scene.Mapper->SetSampleDistance(static_cast<float>(distance));
    return scene.Render();
  };
  TestScene scene;
  scene.Source->SetDimensions(8, 8, 8);
  scene.Source->Update();
  const double spacing = scene.Source->GetOutput()->GetSpacing()[0];
  const std::vector<unsigned char> expected = draw(false, false, spacing);
  check.AtMost("codes by the adjusted distance", LargestDifference(draw(true, false, 0.001), expected), 1.0);
  const double locked = 0.5 * spacing * (0.01 + 0.0099 * std::pow(343.0, 0.333)); // VTK's, for 7^3 cells
  check.AtMost("codes by the locked distance",
    LargestDifference(draw(false, true, 1.0), draw(false, false, locked)), 1.0);
}

// VTK stretches a function whose range type is NATIVE over the data's range.
void CheckColorRange(Check& check)
{
  const auto draw = [](vtkGPUVolumeRayCastMapper* mapper, int type, bool preIntegrated) {
    TestScene scene(mapper);
    scene.Window->SetSize(24, 24);
    scene.Color->RemoveAllPoints();
    scene.Color->AddRGBPoint(0.45, 1.0, 0.0, 0.2);
    scene.Color->AddRGBPoint(0.55, 0.0, 1.0, 0.4);
    scene.Opacity->RemoveAllPoints();
    scene.Opacity->AddPoint(0.0, 0.0);
    scene.Opacity->AddPoint(1.0, 0.3);
    scene.Property->ShadeOff();
    scene.Property->SetClassification(preIntegrated ? 1 : 0);
    scene.Mapper->SetSampleDistance(0.01F);
    scene.Mapper->SetColorRangeType(type);
    return scene.Render();
  };
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> stock;
  const std::vector<unsigned char> expected = draw(stock, vtkGPUVolumeRayCastMapper::NATIVE, false);
  // VTK's sum, and its table of 8 bits or more
  check.AtMost("codes of native colours",
    LargestDifference(draw(nullptr, vtkGPUVolumeRayCastMapper::NATIVE, true), expected), 4.0);
  check.AtLeast("codes of the data's colours",
    LargestDifference(draw(nullptr, vtkGPUVolumeRayCastMapper::SCALAR, true), expected), 20.0);
}

// So are functions of one node, which have no range.
void CheckOneNode(Check& check)
{
  const auto draw = [](vtkGPUVolumeRayCastMapper* mapper, bool preIntegrated) {
    TestScene scene(mapper);
    scene.Window->SetSize(24, 24);
    scene.Color->RemoveAllPoints();
    scene.Color->AddRGBPoint(0.45, 1.0, 0.5, 0.2);
    scene.Opacity->RemoveAllPoints();
    scene.Opacity->AddPoint(0.7, 0.1);
    scene.Property->ShadeOff();
    scene.Property->SetClassification(preIntegrated ? 1 : 0);
    scene.Mapper->SetSampleDistance(0.01F);
    scene.Mapper->SetColorRangeType(vtkGPUVolumeRayCastMapper::NATIVE);
    scene.Mapper->SetScalarOpacityRangeType(vtkGPUVolumeRayCastMapper::NATIVE);
    return scene.Render();
  };
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> stock;
  // VTK's sum, and its table of 8 bits or more
  check.AtMost(
    "codes of functions of one node", LargestDifference(draw(nullptr, true), draw(stock, false)), 4.0);
}

// VTK takes the depth where something is seen: that of the isosurface, not that of a sample.
void CheckDepth(Check& check)
{
  for (const double value : { 0.3, 0.5, 0.77 })
  {
    TestScene scene;
    UseRamps(scene, 1);
    LookAlongY(scene);
    scene.Property->AddIsosurface(value, 1.0, 1.0, 1.0, 0.5);
    scene.Property->AddIsosurface(value + 0.05, 1.0, 1.0, 1.0, 0.5);
    scene.Mapper->SetSampleDistance(0.15F);
    scene.Mapper->SetRenderToImage(1);
    scene.Window->Render();
    vtkNew<vtkImageData> depths;
    scene.Mapper->GetDepthImage(depths);
    const double* range = scene.Renderer->GetActiveCamera()->GetClippingRange();
    // for depths VTK takes texture coordinates, which count from half a voxel outside, for places in the box
    const double y = (value * (Size - 1) + 0.5) / Size - 0.5;
    const double expected = (2.5 + y - range[0]) / (range[1] - range[0]);
    double found[2];
    depths->GetPointData()->GetScalars()->GetRange(found);
    const double unit = depths->GetScalarType() == VTK_UNSIGNED_CHAR ? 255.0 : 1.0;
    const double tolerance = unit > 1.0 ? 1.0 / 255.0 : 1.0e-5;
    check.Near("least depth of the isosurface", found[0] / unit, expected, tolerance);
    check.Near("largest depth of the isosurface", found[1] / unit, expected, tolerance);
  }
}

// A black, translucent plane in the volume, a black isosurface close before and a white one close behind it.
void CheckPeeling(Check& check)
{
  for (const double place : { -0.31, -0.2, -0.06, 0.1, 0.24 })
  {
    TestScene scene;
    UseRamps(scene, 1);
    LookAlongY(scene);
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(-2.0, place, -2.0);
    plane->SetPoint1(2.0, place, -2.0);
    plane->SetPoint2(-2.0, place, 2.0);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(plane->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(0.0, 0.0, 0.0);
    actor->GetProperty()->SetOpacity(0.25);
    actor->GetProperty()->LightingOff();
    scene.Renderer->AddActor(actor);
    scene.Renderer->UseDepthPeelingOn();
    scene.Renderer->UseDepthPeelingForVolumesOn();
    scene.Window->SetAlphaBitPlanes(1);
    scene.Property->AddIsosurface(place + 0.5 - 0.03, 0.0, 0.0, 0.0, 0.5);
    scene.Property->AddIsosurface(place + 0.5 + 0.02, 1.0, 1.0, 1.0, 0.8);
    scene.Mapper->SetSampleDistance(0.2F);
    const std::vector<unsigned char> pixels = scene.Render();
    const auto range = std::minmax_element(pixels.begin(), pixels.end());
    // each counts once; peeling rounds to codes twice
    const double expected = 255.0 * 0.5 * 0.75 * 0.8;
    check.Near("least code behind the plane", *range.first, expected, 1.5);
    check.Near("largest code behind the plane", *range.second, expected, 1.5);
  }
}

// The isosurface is of component 1, its colour the colour function's at component 0: along x.
void CheckColorOfFirst(Check& check)
{
  for (const bool preIntegrated : { false, true })
  {
    TestScene scene;
    UseRamps(scene, 2);
    LookAlongY(scene);
    scene.Property->IndependentComponentsOff();
    scene.Property->SetClassification(preIntegrated ? 1 : 0);
    scene.Property->AddIsosurface(0.4, 1.0);
    scene.Color->RemoveAllPoints();
    scene.Color->AddRGBPoint(0.0, 0.0, 1.0, 0.25);
    scene.Color->AddRGBPoint(1.0, 1.0, 0.0, 0.25);
    const std::vector<float> pixels = scene.RenderFloat();
    for (int x = 0; x < 20; ++x)
    {
      const float* pixel = &pixels[4 * (20 * 10 + x)];
      const double first = 0.5 + 0.4 * ((x + 0.5) / 10.0 - 1.0);
      const std::string name = "pixel " + std::to_string(x) + (preIntegrated ? ", pre-integrated" : ", post");
      check.Near(name + ": red", pixel[0], first, 1.0e-4);
      check.Near(name + ": green", pixel[1], 1.0 - first, 1.0e-4);
      check.Near(name + ": blue", pixel[2], 0.25, 1.0e-4);
    }
  }
}
}

int TestIntegrationInScenes(int, char*[])
{
  Check check;
  CheckAdjustedDistances(check);
  CheckColorRange(check);
  CheckOneNode(check);
  CheckDepth(check);
  CheckPeeling(check);
  CheckColorOfFirst(check);
  return check.ExitCode();
}
