// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// An OpenGL context that needs no display: the part of vtkHeadlessRenderWindow that VTK knows
// nothing of. The driver's libraries are loaded when the first context is made, so nothing that
// links this module needs them.

#ifndef HeadlessContext_h
#define HeadlessContext_h

#include <memory>
#include <string>

class HeadlessContext
{
public:
  virtual ~HeadlessContext() = default;

  /**
   * A core context of OpenGL 3.2 or later: EGL, else OSMesa, or the only one that the environment
   * variable VOLUMEOPTICS_HEADLESS names (egl or osmesa). Null if there is none; reason is then one
   * line that says why and what to install.
   */
  static std::unique_ptr<HeadlessContext> Create(std::string& reason);

  virtual bool MakeCurrent() = 0;
  virtual bool IsCurrent() const = 0;
  virtual void ReleaseCurrent() = 0;

  /** Finds OpenGL's functions, for VTK versions that are told where to look (9.4 and later). */
  using Function = void (*)();
  virtual Function GetFunction(const char* name) const = 0;

  /** What the context is made of, for people: "EGL surfaceless", "OSMesa", ... */
  virtual const char* GetName() const = 0;
};

// Each kind of context, in a file of its own.
std::unique_ptr<HeadlessContext> CreateEGLContext(std::string& reason);
std::unique_ptr<HeadlessContext> CreateOSMesaContext(std::string& reason);

#endif
