// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Volumes of one and two points on an axis. VTK's rays have no length in a volume that is one point
// thick: there the picture is VTK's, whatever that is. Two points are enough to be drawn with.

#include "TestScene.h"

#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkOpenGLError.h"
#include "vtkPointData.h"

#include <array>

namespace
{
using Size = std::array<int, 3>;

const int Models[] = { vtkOpticsVolumeProperty::None, vtkOpticsVolumeProperty::BlinnPhong,
  vtkOpticsVolumeProperty::Ward, vtkOpticsVolumeProperty::Lafortune };

std::string NameOf(const Size& size)
{
  return std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " + std::to_string(size[2]);
}

vtkSmartPointer<vtkFloatArray> Ramp(const Size& size)
{
  auto values = vtkSmartPointer<vtkFloatArray>::New();
  for (int i = 0; i < size[0] * size[1] * size[2]; ++i)
  {
    const int x = i % size[0];
    const int y = i / size[0] % size[1];
    const int z = i / (size[0] * size[1]);
    values->InsertNextValue(0.45F + 0.05F * static_cast<float>(x + 2 * y + 3 * z));
  }
  return values;
}

vtkSmartPointer<vtkImageData> MakeImage(const Size& points)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(points.data());
  image->SetSpacing(0.1, 0.1, 0.1);
  image->SetOrigin(-0.05 * (points[0] - 1), -0.05 * (points[1] - 1), -0.05 * (points[2] - 1));
  return image;
}

vtkSmartPointer<vtkImageData> PointImage(const Size& size)
{
  auto image = MakeImage(size);
  image->GetPointData()->SetScalars(Ramp(size));
  return image;
}

vtkSmartPointer<vtkImageData> CellImage(const Size& size)
{
  auto image = MakeImage({ size[0] + 1, size[1] + 1, size[2] + 1 });
  image->GetCellData()->SetScalars(Ramp(size));
  return image;
}

void SetUp(TestScene& scene, vtkImageData* image)
{
  scene.Window->SetSize(60, 60);
  scene.Property->SetSpecular(1.0);
  scene.Mapper->SetInputData(image);
  scene.Renderer->ResetCamera();
}

void CheckFinite(Check& check, const std::string& what, TestScene& scene)
{
  check.That(glGetError() == GL_NO_ERROR, what + ": OpenGL reports an error");
  const std::vector<float> pixels = scene.RenderFloat();
  check.That(AreFinite(pixels), what + ": a pixel is not finite");
  check.That(*std::min_element(pixels.begin(), pixels.end()) >= 0.0F, what + ": a pixel is below 0");
}

void CheckLeftToVTK(Check& check, const Size& size)
{
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> stock;
  TestScene expected(stock);
  SetUp(expected, PointImage(size));
  const std::vector<unsigned char> pixels = expected.Render();
  for (const int model : Models)
  {
    TestScene scene;
    Warnings warnings(scene.Optics);
    SetUp(scene, PointImage(size));
    scene.Property->SetReflectanceModel(model);
    const std::string what = NameOf(size) + " points, " + scene.Property->GetReflectanceModelAsString();
    check.That(scene.Render() == pixels, what + ": the picture is not VTK's");
    check.That(scene.Render() == pixels, what + ": the second picture is not VTK's");
    check.That(warnings.Texts.size() == 1,
      what + ": said " + std::to_string(warnings.Texts.size()) + " times, not once");
    CheckFinite(check, what, scene);
  }
}

void CheckDrawn(Check& check, const std::string& name, vtkImageData* image)
{
  for (const int model : Models)
  {
    TestScene scene;
    Warnings warnings(scene.Optics);
    SetUp(scene, image);
    scene.Property->SetReflectanceModel(model);
    const std::string what = name + ", " + scene.Property->GetReflectanceModelAsString();
    const std::vector<unsigned char> pixels = scene.Render();
    check.That(*std::max_element(pixels.begin(), pixels.end()) > 80, what + ": nothing is drawn");
    check.That(scene.Optics->GetActiveTerms() == "Reflectance", what + ": the term is not active");
    check.That(warnings.Texts.empty(), what + ": has something to say");
    CheckFinite(check, what, scene);
  }
}
}

int TestThinVolumes(int, char*[])
{
  Check check;
  for (const Size& size : { Size{ 1, 12, 12 }, Size{ 12, 1, 12 }, Size{ 12, 12, 1 }, Size{ 1, 1, 1 } })
  {
    CheckLeftToVTK(check, size);
  }
  for (const Size& size : { Size{ 12, 1, 12 }, Size{ 1, 1, 1 } })
  {
    CheckDrawn(check, NameOf(size) + " cells", CellImage(size));
  }
  for (const Size& size : { Size{ 2, 12, 12 }, Size{ 12, 12, 2 }, Size{ 2, 2, 2 } })
  {
    CheckDrawn(check, NameOf(size) + " points", PointImage(size));
  }
  return check.ExitCode();
}
