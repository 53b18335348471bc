// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Spirals of 100 thousand segments as voxels, 256 along each side, with the default settings, against the same lines as
// tubes drawn at 10 x 10 times the resolution and averaged, as Fig. 4 of [Schussman2004]: at least 25 dB, and
// 30 dB after a 2 x 2 box on both, by vtkOpticsVolumeMapper and by VTK's own mapper.

#include "LineTermScene.h"

#include "vtkActor.h"
#include "vtkOpenGLGPUVolumeRayCastMapper.h"
#include "vtkPolyDataMapper.h"
#include "vtkTubeFilter.h"

namespace
{
const int PictureSize = 256;
const int Supersampling = 10;
const int Sides = 12;
const double Radius = 0.001;
const double SpecularPower = 32.0; // of VTK's headlight: its highlight is Blinn's, too
const double Edge = 1.7;           // of the grid, which the lines fill

struct Picture
{
  int Size = 0;
  std::vector<double> Values; // red, green, blue, as codes
};

Picture Draw(LineTermScene& scene, vtkProp* prop, int size)
{
  scene.Renderer->RemoveAllViewProps();
  scene.Renderer->AddViewProp(prop);
  scene.Window->SetSize(size, size);
  const auto pixels = scene.Render();
  return { size, { pixels.begin(), pixels.end() } };
}

Picture Reduced(const Picture& picture, int factor)
{
  Picture small{ picture.Size / factor, {} };
  small.Values.resize(std::size_t(3) * small.Size * small.Size);
  for (std::size_t i = 0; i < picture.Values.size(); ++i)
  {
    const std::size_t pixel = i / 3, x = pixel % picture.Size / factor, y = pixel / picture.Size / factor;
    small.Values[3 * (y * small.Size + x) + i % 3] += picture.Values[i] / (factor * factor);
  }
  return small;
}

// PSNR over the pixels that either picture covers.
double SignalToNoise(const Picture& a, const Picture& b)
{
  double sum = 0.0, count = 0.0;
  for (std::size_t pixel = 0; pixel < a.Values.size(); pixel += 3)
  {
    double covered = 0.0, squares = 0.0;
    for (std::size_t i = pixel; i < pixel + 3; ++i)
    {
      covered += a.Values[i] + b.Values[i];
      squares += (a.Values[i] - b.Values[i]) * (a.Values[i] - b.Values[i]);
    }
    sum += squares;
    count += covered > 0.0 ? 3.0 : 0.0;
  }
  return 10.0 * std::log10(255.0 * 255.0 * count / std::max(sum, 1e-30));
}

void SetMaterial(vtkProperty* material)
{
  material->SetColor(1.0, 0.35, 0.2);
  material->SetSpecularColor(1.0, 1.0, 1.0);
  material->SetAmbient(0.15);
  material->SetDiffuse(0.85);
  material->SetSpecular(0.3);
  material->SetSpecularPower(SpecularPower);
}

// As wide as cylinders in the mean.
vtkSmartPointer<vtkActor> MakeTubes(vtkAnalyticLineSource* source)
{
  const double angle = TwoPi / 2.0 / Sides;
  vtkNew<vtkTubeFilter> tubes;
  tubes->SetInputConnection(source->GetOutputPort());
  tubes->SetRadius(Radius * angle / std::sin(angle));
  tubes->SetNumberOfSides(Sides);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(tubes->GetOutputPort());
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  SetMaterial(actor->GetProperty());
  return actor;
}

void SetUpVoxelizer(vtkAnisotropicLineVoxelizer* voxelizer)
{
  const double half = 0.5 * Edge, middle = 0.02;
  voxelizer->SetSampleDimensions(256, 256, 256);
  voxelizer->SetModelBounds(-half, half, -half, half, middle - half, middle + half);
  voxelizer->SetRadius(Radius);
  vtkNew<vtkProperty> material;
  SetMaterial(material);
  voxelizer->SetMaterial(0, material);
  voxelizer->SetSpecularPower(0, SpecularPower);
}

void CheckPicture(Check& check, const std::string& name, const Picture& picture, const Picture& truth)
{
  const double raw = SignalToNoise(truth, picture);
  const double reduced = SignalToNoise(Reduced(truth, 2), Reduced(picture, 2));
  std::cout << name << ": " << raw << " dB, of 2 x 2 " << reduced << " dB" << std::endl;
  check.AtLeast(name, raw, 25.0);
  check.AtLeast(name + ", of 2 x 2", reduced, 30.0);
}
}

int TestLineVoxelAccuracy(int, char*[])
{
  Check check;
  vtkNew<vtkAnalyticLineSource> source;
  source->SetNumberOfSegments(100000);
  vtkNew<vtkAnisotropicLineVoxelizer> voxelizer;
  voxelizer->SetInputConnection(source->GetOutputPort());
  SetUpVoxelizer(voxelizer);
  LineTermScene scene(VoxelsOf(voxelizer), PictureSize);
  const auto step = static_cast<float>(Edge / 512.0); // half a voxel
  scene.Mapper->SetSampleDistance(step);
  scene.Camera->SetPosition(0.0, -5.7, 0.0);
  scene.Camera->SetViewAngle(23.0);
  scene.Camera->Azimuth(25.0);
  scene.Camera->Elevation(30.0);
  vtkNew<vtkAnisotropicVoxelEvaluator> evaluator;
  evaluator->SetInputConnection(voxelizer->GetOutputPort());
  evaluator->SetCamera(scene.Camera);
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> mapper;
  mapper->SetInputConnection(evaluator->GetOutputPort());
  mapper->SetAutoAdjustSampleDistances(0);
  mapper->SetSampleDistance(step);
  mapper->SetUseJittering(0);
  vtkNew<vtkVolume> stock;
  stock->SetMapper(mapper);
  evaluator->SetUpVolume(stock);

  const Picture truth = Reduced(Draw(scene, MakeTubes(source), Supersampling * PictureSize), Supersampling);
  CheckPicture(check, "vtkOpticsVolumeMapper", Draw(scene, scene.Volume, PictureSize), truth);
  CheckPicture(check, "vtkAnisotropicVoxelEvaluator", Draw(scene, stock, PictureSize), truth);
  return check.ExitCode();
}
