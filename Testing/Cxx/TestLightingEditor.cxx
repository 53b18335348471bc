// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Gestures in the editor of lighting transfer functions, played as interactor events: what the boundaries
// are after each of them.

#include "LightingEditorScene.h"
#include "TestScene.h"

#include "vtkCallbackCommand.h"

#include <sstream>

namespace
{
// The plot is about 270 pixels long for 256 scalars: a pixel's rounding at both ends of a drag.
const double Pixel = 256.0 / 230.0;

void CheckRange(Check& check, const std::string& what, const std::array<double, 2>& range, double low,
  double high, double tolerance = 1.5 * Pixel)
{
  check.Near(what + ", low end", range[0], low, tolerance);
  check.Near(what + ", high end", range[1], high, tolerance);
}

void AddBoundary(LightingEditorScene& scene, double a0, double a1, double b0, double b1)
{
  const double a[2] = { a0, a1 };
  const double b[2] = { b0, b1 };
  scene.Function->AddBoundary(a, b, 0.2, 0.7, 0.4);
}

void CheckDrags(Check& check, bool vertical)
{
  LightingEditorScene scene;
  scene.Item->SetVerticalAxes(vertical);
  scene.View->GetRenderWindow()->Render();
  const std::string axes = vertical ? "vertical axes: " : "";
  AddBoundary(scene, 20.0, 60.0, 150.0, 200.0);
  // the lower material is on the axis of S2
  scene.Drag(1, 40.0, 1, 80.0);
  CheckRange(check, axes + "a box is moved", scene.Range(0, 0), 60.0, 100.0);
  CheckRange(check, axes + "the other one stays", scene.Range(0, 1), 150.0, 200.0, 0.0);
  check.Near(axes + "and is selected", scene.Item->GetSelectedBoundary(), 0, 0);
  scene.Drag(0, 200.0, 0, 220.0);
  CheckRange(check, axes + "an end is dragged", scene.Range(0, 1), 150.0, 220.0);
  scene.Drag(0, 150.0, 0, 240.0);
  CheckRange(check, axes + "beyond the other end", scene.Range(0, 1), 220.0, 240.0);
  const auto before = scene.Range(0, 0);
  double s1[2];
  double s2[2];
  scene.Item->GetAxisPoint(0, 230.0, s1);
  scene.Item->GetAxisPoint(1, 80.0, s2);
  const int x = static_cast<int>(0.5 * (s1[0] + s2[0]));
  const int y = static_cast<int>(0.5 * (s1[1] + s2[1]));
  const auto at = [&](const char* event, int along) {
    return std::string(event) + " " + std::to_string(vertical ? x : x + along) + " " +
      std::to_string(vertical ? y + along : y) + " 0 0 0 0\n";
  };
  scene.Play(at("MouseMoveEvent", 0) + at("LeftButtonPressEvent", 0) + at("MouseMoveEvent", -20) +
    at("LeftButtonReleaseEvent", -20));
  const double moved = scene.Range(0, 0)[0] - before[0];
  check.Near(axes + "the band moves one box", moved, -20.0 * Pixel, 3.0);
  check.Near(axes + "and the other alike", scene.Range(0, 1)[0] - 220.0, moved, 1.5 * Pixel);
}

void CheckSwap(Check& check)
{
  LightingEditorScene scene;
  AddBoundary(scene, 20.0, 40.0, 100.0, 120.0);
  // past the other material; until the button is released it stays on its axis
  scene.Play(scene.At("MouseMoveEvent", 1, 30.0) + scene.At("LeftButtonPressEvent", 1, 30.0) +
    scene.At("MouseMoveEvent", 1, 200.0));
  double box[2];
  scene.Item->GetAxisPoint(1, 200.0, box);
  vtkNew<vtkUnsignedCharArray> pixel;
  const int x = static_cast<int>(box[0]);
  const int y = static_cast<int>(box[1]) + 7;
  scene.View->GetRenderWindow()->GetPixelData(x, y, x, y, 0, pixel);
  check.AtLeast("the box under the mouse is orange", pixel->GetValue(0) - pixel->GetValue(2), 100.0);
  scene.Play(scene.At("LeftButtonReleaseEvent", 1, 200.0));
  CheckRange(check, "a material that becomes the higher one", scene.Range(0, 0), 190.0, 210.0);
  scene.Drag(0, 200.0, 0, 180.0); // it now is on the axis of S1
  CheckRange(check, "changes the axis after the drag", scene.Range(0, 0), 170.0, 190.0);
  CheckRange(check, "and the other one, too", scene.Range(0, 1), 100.0, 120.0, 0.0);
  scene.Drag(1, 110.0, 1, 130.0);
  CheckRange(check, "which is moved there", scene.Range(0, 1), 120.0, 140.0);
}

void CheckNewBoundaries(Check& check)
{
  LightingEditorScene scene;
  scene.Drag(0, 220.0, 1, 90.0, -10);
  check.Near("a line across makes a boundary", scene.Function->GetNumberOfBoundaries(), 1, 0);
  if (scene.Function->GetNumberOfBoundaries() != 1)
  {
    return;
  }
  // ends 10 pixels inside of the plot of some 190: extrapolated to the axes
  const double beyond = 10.0 / 190.0 * 130.0;
  CheckRange(check, "at S1", scene.Range(0, 1), 220.0 + beyond - 10.24, 220.0 + beyond + 10.24, 3.0);
  CheckRange(check, "at S2", scene.Range(0, 0), 90.0 - beyond - 10.24, 90.0 - beyond + 10.24, 3.0);
  double k[3];
  scene.Function->GetCoefficients(0, k);
  check.That(k[0] > 0.0 && k[1] > 0.0 && k[2] > 0.0, "it is lit");

  scene.Drag(0, 100.0, 0, 120.0, -60);
  check.Near("a line along the axes makes none", scene.Function->GetNumberOfBoundaries(), 1, 0);
  check.Near("and unselects", scene.Item->GetSelectedBoundary(), -1, 0);
  scene.Play(scene.At("MouseMoveEvent", 0, 30.0, -60) + scene.At("LeftButtonPressEvent", 0, 30.0, -60) +
    scene.At("LeftButtonReleaseEvent", 0, 30.0, -60) + scene.At("LeftButtonPressEvent", 0, 30.0, -60, 1));
  check.Near("a double click makes one", scene.Function->GetNumberOfBoundaries(), 2, 0);
  CheckRange(check, "of a region with itself", scene.Range(1, 0), 30.0 - 10.24, 30.0 + 10.24);
  CheckRange(check, "on both axes", scene.Range(1, 1), 30.0 - 10.24, 30.0 + 10.24);
  scene.Key("a");
  check.Near("a key makes one", scene.Function->GetNumberOfBoundaries(), 3, 0);
  scene.Play(scene.At("MouseMoveEvent", 0, 128.0, 40) + scene.At("LeftButtonPressEvent", 0, 128.0, 40) +
    scene.At("LeftButtonReleaseEvent", 1, 128.0, 40));
  check.Near("outside of the axes nothing happens", scene.Function->GetNumberOfBoundaries(), 3, 0);
}

void CheckKeys(Check& check)
{
  LightingEditorScene scene;
  AddBoundary(scene, 20.0, 60.0, 150.0, 200.0);
  AddBoundary(scene, 100.0, 110.0, 30.0, 40.0);
  scene.Key("Left");
  CheckRange(check, "without a selection no box moves", scene.Range(0, 0), 20.0, 60.0, 0.0);
  scene.Key("Tab");
  scene.Key("Right");
  CheckRange(check, "Right", scene.Range(0, 0), 21.0, 61.0, Rounding * 256.0);
  scene.Key("Left", 1);
  CheckRange(check, "Shift and Left", scene.Range(0, 0), 13.0, 53.0, Rounding * 256.0);
  scene.Key("space");
  scene.Key("bracketright");
  CheckRange(check, "Space and ]", scene.Range(0, 1), 149.0, 201.0, Rounding * 256.0);
  scene.Key("bracketleft");
  CheckRange(check, "[", scene.Range(0, 1), 150.0, 200.0, Rounding * 256.0);
  for (int i = 0; i < 8; ++i)
  {
    scene.Key("braceleft", 1);
  }
  CheckRange(check, "a box is not narrowed beyond nothing", scene.Range(0, 1), 175.0, 175.0, 1e-9);
  scene.Key("plus");
  check.Near("+", scene.Function->GetSoftness(0), 1.0, Rounding);
  scene.Play(scene.At("MouseMoveEvent", 0, 100.0, -40) + scene.At("MouseWheelForwardEvent", 0, 100.0, -40));
  check.Near("the wheel", scene.Function->GetSoftness(0), 2.0, Rounding);
  scene.Key("minus");
  scene.Key("minus");
  scene.Key("minus");
  check.Near("- stops at 0", scene.Function->GetSoftness(0), 0.0, 0.0);
  scene.Key("Up");
  double k[3];
  scene.Function->GetCoefficients(0, k);
  check.Near("Up raises the diffuse coefficient", k[1], 0.75, Rounding);
  scene.Key("c");
  scene.Key("Down");
  scene.Function->GetCoefficients(0, k);
  check.Near("c and Down lower the specular one", k[2], 0.35, Rounding);
  scene.Key("Tab");
  check.Near("Tab goes on", scene.Item->GetSelectedBoundary(), 1, 0);
  scene.Key("Delete");
  check.Near("Delete", scene.Function->GetNumberOfBoundaries(), 1, 0);
  check.Near("unselects", scene.Item->GetSelectedBoundary(), -1, 0);
  scene.Key("Delete");
  check.Near("Delete without a selection", scene.Function->GetNumberOfBoundaries(), 1, 0);
  scene.Key("i");
  check.Near("i finds the two boundaries of the volume", scene.Function->GetNumberOfBoundaries(), 2, 0);
  scene.Key("g");
  scene.Key("h");
  check.That(!scene.Item->GetLogScale() && scene.Item->GetShowHistograms(), "g and h");
}

void CheckUndo(Check& check)
{
  LightingEditorScene scene;
  const std::string empty = scene.Function->WriteJsonString();
  scene.Drag(0, 220.0, 1, 90.0, -10);
  const std::string one = scene.Function->WriteJsonString();
  scene.Key("Right");
  scene.Key("Delete");
  scene.Key("z");
  scene.Key("z", 2);
  check.That(scene.Function->WriteJsonString() == one, "two edits are undone");
  scene.Key("z");
  scene.Key("z");
  check.That(scene.Function->WriteJsonString() == empty && !scene.Item->Undo(), "and all");
  scene.Key("y");
  check.That(scene.Function->WriteJsonString() == one, "one is redone");
  scene.Key("z", 3);
  check.That(scene.Function->WriteJsonString() != one, "and the next");
  scene.Key("a");
  check.That(!scene.Item->Redo(), "a new edit forgets what was undone");
  const std::string before = scene.Function->WriteJsonString();
  scene.Play(scene.At("MouseMoveEvent", 1, 64.0) + scene.At("LeftButtonPressEvent", 1, 64.0) +
    scene.At("MouseMoveEvent", 1, 120.0));
  check.That(scene.Function->WriteJsonString() != before, "a drag shows at once");
  scene.Key("Escape");
  scene.Play(scene.At("MouseMoveEvent", 1, 140.0) + scene.At("LeftButtonReleaseEvent", 1, 140.0));
  check.That(scene.Function->WriteJsonString() == before, "Escape takes it back");
  scene.Play(scene.At("MouseMoveEvent", 1, 64.0) + scene.At("LeftButtonPressEvent", 1, 64.0) +
    scene.At("LeftButtonReleaseEvent", 1, 64.0));
  scene.Key("z");
  check.That(
    scene.Function->WriteJsonString() != before, "a click is no edit: undo takes back the one before");
}

void CheckEvents(Check& check)
{
  LightingEditorScene scene;
  AddBoundary(scene, 20.0, 60.0, 150.0, 200.0);
  std::vector<unsigned long> events;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&events);
  command->SetCallback([](vtkObject*, unsigned long event, void* list, void*) {
    static_cast<std::vector<unsigned long>*>(list)->push_back(event);
  });
  for (const auto event :
    { vtkCommand::StartInteractionEvent, vtkCommand::InteractionEvent, vtkCommand::EndInteractionEvent })
  {
    scene.Item->AddObserver(event, command);
  }
  scene.Function->AddObserver(vtkCommand::ModifiedEvent, command);
  scene.Drag(1, 40.0, 1, 80.0);
  const std::vector<unsigned long> expected = { vtkCommand::StartInteractionEvent, vtkCommand::ModifiedEvent,
    vtkCommand::InteractionEvent, vtkCommand::ModifiedEvent, vtkCommand::InteractionEvent,
    vtkCommand::EndInteractionEvent };
  check.That(events == expected, "start, a change and an interaction for each move, end");
}

// Edits from elsewhere, curves, no function, no histogram, small views.
void CheckExtremes(Check& check)
{
  LightingEditorScene scene;
  scene.Item->SetSelectedBoundary(5);
  check.Near("a boundary that is not there is not selected", scene.Item->GetSelectedBoundary(), -1, 0);
  AddBoundary(scene, 20.0, 60.0, 150.0, 200.0);
  scene.Play(scene.At("MouseMoveEvent", 1, 40.0) + scene.At("LeftButtonPressEvent", 1, 40.0));
  scene.Function->RemoveAllBoundaries();
  scene.Play(scene.At("MouseMoveEvent", 1, 80.0) + scene.At("LeftButtonReleaseEvent", 1, 80.0));
  check.Near("a boundary that is removed under a drag", scene.Function->GetNumberOfBoundaries(), 0, 0);
  vtkNew<vtkPiecewiseFunction> curve;
  curve->AddPoint(20.0, 0.0);
  curve->AddPoint(60.0, 1.0);
  scene.Function->AddBoundary(curve, curve, 0.2, 0.2, 0.2);
  scene.Drag(1, 40.0, 1, 80.0);
  check.That(
    curve->GetRange()[0] == 20.0 && scene.Item->GetSelectedBoundary() == 0, "a curve is selected, not moved");
  AddBoundary(scene, 1e6, 2e6, -1e300, -1e299); // outside of the axes
  scene.View->GetRenderWindow()->Render();
  scene.Item->SetLightingTransferFunction(nullptr);
  scene.Drag(0, 220.0, 1, 90.0);
  scene.Key("Delete");
  scene.Item->SetHistogram(nullptr);
  scene.View->GetRenderWindow()->Render();
  vtkNew<vtkImageData> empty;
  scene.Item->SetHistogram(empty);
  scene.Item->SetLightingTransferFunction(scene.Function);
  for (const int size : { 1, 20, 90 })
  {
    scene.View->GetRenderWindow()->SetSize(size, size);
    scene.View->GetRenderWindow()->Render();
  }
  const Warnings warnings(scene.Item);
  scene.Item->SetOpacityTolerance(2.0);
  check.That(warnings.Texts.size() == 1 && scene.Item->GetOpacityTolerance() == 1.0, "a tolerance too large");
  std::ostringstream text;
  scene.Item->Print(text);
  check.That(text.str().find("LogScale: on") != std::string::npos, "PrintSelf");
}
}

int TestLightingEditor(int, char*[])
{
  Check check;
  CheckDrags(check, false);
  CheckDrags(check, true);
  CheckSwap(check);
  CheckNewBoundaries(check);
  CheckKeys(check);
  CheckUndo(check);
  CheckEvents(check);
  CheckExtremes(check);
  return check.ExitCode();
}
