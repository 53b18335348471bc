// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#if VTK_MODULE_ENABLE_VTK_glew
#include "vtk_glew.h"
#elif VTK_MODULE_ENABLE_VTK_glad
#include "vtk_glad.h"
#endif

#include "vtkHeadlessRenderWindow.h"

#include "HeadlessContext.h"
#include "VTKVersion.h"
#include "OpticsFactory.h"

#include "vtkCollection.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"

#include <algorithm>
#include <cstdlib>
#include <string>

vtkStandardNewMacro(vtkHeadlessRenderWindow);

//------------------------------------------------------------------------------
vtkHeadlessRenderWindow::vtkHeadlessRenderWindow()
{
  // A surfaceless context has no framebuffer of its own to copy the picture to.
  this->SetFrameBlitModeToNoBlit();
  this->SetScreenSize(1920, 1080);
  this->ShowWindow = false;
}

//------------------------------------------------------------------------------
vtkHeadlessRenderWindow::~vtkHeadlessRenderWindow()
{
  this->Finalize();
  vtkCollectionSimpleIterator iterator;
  this->Renderers->InitTraversal(iterator);
  while (vtkRenderer* renderer = this->Renderers->GetNextRenderer(iterator))
  {
    renderer->SetRenderWindow(nullptr);
  }
}

//------------------------------------------------------------------------------
void vtkHeadlessRenderWindow::SetGlobalOverride(bool enabled)
{
#ifdef VOLUMEOPTICS_VTK_HAS_HEADLESS_WINDOW
  if (enabled)
  {
    const char* wanted = std::getenv("VOLUMEOPTICS_HEADLESS");
    const bool osmesa = wanted && std::string(wanted) == "osmesa";
    setenv("VTK_DEFAULT_OPENGL_WINDOW", osmesa ? "vtkOSOpenGLRenderWindow" : "vtkEGLRenderWindow", 1);
  }
  else
  {
    unsetenv("VTK_DEFAULT_OPENGL_WINDOW");
  }
#else
  OpticsFactory::SetEnabled("vtkRenderWindow", enabled);
#endif
  OpticsFactory::SetEnabled("vtkRenderWindowInteractor", enabled);
}

//------------------------------------------------------------------------------
bool vtkHeadlessRenderWindow::GetGlobalOverride()
{
  return OpticsFactory::GetEnabled("vtkRenderWindowInteractor");
}

//------------------------------------------------------------------------------
bool vtkHeadlessRenderWindow::SetGlobalOverrideFromEnvironment()
{
  const char* variable = std::getenv("VOLUMEOPTICS_HEADLESS");
  if (variable && *variable)
  {
    SetGlobalOverride(true);
  }
  return GetGlobalOverride();
}

//------------------------------------------------------------------------------
const char* vtkHeadlessRenderWindow::GetContextName()
{
  return this->Context ? this->Context->GetName() : "";
}

//------------------------------------------------------------------------------
void vtkHeadlessRenderWindow::Initialize()
{
  if (this->Context || this->Failed)
  {
    return;
  }
  std::string reason;
  this->Context = HeadlessContext::Create(reason);
  if (!this->Context)
  {
    this->Failed = true;
    vtkErrorMacro(<< "There is no OpenGL to render with. " << reason);
    return;
  }
  if (this->Size[0] <= 0 || this->Size[1] <= 0)
  {
    this->SetSize(300, 300);
  }
  this->Mapped = 1;
  this->OpenGLInit();
}

//------------------------------------------------------------------------------
void vtkHeadlessRenderWindow::Finalize()
{
  if (!this->Context)
  {
    return;
  }
  this->MakeCurrent();
  this->ReleaseGraphicsResources(this);
  this->Context.reset();
  this->Initialized = false;
  this->Mapped = 0;
}

//------------------------------------------------------------------------------
void vtkHeadlessRenderWindow::Render()
{
  this->Initialize();
  if (this->Context)
  {
    this->MakeCurrent();
    this->Superclass::Render();
  }
}

//------------------------------------------------------------------------------
void vtkHeadlessRenderWindow::MakeCurrent()
{
  if (this->Context && !this->Context->IsCurrent() && !this->Context->MakeCurrent())
  {
    vtkErrorMacro(<< this->Context->GetName()
                  << " could not make the context current; call ReleaseCurrent() in the other thread.");
  }
}

//------------------------------------------------------------------------------
bool vtkHeadlessRenderWindow::IsCurrent()
{
  return this->Context && this->Context->IsCurrent();
}

//------------------------------------------------------------------------------
void vtkHeadlessRenderWindow::ReleaseCurrent()
{
  if (this->IsCurrent())
  {
    this->Context->ReleaseCurrent();
  }
}

//------------------------------------------------------------------------------
int vtkHeadlessRenderWindow::SupportsOpenGL()
{
  this->Initialize();
  return this->Context && this->Initialized ? 1 : 0;
}

//------------------------------------------------------------------------------
int vtkHeadlessRenderWindow::GetColorBufferSizes(int* rgba)
{
  if (!rgba)
  {
    return 0;
  }
  std::fill(rgba, rgba + 4, 8); // vtkOpenGLRenderWindow's own framebuffer
  return 32;
}

//------------------------------------------------------------------------------
vtkTypeBool vtkHeadlessRenderWindow::IsDirect()
{
  this->Initialize();
  return this->Context ? 1 : 0;
}

//------------------------------------------------------------------------------
void vtkHeadlessRenderWindow::OpenGLInitContext()
{
#ifdef GLEW_OK
  if (!this->Initialized)
  {
    // Debian's GLEW, which is made for X, finds all of OpenGL before it complains that there is no
    // X display.
    GLenum result = glewInit();
#ifdef GLEW_ERROR_NO_GLX_DISPLAY
    result = result == GLEW_ERROR_NO_GLX_DISPLAY ? GLEW_OK : result;
#endif
    if (result != GLEW_OK || !GLEW_VERSION_3_2)
    {
      vtkErrorMacro(<< this->GetContextName() << " has no OpenGL 3.2: " << glewGetErrorString(result));
      return;
    }
    this->GlewInitValid = true;
    this->Initialized = true;
    float widths[2] = { 1.0F, 1.0F };
    glGetFloatv(GL_ALIASED_LINE_WIDTH_RANGE, widths);
    this->MaximumHardwareLineWidth = widths[1];
  }
#elif defined(VOLUMEOPTICS_VTK_HAS_HEADLESS_WINDOW)
  this->SetOpenGLSymbolLoader(
    [](void* context, const char* name) { return static_cast<HeadlessContext*>(context)->GetFunction(name); },
    this->Context.get());
#endif
  this->Superclass::OpenGLInitContext();
}

//------------------------------------------------------------------------------
void vtkHeadlessRenderWindow::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ContextName: " << this->GetContextName() << "\n";
}
