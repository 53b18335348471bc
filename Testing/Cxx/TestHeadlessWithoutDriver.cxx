// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Without a driver (CMake puts unusable libraries in front of EGL's and OSMesa's) the window says
// once, in one line, what to install; nothing crashes.

#include "vtkCommand.h"
#include "vtkHeadlessRenderWindow.h"
#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkTestErrorObserver.h"

#include <cstdlib>
#include <iostream>
#include <string>

int TestHeadlessWithoutDriver(int, char*[])
{
  vtkNew<vtkTest::ErrorObserver> errors;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkHeadlessRenderWindow> window;
  window->AddObserver(vtkCommand::ErrorEvent, errors);
  window->AddRenderer(renderer);
  window->Render();
  const std::string first = errors->GetErrorMessage();
  errors->Clear();
  window->Render();
  window->Finalize();
  const bool isOnce = !first.empty() && !errors->GetError();
  const bool isUsable = window->SupportsOpenGL() != 0 || *window->GetContextName() != '\0';

  const std::size_t start = first.find("There is no OpenGL");
  const std::string line = start < first.size() ? first.substr(start, first.find('\n', start) - start) : "";
  const bool hasRemedies =
    line.find("libegl1") != std::string::npos && line.find("libosmesa6") != std::string::npos;
  std::cout << "Said: " << line << "\n";
  return isOnce && !isUsable && hasRemedies ? EXIT_SUCCESS : EXIT_FAILURE;
}
