// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The window without a display: a cone and a volume are in its picture, also after a change of size,
// in a second window and after Finalize(); OpenGL reports no error; and not a word is on stderr.
// CMake runs it with EGL, with OSMesa, and with an EGL that has no driver; the first argument is what
// the window must draw with.

#include "Check.h"

#include "vtkActor.h"
#include "vtkColorTransferFunction.h"
#include "vtkConeSource.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkHeadlessRenderWindow.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLError.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"
#include "vtkWindowToImageFilter.h"

#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <iostream>
#include <string>
#include <unistd.h>

namespace
{
Check check;

// What comes to the file descriptor of stderr while this lives, also from drivers.
class CapturedStandardError
{
public:
  CapturedStandardError()
    : File(std::tmpfile())
    , Original(dup(STDERR_FILENO))
  {
    dup2(fileno(this->File), STDERR_FILENO);
  }

  ~CapturedStandardError()
  {
    dup2(this->Original, STDERR_FILENO);
    close(this->Original);
    std::fclose(this->File);
  }

  std::string GetText() const
  {
    std::fflush(stderr);
    std::string text(4096, '\0');
    const ssize_t length = pread(fileno(this->File), &text[0], text.size(), 0);
    text.resize(length > 0 ? length : 0);
    return text;
  }

private:
  std::FILE* File;
  int Original;
};

// A red cone on the left of the picture.
vtkSmartPointer<vtkActor> MakeCone()
{
  vtkNew<vtkConeSource> cone;
  cone->SetCenter(-1.0, 0.0, 0.0);
  cone->SetResolution(24);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(cone->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(1.0, 0.0, 0.0);
  return actor;
}

// A green block on its right.
vtkSmartPointer<vtkVolume> MakeBlock()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(16, 16, 16);
  image->SetSpacing(1.0 / 15.0, 1.0 / 15.0, 1.0 / 15.0);
  image->SetOrigin(0.5, -0.5, -0.5);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* voxels = static_cast<unsigned char*>(image->GetScalarPointer());
  std::fill(voxels, voxels + image->GetNumberOfPoints(), 200);
  vtkNew<vtkGPUVolumeRayCastMapper> mapper;
  mapper->SetInputData(image);
  vtkNew<vtkColorTransferFunction> colour;
  colour->AddRGBPoint(0.0, 0.0, 1.0, 0.0);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(255.0, 1.0);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->GetProperty()->SetColor(colour);
  volume->GetProperty()->SetScalarOpacity(opacity);
  return volume;
}

void AddScene(vtkRenderWindow* window)
{
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(0.0, 0.0, 1.0);
  renderer->AddActor(MakeCone());
  renderer->AddVolume(MakeBlock());
  window->AddRenderer(renderer);
  renderer->ResetCamera();
}

// Looks at the picture a quarter, three quarters and none of the way to the right.
void CheckPicture(vtkHeadlessRenderWindow* window, const std::string& when)
{
  window->Render();
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->ReadFrontBufferOff();
  grab->Update();
  vtkImageData* picture = grab->GetOutput();
  int size[3];
  picture->GetDimensions(size);
  check.That(size[0] == window->GetSize()[0] && size[1] == window->GetSize()[1], "the size " + when);
  auto strongest = [&](int x) {
    int best = 0;
    for (int i = 1; i < 3; ++i)
    {
      const int middle = size[1] / 2;
      best = picture->GetScalarComponentAsDouble(x, middle, 0, i) >
          picture->GetScalarComponentAsDouble(x, middle, 0, best)
        ? i
        : best;
    }
    return best;
  };
  check.That(strongest(3 * size[0] / 10) == 0, "a red cone on the left " + when);
  check.That(strongest(7 * size[0] / 10) == 1, "a green block on the right " + when);
  check.That(strongest(2) == 2, "a blue background " + when);
  check.That(glGetError() == GL_NO_ERROR, "no OpenGL error " + when);
}

void CheckWindows(const std::string& driver)
{
  vtkNew<vtkHeadlessRenderWindow> window;
  window->SetSize(200, 200);
  AddScene(window);
  CheckPicture(window, "at first");
  check.That(window->GetSize()[0] == 200, "a width of 200");
  const std::string name = window->GetContextName();
  std::cout << "Rendered with " << name << "\n";
  check.That(name.rfind(driver, 0) == 0, "it draws with " + driver + " and not with " + name);

  window->SetSize(320, 240);
  CheckPicture(window, "with another size");

  vtkNew<vtkHeadlessRenderWindow> second;
  AddScene(second);
  CheckPicture(second, "in a second window");
  check.That(!window->IsCurrent() && second->IsCurrent(), "the second window is current");
  CheckPicture(window, "in the first window again");

  window->Finalize();
  CheckPicture(second, "in the second window after the first one's end");
  CheckPicture(window, "after Finalize()");
  window->ReleaseCurrent();
  CheckPicture(window, "after ReleaseCurrent()");
  check.That(window->SupportsOpenGL() == 1, "it supports OpenGL");
  check.That(std::string(window->ReportCapabilities()).find("OpenGL version") != std::string::npos,
    "it reports its version");
}

void CheckOverride()
{
  vtkHeadlessRenderWindow::SetGlobalOverride(true);
  auto window = vtkSmartPointer<vtkRenderWindow>::New();
  check.That(vtkHeadlessRenderWindow::SafeDownCast(window) != nullptr, "vtkRenderWindow is overridden");
  vtkHeadlessRenderWindow::SetGlobalOverride(false);
  window = vtkSmartPointer<vtkRenderWindow>::New();
  check.That(!vtkHeadlessRenderWindow::SafeDownCast(window), "vtkRenderWindow is itself again");
}
}

int TestHeadlessRenderWindow(int argc, char* argv[])
{
  std::string text;
  {
    CapturedStandardError standardError;
    CheckWindows(argc > 1 ? argv[1] : "");
    CheckOverride();
    text = standardError.GetText();
  }
  check.That(text.empty(), "nothing on stderr, but there is: " + text);
  return check.ExitCode();
}
