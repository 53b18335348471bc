// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// A volume shader without a tag or a statement that the terms need, as a VTK that is not known may have: one message
// names the version of VTK and what is missing, and the picture is VTK's own or empty.

#include "TestScene.h"

#include "vtkLogger.h"
#include "vtkOutputWindow.h"
#include "vtkShaderProperty.h"
#include "vtkStringOutputWindow.h"
#include "vtkVersion.h"

#include <functional>

namespace
{
std::string MessagesOf(const std::function<void()>& run)
{
  vtkSmartPointer<vtkOutputWindow> usual = vtkOutputWindow::GetInstance();
  vtkNew<vtkStringOutputWindow> captured;
  vtkOutputWindow::SetInstance(captured);
  const vtkLogger::Verbosity verbosity = vtkLogger::GetCurrentVerbosityCutoff();
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF); // errors fail a test
  run();
  vtkLogger::SetStderrVerbosity(verbosity);
  vtkOutputWindow::SetInstance(usual);
  return captured->GetOutput();
}

void CheckMessage(Check& check, const std::string& messages, const std::string& missing)
{
  const std::string version = std::string("VTK ") + vtkVersion::GetVTKVersion();
  check.That(messages.find(version) != std::string::npos, missing + ": no version in: " + messages);
  check.That(messages.find('"' + missing) != std::string::npos, missing + " is not named in: " + messages);
  const std::size_t first = messages.find("ERROR");
  check.That(first != std::string::npos && messages.find("ERROR", first + 1) == std::string::npos,
    "not once: " + messages);
}

void Replace(vtkVolume* volume, const char* tag, const char* text)
{
  volume->GetShaderProperty()->AddFragmentShaderReplacement(tag, true, text, false);
}

// The picture of VTK's mapper, with the same text of the user's.
std::vector<unsigned char> RenderStock(const char* tag, const char* text)
{
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> mapper;
  TestScene stock(mapper);
  Replace(stock.Volume, tag, text);
  return stock.Render();
}
}

int TestMissingPlaces(int, char*[])
{
  Check check;
  const char* const tag = "//VTK::Clipping::Impl";
  TestScene scene;
  scene.Property->SetIntegrationSpaceToData();
  scene.Property->SetReflectanceModelToBlinnPhong();
  Replace(scene.Volume, tag, "");
  std::vector<unsigned char> pixels;
  CheckMessage(check, MessagesOf([&] { pixels = scene.Render(), pixels = scene.Render(); }), tag);
  check.That(pixels == RenderStock(tag, ""), "without a tag the picture is not VTK's own");

  const char* const statement = "return computeLighting(";
  TestScene unlit;
  unlit.Property->SetReflectanceModelToBlinnPhong();
  Replace(unlit.Volume, "//VTK::ComputeColor::Dec",
    "vec4 computeColor(vec4 scalar, float opacity) { return vec4(1.0, 0.0, 0.0, opacity); }\n");
  CheckMessage(check, MessagesOf([&] { pixels = unlit.Render(), pixels = unlit.Render(); }), statement);
  const std::vector<unsigned char> background(pixels.begin(), pixels.begin() + 3);
  bool isEmpty = true;
  for (std::size_t i = 0; i < pixels.size(); ++i)
  {
    isEmpty = isEmpty && pixels[i] == background[i % 3];
  }
  check.That(isEmpty, "without a statement something is drawn");
  return check.ExitCode();
}
