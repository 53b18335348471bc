// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Shadows under whatever cuts, masks and classifies a volume, against rays to the lights in double precision through a
// volume that is cut, masked and classified by hand.

#include "ClassifiedByHand.h"
#include "LightShadow.h"
#include "ReferencePictures.h"
#include "ShadowScene.h"

#include "vtkCellData.h"
#include "vtkPlane.h"
#include "vtkUnsignedCharArray.h"

#include <functional>

using namespace reference;

namespace
{
const int Size = 26;
const double UnitDistance = 0.05; // TestScene's
const double Step = 0.025;        // ShadowScene's

double OpacityOf(double scalar)
{
  return 0.6 * std::clamp(scalar, 0.0, 1.0);
}

double Plain(const Field& field, const Vector& p)
{
  return ExtinctionOf(OpacityOf(field.Value(p)), UnitDistance);
}

// What is left where a point is not hidden.
Extinction Except(const std::function<bool(const Vector&)>& isHidden)
{
  return [=](const Field& field, const Vector& p) { return isHidden(p) ? 0.0 : Plain(field, p); };
}

struct Setting
{
  const char* Name;
  std::function<void(ShadowScene&)> Apply;
  Extinction ByHand;
  bool ChangesShadows;
  std::function<void(Grid&)> Fit; // the box in which the rays are; null: that of the points
};

// Of the absolute difference, in 255ths: within its own slice a sample is hidden by what the ray has met, not by what
// the light has.
const double LargestMean = 1.5;

// 255 where a mask's point shows the volume: a mask is not interpolated.
vtkSmartPointer<vtkImageData> MaskOf(
  ShadowScene& scene, unsigned char inside, const std::function<bool(const double*)>& isInside)
{
  auto* image = vtkImageData::SafeDownCast(scene.Mapper->GetDataSetInput());
  auto mask = vtkSmartPointer<vtkImageData>::New();
  mask->CopyStructure(image);
  mask->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  for (vtkIdType i = 0; i < mask->GetNumberOfPoints(); ++i)
  {
    static_cast<unsigned char*>(mask->GetScalarPointer())[i] = isInside(mask->GetPoint(i)) ? inside : 0;
  }
  return mask;
}

// The mask changes in the middle between two points.
const double MaskBorder = 0.025;

void Mask(ShadowScene& scene)
{
  scene.Mapper->SetMaskInput(
    MaskOf(scene, 255, [](const double* p) { return p[0] < MaskBorder || p[2] < -0.3; }));
  scene.Mapper->SetMaskTypeToBinary();
}

// A quarter of the opacity in one half of the ball. VTK takes a label's opacity for that of a step.
void Label(ShadowScene& scene)
{
  scene.Mapper->SetMaskInput(
    MaskOf(scene, 1, [](const double* p) { return p[0] > MaskBorder && p[2] > -0.3; }));
  scene.Mapper->SetMaskTypeToLabelMap();
  scene.Mapper->SetMaskBlendFactor(1.0F);
  scene.Property->SetLabelColor(1, scene.Color);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(1.0, 0.05);
  scene.Property->SetLabelScalarOpacity(1, opacity);
}

double LabelledByHand(const Field& field, const Vector& p)
{
  const bool isLabelled = p.x > MaskBorder && p.z > -0.325;
  return isLabelled ? ExtinctionOf(0.05 * field.Value(p), Step) : Plain(field, p);
}

// VTK's magnitude of the gradient: 1 is a change of half of the range over the distance of two points.
double MagnitudeOf(const Field& field, const Vector& p)
{
  const double spacing = 2.0 / (ShadowScene::Points - 1);
  return std::min(glm::length(field.Gradient(p)) * spacing / 0.25, 1.0);
}

// Surfaces alone.
double ShareOfSurface(double magnitude)
{
  return 0.3 * std::clamp((magnitude - 0.2) / 0.6, 0.0, 1.0);
}

void GradientOpacity(ShadowScene& scene)
{
  vtkNew<vtkPiecewiseFunction> function;
  function->AddPoint(0.0, 0.0);
  function->AddPoint(0.05, 0.0); // VTK's functions of gradients are in a quarter of the range
  function->AddPoint(0.2, 0.3);
  function->AddPoint(0.25, 0.3);
  scene.Property->SetGradientOpacity(function);
}

// VTK multiplies the opacity of a step.
double GradientOpacityByHand(const Field& field, const Vector& p)
{
  const double ofStep = 1.0 - std::pow(1.0 - OpacityOf(field.Value(p)), Step / UnitDistance);
  return ExtinctionOf(ofStep * ShareOfSurface(MagnitudeOf(field, p)), Step);
}

// VTK takes a 2D function's opacity for that of a step.
const double LargestOpacityOfStep = 0.9;

void Function2D(ShadowScene& scene)
{
  const int size = 128;
  vtkNew<vtkImageData> table;
  table->SetDimensions(size, size, 1);
  table->AllocateScalars(VTK_FLOAT, 4);
  for (int y = 0; y < size; ++y)
  {
    for (int x = 0; x < size; ++x)
    {
      auto* texel = static_cast<float*>(table->GetScalarPointer(x, y, 0));
      std::fill(texel, texel + 3, 1.0F);
      const double scalar = (x + 0.5) / size;
      const double magnitude = (y + 0.5) / size;
      texel[3] = static_cast<float>(LargestOpacityOfStep * scalar * ShareOfSurface(magnitude));
    }
  }
  scene.Property->SetTransferFunctionMode(vtkVolumeProperty::TF_2D);
  scene.Property->SetTransferFunction2D(table);
}

double Function2DByHand(const Field& field, const Vector& p)
{
  return ExtinctionOf(LargestOpacityOfStep * field.Value(p) * ShareOfSurface(MagnitudeOf(field, p)), Step);
}

// Of so many points on each axis.
void Resample(ShadowScene& scene, int x, int y, int z)
{
  vtkSmartPointer<vtkImageData> old = ShadowScene::Image();
  const GridField field(old);
  vtkNew<vtkImageData> image;
  image->SetDimensions(x, y, z);
  image->SetOrigin(-1.0, -1.0, -1.0);
  image->SetSpacing(2.0 / (x - 1), 2.0 / (y - 1), 2.0 / (z - 1));
  image->AllocateScalars(VTK_FLOAT, 1);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double* p = image->GetPoint(i);
    static_cast<float*>(image->GetScalarPointer())[i] = static_cast<float>(field.Value({ p[0], p[1], p[2] }));
  }
  scene.Mapper->SetInputData(image);
}

// The same values, each in the middle of a cell.
void UseCells(ShadowScene& scene)
{
  vtkSmartPointer<vtkImageData> points = ShadowScene::Image();
  const double spacing = points->GetSpacing()[0];
  vtkNew<vtkImageData> cells;
  const int count = ShadowScene::Points + 1;
  cells->SetDimensions(count, count, count);
  cells->SetSpacing(points->GetSpacing());
  const double corner = -1.0 - 0.5 * spacing;
  cells->SetOrigin(corner, corner, corner);
  cells->GetCellData()->SetScalars(points->GetPointData()->GetScalars());
  scene.Mapper->SetInputData(cells);
}

const std::vector<Setting> Settings = {
  { "cropping",
    [](ShadowScene& s) {
      s.Mapper->SetCroppingRegionPlanes(-0.1, 0.6, -0.5, 0.5, -0.5, 0.1);
      s.Mapper->SetCroppingRegionFlags(0x7ffffff & ~(1 << 22)); // nothing in the middle of the upper third
      s.Mapper->CroppingOn();
    },
    Except([](const Vector& p) { return p.x > -0.1 && p.x < 0.6 && std::abs(p.y) < 0.5 && p.z > 0.1; }), true,
    nullptr },
  { "clipping plane",
    [](ShadowScene& s) {
      vtkNew<vtkPlane> plane;
      plane->SetOrigin(0.1, 0.0, 0.0);
      plane->SetNormal(-1.0, 0.0, 0.0);
      s.Mapper->AddClippingPlane(plane);
    },
    Plain, true, [](Grid& grid) { grid.points[0] = 23; } },
  { "mask", Mask, Except([](const Vector& p) { return p.x > MaskBorder && p.z > -0.325; }), true, nullptr },
  { "label map", Label, LabelledByHand, true, nullptr },
  { "gradient opacity", GradientOpacity, GradientOpacityByHand, true, nullptr },
  { "2D function", Function2D, Function2DByHand, true, nullptr },
  { "unequal spacing", [](ShadowScene& s) { Resample(s, 41, 27, 61); }, Plain, false, nullptr },
  { "cell data", UseCells, Plain, false,
    [](Grid& grid) {
      grid.corner -= 0.5 * (grid.Step(0) + grid.Step(1) + grid.Step(2));
      grid.points = { 42, 42, 42 };
    } },
};

// White, so that the colour is that of every scalar.
void Prepare(ShadowScene& stage)
{
  stage.Color->RemoveAllPoints();
  stage.Color->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
  stage.Window->SetSize(Size, Size);
  stage.AddSun(1.0, 0.5, 1.5);
}

double MeanOfDifference(const Image& truth, const std::vector<float>& pixels)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < truth.pixels.size(); ++i)
  {
    sum += std::abs(truth.pixels[i].r - pixels[4 * i]);
  }
  return 255.0 * sum / static_cast<double>(truth.pixels.size());
}

// With scalars at points, as the reference takes them.
Scene SceneOf(ShadowScene& stage, const Extinction& extinction)
{
  if (!vtkImageData::SafeDownCast(stage.Mapper->GetDataSetInput())->GetPointData()->GetScalars())
  {
    stage.Mapper->SetInputData(ShadowScene::Image());
  }
  return ClassifiedByHand(SceneFromVTK(stage.Renderer, stage.Volume, Size, Size), extinction,
    ExtinctionOf(OpacityOf(1.0), UnitDistance));
}

void Compare(Check& check, const Setting& setting)
{
  ShadowScene stage;
  Prepare(stage);
  setting.Apply(stage);
  const std::vector<float> pixels = stage.RenderFloat();
  Scene scene = SceneOf(stage, setting.ByHand);
  if (setting.Fit)
  {
    setting.Fit(scene.grid);
  }
  const double without = MeanOfDifference(Render(scene), pixels);
  scene.shadow = LightShadow(scene, 0.0, Step, 1);
  const double off = MeanOfDifference(Render(scene), pixels);
  scene.shadow = LightShadow(SceneOf(stage, Plain), 0.0, Step, 1);
  const double ofAll = MeanOfDifference(Render(scene), pixels);
  std::cout << setting.Name << ": mean " << off << "/255; without shadows " << without
            << "/255, with those of all of the volume " << ofAll << "/255\n";
  check.AtMost(setting.Name, off, LargestMean);
  check.AtLeast(std::string(setting.Name) + ", without shadows", without, 5.0 * LargestMean);
  check.That(!setting.ChangesShadows || ofAll > 2.0 * LargestMean,
    std::string(setting.Name) + ": shadows of all of the volume are as good");
}
}

int TestShadowSettings(int, char*[])
{
  Check check;
  for (const Setting& setting : Settings)
  {
    Compare(check, setting);
  }
  return check.ExitCode();
}
