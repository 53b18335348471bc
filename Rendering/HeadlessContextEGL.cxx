// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HeadlessContext.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <vector>

namespace
{
// The functions of libEGL that are needed here.
struct EGLLibrary
{
  void* Handle = nullptr;
  decltype(&eglGetProcAddress) GetProcAddress = nullptr;
  decltype(&eglQueryString) QueryString = nullptr;
  decltype(&eglGetDisplay) GetDisplay = nullptr;
  decltype(&eglInitialize) Initialize = nullptr;
  decltype(&eglBindAPI) BindAPI = nullptr;
  decltype(&eglChooseConfig) ChooseConfig = nullptr;
  decltype(&eglCreateContext) CreateContext = nullptr;
  decltype(&eglDestroyContext) DestroyContext = nullptr;
  decltype(&eglCreatePbufferSurface) CreatePbufferSurface = nullptr;
  decltype(&eglDestroySurface) DestroySurface = nullptr;
  decltype(&eglMakeCurrent) MakeCurrent = nullptr;
  decltype(&eglGetCurrentContext) GetCurrentContext = nullptr;

  EGLLibrary()
  {
    // Mesa reports drivers that it tried in vain on stderr; what counts is reported by us.
    setenv("EGL_LOG_LEVEL", "fatal", 0);
    this->Handle = dlopen("libEGL.so.1", RTLD_LAZY | RTLD_LOCAL);
    if (this->Handle)
    {
      this->Find(this->GetProcAddress, "eglGetProcAddress");
      this->Find(this->QueryString, "eglQueryString");
      this->Find(this->GetDisplay, "eglGetDisplay");
      this->Find(this->Initialize, "eglInitialize");
      this->Find(this->BindAPI, "eglBindAPI");
      this->Find(this->ChooseConfig, "eglChooseConfig");
      this->Find(this->CreateContext, "eglCreateContext");
      this->Find(this->DestroyContext, "eglDestroyContext");
      this->Find(this->CreatePbufferSurface, "eglCreatePbufferSurface");
      this->Find(this->DestroySurface, "eglDestroySurface");
      this->Find(this->MakeCurrent, "eglMakeCurrent");
      this->Find(this->GetCurrentContext, "eglGetCurrentContext");
    }
  }

  template <typename FunctionType>
  void Find(FunctionType& function, const char* name)
  {
    function = reinterpret_cast<FunctionType>(dlsym(this->Handle, name));
  }

  template <typename FunctionType>
  FunctionType Extension(const char* name) const
  {
    return reinterpret_cast<FunctionType>(this->GetProcAddress(name));
  }

  // The library stays loaded, and its displays initialised, until the program ends: other code may
  // use them as well.
  static const EGLLibrary& Get()
  {
    static const EGLLibrary library;
    return library;
  }
};

//------------------------------------------------------------------------------
bool HasExtension(const char* extensions, const char* name)
{
  return extensions && std::strstr(extensions, name) != nullptr;
}

struct NamedDisplay
{
  EGLDisplay Display;
  const char* Name;
};

//------------------------------------------------------------------------------
std::vector<EGLDeviceEXT> FindDevices(const EGLLibrary& egl, bool software)
{
  auto queryDevices = egl.Extension<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  auto queryDeviceString = egl.Extension<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
  std::vector<EGLDeviceEXT> devices(32);
  EGLint count = 0;
  if (!queryDevices || !queryDeviceString || !queryDevices(32, devices.data(), &count))
  {
    return {};
  }
  devices.resize(count);
  std::vector<EGLDeviceEXT> found;
  for (EGLDeviceEXT device : devices)
  {
    const char* extensions = queryDeviceString(device, EGL_EXTENSIONS);
    if (HasExtension(extensions, "EGL_MESA_device_software") == software)
    {
      found.push_back(device);
    }
  }
  return found;
}

//------------------------------------------------------------------------------
// Graphics cards first, then Mesa's surfaceless platform, then its software device, then what the
// system calls its default.
std::vector<NamedDisplay> FindDisplays(const EGLLibrary& egl)
{
  std::vector<NamedDisplay> displays;
  const char* extensions = egl.QueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  auto getPlatformDisplay = egl.Extension<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  const bool hasDevices = getPlatformDisplay && HasExtension(extensions, "EGL_EXT_platform_device");
  auto addDevices = [&](bool software) {
    for (EGLDeviceEXT device : FindDevices(egl, software))
    {
      displays.push_back({ getPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, device, nullptr), "EGL device" });
    }
  };
  if (hasDevices)
  {
    addDevices(false);
  }
  if (getPlatformDisplay && HasExtension(extensions, "EGL_MESA_platform_surfaceless"))
  {
    displays.push_back(
      { getPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr), "EGL surfaceless" });
  }
  if (hasDevices)
  {
    addDevices(true);
  }
  displays.push_back({ egl.GetDisplay(EGL_DEFAULT_DISPLAY), "EGL default display" });
  return displays;
}

//------------------------------------------------------------------------------
class EGLHeadlessContext : public HeadlessContext
{
public:
  EGLHeadlessContext(const EGLLibrary& egl, NamedDisplay display)
    : EGL(egl)
    , Display(display.Display)
    , Name(display.Name)
  {
  }

  ~EGLHeadlessContext() override
  {
    if (this->IsCurrent())
    {
      this->ReleaseCurrent();
    }
    if (this->Context != EGL_NO_CONTEXT)
    {
      this->EGL.DestroyContext(this->Display, this->Context);
    }
    if (this->Surface != EGL_NO_SURFACE)
    {
      this->EGL.DestroySurface(this->Display, this->Surface);
    }
  }

  bool Initialize()
  {
    if (this->Display == EGL_NO_DISPLAY || !this->EGL.Initialize(this->Display, nullptr, nullptr) ||
      !this->EGL.BindAPI(EGL_OPENGL_API))
    {
      return false;
    }
    const char* extensions = this->EGL.QueryString(this->Display, EGL_EXTENSIONS);
    const bool surfaceless = HasExtension(extensions, "EGL_KHR_surfaceless_context");
    // A surfaceless platform may have no configuration at all, and then needs none.
    const EGLint wanted[] = { EGL_SURFACE_TYPE, surfaceless ? 0 : EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
      EGL_OPENGL_BIT, EGL_NONE };
    EGLConfig config = nullptr;
    EGLint count = 0;
    this->EGL.ChooseConfig(this->Display, wanted, &config, 1, &count);
    const EGLint version[] = { EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 2,
      EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE };
    this->Context = this->EGL.CreateContext(this->Display, config, EGL_NO_CONTEXT, version);
    if (this->Context != EGL_NO_CONTEXT && !surfaceless)
    {
      const EGLint size[] = { EGL_WIDTH, 16, EGL_HEIGHT, 16, EGL_NONE };
      this->Surface = this->EGL.CreatePbufferSurface(this->Display, config, size);
    }
    return this->Context != EGL_NO_CONTEXT && this->MakeCurrent();
  }

  bool MakeCurrent() override
  {
    return this->EGL.MakeCurrent(this->Display, this->Surface, this->Surface, this->Context) == EGL_TRUE;
  }

  bool IsCurrent() const override
  {
    return this->Context != EGL_NO_CONTEXT && this->EGL.GetCurrentContext() == this->Context;
  }

  void ReleaseCurrent() override
  {
    this->EGL.MakeCurrent(this->Display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  }

  Function GetFunction(const char* name) const override { return this->EGL.GetProcAddress(name); }

  const char* GetName() const override { return this->Name; }

private:
  const EGLLibrary& EGL;
  EGLDisplay Display;
  EGLContext Context = EGL_NO_CONTEXT;
  EGLSurface Surface = EGL_NO_SURFACE;
  const char* Name;
};
}

//------------------------------------------------------------------------------
std::unique_ptr<HeadlessContext> CreateEGLContext(std::string& reason)
{
  const EGLLibrary& egl = EGLLibrary::Get();
  if (!egl.Handle)
  {
    reason = "EGL: libEGL.so.1 is missing; install the package libegl1 (and libgl1-mesa-dri).";
    return nullptr;
  }
  for (const NamedDisplay& display : FindDisplays(egl))
  {
    auto context = std::make_unique<EGLHeadlessContext>(egl, display);
    if (context->Initialize())
    {
      return context;
    }
  }
  reason = "EGL: no driver gives an OpenGL 3.2 core context; install the packages libegl-mesa0 and "
           "libgl1-mesa-dri.";
  return nullptr;
}
