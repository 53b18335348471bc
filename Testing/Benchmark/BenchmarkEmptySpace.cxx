// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Time of a frame without and with empty-space skipping, over that of VTK's own mapper, for scenes from almost empty
// to full. Frames of all kinds alternate, so that a noisy machine slows all of them; medians of the processor time
// and their ratios are printed. The three pictures are compared too.
//
//   BenchmarkEmptySpace [cranium.vti] [--size pixels] [--frames number] [--cell voxels]
//
// cranium.vti: a CT in Hounsfield units, in which bone begins at 200.

#include "vtkAnalyticVolumeSource.h"
#include "vtkHeadlessRenderWindow.h"
#include "vtkOpticsVolumeMapper.h"
#include "vtkOpticsVolumeProperty.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLGPUVolumeRayCastMapper.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolume.h"
#include "vtkXMLImageDataReader.h"

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

namespace
{
struct Options
{
  std::string File;
  int Size = 512;
  int Frames = 9;
  int Cell = 8;
};

Options Read(int argc, char** argv)
{
  Options options;
  for (int i = 1; i < argc; ++i)
  {
    const std::string word = argv[i];
    const bool isOption = word.size() > 2 && word.substr(0, 2) == "--";
    if (!isOption)
    {
      options.File = word;
      continue;
    }
    int& number = word == "--size" ? options.Size : word == "--frames" ? options.Frames : options.Cell;
    number = i + 1 < argc ? std::stoi(argv[++i]) : number;
  }
  return options;
}

// Opacities at scalars, and where the camera stands.
struct Kind
{
  std::string Name;
  vtkSmartPointer<vtkImageData> Image;
  std::vector<std::pair<double, double>> Opacities;
  bool IsShaded = true;
  int Model = vtkOpticsVolumeProperty::VTK;
};

// One window, mapper and volume.
class Contestant
{
public:
  Contestant(const Kind& kind, vtkGPUVolumeRayCastMapper* mapper, const Options& options)
  {
    const double* spacing = kind.Image->GetSpacing();
    const double step = std::min({ spacing[0], spacing[1], spacing[2] }) / 2.0;
    mapper->SetInputData(kind.Image);
    mapper->SetAutoAdjustSampleDistances(0);
    mapper->SetUseJittering(0);
    mapper->SetSampleDistance(static_cast<float>(step));
    vtkNew<vtkPiecewiseFunction> opacity;
    for (const auto& [scalar, value] : kind.Opacities)
    {
      opacity->AddPoint(scalar, value);
    }
    vtkNew<vtkColorTransferFunction> color;
    color->AddRGBPoint(kind.Opacities.front().first, 0.8, 0.5, 0.4);
    color->AddRGBPoint(kind.Opacities.back().first, 0.9, 0.9, 0.8);
    vtkNew<vtkOpticsVolumeProperty> property;
    property->SetScalarOpacity(opacity);
    property->SetColor(color);
    property->SetScalarOpacityUnitDistance(2.0 * step);
    property->SetInterpolationTypeToLinear();
    property->SetShade(kind.IsShaded);
    property->SetReflectanceModel(kind.Model);
    vtkNew<vtkVolume> volume;
    volume->SetMapper(mapper);
    volume->SetProperty(property);
    vtkNew<vtkRenderer> renderer;
    renderer->AddVolume(volume);
    this->Window->SetSize(options.Size, options.Size);
    this->Window->AddRenderer(renderer);
    renderer->GetActiveCamera()->SetPosition(0.4, 1.0, 0.3);
    renderer->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);
    renderer->ResetCamera();
    renderer->GetActiveCamera()->Zoom(1.5);
    this->Window->Render(); // uploads, links, estimates frames, finds ranges
  }

  void Draw()
  {
    const std::clock_t begin = std::clock();
    this->Window->Render();
    this->Seconds.push_back(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
  }

  double GetSeconds()
  {
    std::sort(this->Seconds.begin(), this->Seconds.end());
    return this->Seconds[this->Seconds.size() / 2];
  }

  std::vector<unsigned char> GetPixels()
  {
    const int* size = this->Window->GetSize();
    vtkNew<vtkUnsignedCharArray> pixels;
    this->Window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels.Get(), 0);
    return std::vector<unsigned char>(
      pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues());
  }

private:
  vtkNew<vtkHeadlessRenderWindow> Window;
  std::vector<double> Seconds;
};

void Compare(const Kind& kind, const Options& options)
{
  vtkNew<vtkOpticsVolumeMapper> off, on;
  off->SkipEmptySpaceOff();
  on->SetMacrocellSize(options.Cell);
  Kind plain = kind;
  plain.Model = vtkOpticsVolumeProperty::VTK;
  Contestant stock(plain, vtkSmartPointer<vtkOpenGLGPUVolumeRayCastMapper>::New(), options);
  Contestant without(kind, off, options), with(kind, on, options);
  for (int frame = 0; frame < options.Frames; ++frame)
  {
    stock.Draw();
    without.Draw();
    with.Draw();
  }
  const double reference = stock.GetSeconds();
  std::cout << kind.Name << "," << 1000.0 * reference << "," << without.GetSeconds() / reference << ","
            << with.GetSeconds() / reference << "," << with.GetSeconds() / without.GetSeconds() << ","
            << on->GetActiveTerms() << ","
            << (without.GetPixels() == with.GetPixels() ? "identical" : "different") << std::endl;
}

vtkSmartPointer<vtkImageData> MarschnerLobb()
{
  vtkNew<vtkAnalyticVolumeSource> source;
  source->SetDimensions(128, 128, 128);
  source->Update();
  return source->GetOutput();
}

// Drawn three ways: not shaded, as VTK shades, and by Ward's model.
void CompareModels(Kind kind, const Options& options)
{
  const std::string name = kind.Name;
  kind.IsShaded = false;
  kind.Name = name + " unshaded";
  Compare(kind, options);
  kind.IsShaded = true;
  kind.Name = name + " shaded";
  Compare(kind, options);
  kind.Model = vtkOpticsVolumeProperty::Ward;
  kind.Name = name + " Ward";
  Compare(kind, options);
}
}

int main(int argc, char** argv)
{
  const Options options = Read(argc, argv);
  std::cout << "scene,stock ms,off of stock,on of stock,on of off,terms,pictures\n";
  if (!options.File.empty())
  {
    vtkNew<vtkXMLImageDataReader> reader;
    reader->SetFileName(options.File.c_str());
    reader->Update();
    const vtkSmartPointer<vtkImageData> cranium = reader->GetOutput();
    CompareModels({ "cranium bone", cranium, { { 200.0, 0.0 }, { 600.0, 0.9 } } }, options);
    CompareModels({ "cranium skin and bone", cranium,
                    { { -300.0, 0.0 }, { -200.0, 0.05 }, { 0.0, 0.05 }, { 150.0, 0.1 }, { 500.0, 0.9 } } },
      options);
  }
  const vtkSmartPointer<vtkImageData> field = MarschnerLobb();
  CompareModels({ "Marschner-Lobb shell", field, { { 0.48, 0.0 }, { 0.5, 0.9 }, { 0.52, 0.0 } } }, options);
  CompareModels({ "opaque cube", field, { { 0.0, 0.5 }, { 1.0, 0.9 } } }, options);
  CompareModels({ "transparent fog", field, { { 0.0, 0.001 }, { 1.0, 0.002 } } }, options);
  return EXIT_SUCCESS;
}
