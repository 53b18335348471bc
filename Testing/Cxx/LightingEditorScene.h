// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// What the tests of the editor of lighting transfer functions share: a context view of 300 x 300 on
// the histogram of three materials, and events that are played to it.

#ifndef LightingEditorScene_h
#define LightingEditorScene_h

#include "FilterTesting.h"
#include "vtkGradientAlignedHistogram.h"
#include "vtkLightingTransferFunction.h"
#include "vtkLightingTransferFunctionItem.h"

#include "vtkContextInteractorStyle.h"
#include "vtkContextScene.h"
#include "vtkContextView.h"
#include "vtkInteractorEventRecorder.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"

#include <cmath>
#include <string>

namespace
{
// One without a display of its own.
class PlayedInteractor : public vtkRenderWindowInteractor
{
public:
  static PlayedInteractor* New();
  vtkTypeMacro(PlayedInteractor, vtkRenderWindowInteractor);
};
vtkStandardNewMacro(PlayedInteractor);

// Concentric shells of 220, 90 and 10, the boundaries blurred over a voxel.
double ThreeMaterials(const glm::dvec3& p)
{
  const double radius = glm::length(p - glm::dvec3(23.5));
  const auto inside = [&](double at) { return 0.5 * std::erfc((radius - at) / std::sqrt(2.0)); };
  return 10.0 + 80.0 * inside(19.0) + 130.0 * inside(10.0);
}

struct LightingEditorScene
{
  LightingEditorScene()
  {
    testing::Geometry geometry;
    geometry.Extent = { 0, 47, 0, 47, 0, 47 };
    this->Histogram->SetInputData(testing::MakeImage(geometry, ThreeMaterials));
    this->Histogram->SetStepLength(2.0);         // beyond the blur: lines go from material to material
    this->Histogram->SetScalarRange(0.0, 256.0); // a bin per unit
    this->Histogram->Update();
    this->Item->SetLightingTransferFunction(this->Function);
    this->Item->SetHistogram(this->Histogram->GetOutput());
    this->Item->SetGradientHistogram(this->Histogram->GetOutput(1));
    this->View->GetRenderWindow()->SetMultiSamples(0);
    this->View->GetRenderWindow()->SetSize(300, 300);
    this->View->GetScene()->AddItem(this->Item);
    this->Style->SetScene(this->View->GetScene());
    this->Interactor->SetInteractorStyle(this->Style);
    this->Interactor->SetRenderWindow(this->View->GetRenderWindow());
    this->Recorder->SetInteractor(this->Interactor);
    this->Recorder->ReadFromInputStringOn();
    this->View->GetRenderWindow()->Render();
  }

  // Events in the format of vtkInteractorEventRecorder.
  void Play(const std::string& events)
  {
    this->Recorder->SetInputString(("# StreamVersion 1.1\n" + events).c_str());
    this->Recorder->Play();
    this->View->GetRenderWindow()->Render();
  }

  // An event of the mouse at a scalar of an axis (0: S1, 1: S2), `outward` pixels outside of the plot.
  std::string At(const char* event, int axis, double scalar, int outward = 7, int repeats = 0)
  {
    double point[2];
    this->Item->GetAxisPoint(axis, scalar, point);
    const bool vertical = this->Item->GetVerticalAxes();
    const int away = axis == 0 ? -outward : outward;
    const int x = static_cast<int>(std::lround(point[0])) - (vertical ? away : 0);
    const int y = static_cast<int>(std::lround(point[1])) + (vertical ? 0 : away);
    return std::string(event) + " " + std::to_string(x) + " " + std::to_string(y) + " 0 0 " +
      std::to_string(repeats) + " 0\n";
  }

  // From one place to another with the left button, in three moves.
  void Drag(int fromAxis, double from, int toAxis, double to, int outward = 7)
  {
    const double middle = 0.5 * (from + to);
    this->Play(this->At("MouseMoveEvent", fromAxis, from, outward) +
      this->At("LeftButtonPressEvent", fromAxis, from, outward) +
      this->At("MouseMoveEvent", fromAxis, middle, outward) +
      this->At("MouseMoveEvent", toAxis, to, outward) +
      this->At("LeftButtonReleaseEvent", toAxis, to, outward));
  }

  // modifiers: 1 Shift, 2 Control.
  void Key(const std::string& symbol, int modifiers = 0)
  {
    this->Play(this->At("MouseMoveEvent", 0, 128.0, -40) + "KeyPressEvent 150 150 " +
      std::to_string(modifiers) + " 0 1 " + symbol + "\n");
  }

  std::array<double, 2> Range(int boundary, int side)
  {
    std::array<double, 2> range;
    this->Function->GetRange(boundary, side, range.data());
    return range;
  }

  vtkNew<vtkGradientAlignedHistogram> Histogram;
  vtkNew<vtkLightingTransferFunction> Function;
  vtkNew<vtkLightingTransferFunctionItem> Item;
  vtkNew<vtkContextView> View;
  vtkNew<PlayedInteractor> Interactor;
  vtkNew<vtkContextInteractorStyle> Style;
  vtkNew<vtkInteractorEventRecorder> Recorder;
};
}

#endif
