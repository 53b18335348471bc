// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// OSMesa renders into memory without any window system, EGL or device file. VTK, however, calls
// the OpenGL functions of libGL (libglvnd), which pass each call to the *vendor* whose context is
// current, and OSMesa is none of the vendors libglvnd knows. So this file makes it one: libGLdispatch
// exports what its own front ends (libGLX, libEGL) use to make a vendor's function table current.
// Every gl function of libGL and libOpenGL, and every pointer that GLEW got from
// glXGetProcAddress(), then reaches OSMesa.

#include "HeadlessContext.h"

#include <array>
#include <dlfcn.h>

namespace
{
// From GL/osmesa.h, so that its package is not needed to build.
constexpr unsigned int RGBA = 0x1908;
constexpr unsigned int UnsignedByte = 0x1401;
constexpr int Format = 0x22;
constexpr int DepthBits = 0x30;
constexpr int StencilBits = 0x31;
constexpr int Profile = 0x33;
constexpr int CoreProfile = 0x34;
constexpr int MajorVersion = 0x36;
constexpr int MinorVersion = 0x37;

using Context = struct OSMesaContextType*;
using AnyFunction = void (*)();

//------------------------------------------------------------------------------
template <typename FunctionType>
bool Find(void* library, const char* name, FunctionType& function)
{
  function = reinterpret_cast<FunctionType>(dlsym(library, name));
  return function != nullptr;
}

//------------------------------------------------------------------------------
struct OSMesaLibrary
{
  Context (*CreateContextAttribs)(const int*, Context) = nullptr;
  void (*DestroyContext)(Context) = nullptr;
  unsigned char (*MakeCurrent)(Context, void*, unsigned int, int, int) = nullptr;
  Context (*GetCurrentContext)() = nullptr;
  AnyFunction (*GetProcAddress)(const char*) = nullptr;
  bool Loaded = false;

  OSMesaLibrary()
  {
    void* library = dlopen("libOSMesa.so.8", RTLD_LAZY | RTLD_LOCAL);
    this->Loaded = library && Find(library, "OSMesaCreateContextAttribs", this->CreateContextAttribs) &&
      Find(library, "OSMesaDestroyContext", this->DestroyContext) &&
      Find(library, "OSMesaMakeCurrent", this->MakeCurrent) &&
      Find(library, "OSMesaGetCurrentContext", this->GetCurrentContext) &&
      Find(library, "OSMesaGetProcAddress", this->GetProcAddress);
  }

  static const OSMesaLibrary& Get()
  {
    static const OSMesaLibrary library;
    return library;
  }
};

//------------------------------------------------------------------------------
// What libglvnd's front ends know of libGLdispatch, version 1 of its binary interface (libglvnd 1.0
// and later): src/GLdispatch/GLdispatch.h of libglvnd.
struct ThreadState
{
  int Tag;
  void (*ThreadDestroyed)(ThreadState*);
  void* Private;
};

class GLDispatch
{
public:
  static GLDispatch& Get()
  {
    static GLDispatch dispatch;
    return dispatch;
  }

  bool IsAvailable() const { return this->Table != nullptr; }

  // Lets all gl functions of this thread reach OSMesa.
  bool MakeCurrent()
  {
    if (ThreadState* current = this->GetCurrentThreadState())
    {
      if (current->Tag == OSMesaTag)
      {
        return true;
      }
      this->LoseCurrent();
    }
    auto* state = new ThreadState{ OSMesaTag, [](ThreadState* ended) { delete ended; }, nullptr };
    if (!this->MakeTableCurrent(state, this->Table, this->VendorId, nullptr))
    {
      delete state;
      return false;
    }
    return true;
  }

  bool IsCurrent() const
  {
    const ThreadState* current = this->GetCurrentThreadState();
    return current && current->Tag == OSMesaTag;
  }

  void ReleaseCurrent()
  {
    if (this->IsCurrent())
    {
      ThreadState* state = this->GetCurrentThreadState();
      this->LoseCurrent();
      delete state;
    }
  }

private:
  // libglvnd numbers its own front ends 0 (GLX) and 1 (EGL).
  static constexpr int OSMesaTag = 0x4f53;

  GLDispatch()
  {
    void* library = dlopen("libGLdispatch.so.0", RTLD_LAZY | RTLD_GLOBAL);
    int (*getVersion)() = nullptr;
    void (*initialize)() = nullptr;
    int (*newVendorId)() = nullptr;
    void* (*createTable)(void* (*)(const char*, void*), void*) = nullptr;
    if (!library || !Find(library, "__glDispatchGetABIVersion", getVersion) || getVersion() != 1 ||
      !Find(library, "__glDispatchInit", initialize) ||
      !Find(library, "__glDispatchNewVendorID", newVendorId) ||
      !Find(library, "__glDispatchCreateTable", createTable) ||
      !Find(library, "__glDispatchMakeCurrent", this->MakeTableCurrent) ||
      !Find(library, "__glDispatchLoseCurrent", this->LoseCurrent) ||
      !Find(library, "__glDispatchGetCurrentThreadState", this->GetCurrentThreadState))
    {
      return;
    }
    initialize();
    this->VendorId = newVendorId();
    this->Table = createTable(
      [](const char* name, void*) -> void* {
        return reinterpret_cast<void*>(OSMesaLibrary::Get().GetProcAddress(name));
      },
      nullptr);
  }

  void* Table = nullptr;
  int VendorId = 0;
  unsigned char (*MakeTableCurrent)(ThreadState*, void*, int, const void*) = nullptr;
  void (*LoseCurrent)() = nullptr;
  ThreadState* (*GetCurrentThreadState)() = nullptr;
};

//------------------------------------------------------------------------------
class OSMesaHeadlessContext : public HeadlessContext
{
public:
  OSMesaHeadlessContext()
    : OSMesa(OSMesaLibrary::Get())
    , Dispatch(GLDispatch::Get())
  {
  }

  ~OSMesaHeadlessContext() override
  {
    if (this->IsCurrent())
    {
      this->ReleaseCurrent();
    }
    if (this->Handle)
    {
      this->OSMesa.DestroyContext(this->Handle);
    }
  }

  bool Initialize()
  {
    const int attributes[] = { Format, RGBA, DepthBits, 24, StencilBits, 8, Profile, CoreProfile,
      MajorVersion, 3, MinorVersion, 2, 0 };
    this->Handle = this->OSMesa.CreateContextAttribs(attributes, nullptr);
    return this->Handle && this->MakeCurrent();
  }

  bool MakeCurrent() override
  {
    return this->OSMesa.MakeCurrent(this->Handle, this->Buffer.data(), UnsignedByte, Side, Side) &&
      this->Dispatch.MakeCurrent();
  }

  bool IsCurrent() const override
  {
    return this->Handle && this->OSMesa.GetCurrentContext() == this->Handle && this->Dispatch.IsCurrent();
  }

  void ReleaseCurrent() override
  {
    this->OSMesa.MakeCurrent(nullptr, nullptr, 0, 0, 0);
    this->Dispatch.ReleaseCurrent();
  }

  Function GetFunction(const char* name) const override { return this->OSMesa.GetProcAddress(name); }

  const char* GetName() const override { return "OSMesa"; }

private:
  // VTK draws into framebuffer objects; the context's own buffer only has to exist.
  static constexpr int Side = 16;

  const OSMesaLibrary& OSMesa;
  GLDispatch& Dispatch;
  Context Handle = nullptr;
  std::array<unsigned char, Side * Side * 4> Buffer{};
};
}

//------------------------------------------------------------------------------
std::unique_ptr<HeadlessContext> CreateOSMesaContext(std::string& reason)
{
  if (!OSMesaLibrary::Get().Loaded)
  {
    reason = "OSMesa: libOSMesa.so.8 is missing; install the package libosmesa6.";
    return nullptr;
  }
  if (!GLDispatch::Get().IsAvailable())
  {
    reason = "OSMesa: libGLdispatch.so.0 is missing or of an unknown version; install the package libglvnd0.";
    return nullptr;
  }
  auto context = std::make_unique<OSMesaHeadlessContext>();
  if (!context->Initialize())
  {
    reason =
      "OSMesa: it gives no OpenGL 3.2 core context; install a later version of the package libosmesa6.";
    return nullptr;
  }
  return context;
}
