// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkHeadlessRenderWindow
 * @brief An OpenGL window that needs no display.
 *
 * It draws with EGL: on a graphics card where there is one, else on Mesa's rasteriser; and with
 * OSMesa where EGL fails. Their libraries (Debian: libegl1, libosmesa6) are loaded when the first
 * window is initialised, and nothing is written to stderr unless both fail. The environment variable
 * VOLUMEOPTICS_HEADLESS allows but one of them if it is "egl" or "osmesa".
 *
 * For builds of VTK that know X alone, as Debian's. A thread draws to X windows or to headless ones
 * at one time: call ReleaseCurrent() of the one before rendering to the other.
 *
 * A program changes over with one call, SetGlobalOverride(true), before it creates its windows.
 */

#ifndef vtkHeadlessRenderWindow_h
#define vtkHeadlessRenderWindow_h

#include "vtkGenericOpenGLRenderWindow.h"
#include "vtkVolumeOpticsModule.h" // for export macro

#include <memory> // for std::unique_ptr

class HeadlessContext;

class VTKVOLUMEOPTICS_EXPORT vtkHeadlessRenderWindow : public vtkGenericOpenGLRenderWindow
{
public:
  static vtkHeadlessRenderWindow* New();
  vtkTypeMacro(vtkHeadlessRenderWindow, vtkGenericOpenGLRenderWindow);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether vtkRenderWindow::New() gives a headless window and vtkRenderWindowInteractor::New() an
   * interactor without a display. Default off. VTK 9.4 and later have windows of their own for this,
   * which are then chosen.
   */
  static void SetGlobalOverride(bool enabled);
  static bool GetGlobalOverride();
  ///@}

  /**
   * SetGlobalOverride(true) if the environment variable VOLUMEOPTICS_HEADLESS is there and not
   * empty. The Python package and the plugin call it when they are loaded. Returns whether it is.
   */
  static bool SetGlobalOverrideFromEnvironment();

  /**
   * What the window draws with: "EGL device", "EGL surfaceless", "EGL default display", "OSMesa", or
   * "" before Initialize() and where there is none.
   */
  const char* GetContextName();

  /**
   * Makes the context. Render() and what reads pixels do so themselves. Without a driver, says once
   * what to install, and the window stays unusable.
   */
  void Initialize() override;

  void Finalize() override;
  void Render() override;
  void MakeCurrent() override;
  bool IsCurrent() override;
  void ReleaseCurrent() override;
  int SupportsOpenGL() override;
  vtkTypeBool IsDirect() override;

  /** Bits of red, green, blue and alpha of what is drawn into; VTK would ask a window's own buffer. */
  int GetColorBufferSizes(int* rgba) override;
  void OpenGLInitContext() override;

protected:
  vtkHeadlessRenderWindow();
  ~vtkHeadlessRenderWindow() override;

private:
  vtkHeadlessRenderWindow(const vtkHeadlessRenderWindow&) = delete;
  void operator=(const vtkHeadlessRenderWindow&) = delete;

  std::unique_ptr<HeadlessContext> Context;
  bool Failed = false;
};

#endif
