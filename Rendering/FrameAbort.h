// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// A frame that is given up while it is drawn: vtkRenderWindow's AbortCheckEvent, and the parts that a frame is drawn
// in so that somebody can be asked in between.

#ifndef FrameAbort_h
#define FrameAbort_h

#include <array>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkRenderWindow;
class vtkRenderer;
class vtkVolume;

// Whether anybody observes AbortCheckEvent. Without one, nothing is asked and nothing is drawn in parts.
bool CanFrameBeAborted(vtkRenderWindow* window);

// Finishes what OpenGL has to draw, asks the observers, and returns whether the frame is not wanted any more.
// vtkRenderWindow::CheckAbortStatus() asks five times a second at most, which is too seldom for fast frames.
bool IsFrameAborted(vtkRenderWindow* window);

// Keeps drawing within rectangles of the window, from construction to destruction.
class ScissorScope
{
public:
  using Rectangle = std::array<int, 4>; // x, y, width, height

  explicit ScissorScope(vtkOpenGLRenderWindow* window);
  ~ScissorScope();
  ScissorScope(const ScissorScope&) = delete;
  void operator=(const ScissorScope&) = delete;

  // Nothing at all, where the rectangle is empty.
  void Restrict(const Rectangle& rectangle);

  // Where the volume is drawn, in 4 x 4 parts; empty: nowhere.
  std::vector<Rectangle> Tiles(vtkRenderer* renderer, vtkVolume* volume) const;

private:
  vtkOpenGLRenderWindow* Window;
  bool WasOn;
  Rectangle Before;
};

#endif
