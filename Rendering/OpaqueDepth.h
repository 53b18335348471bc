// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Opaque geometry as a light sees it: the distance of what is nearest to the light, on the window of a sweep's
// grid.

#ifndef OpaqueDepth_h
#define OpaqueDepth_h

#include "SweepGrid.h"
#include "TermTexture.h"

#include "vtkTimeStamp.h"

#include <utility>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkProp;
class vtkRenderer;
class vtkWindow;

class OpaqueDepth
{
public:
  using Props = std::vector<vtkProp*>;

  /** What of the renderer is visible and has opaque geometry. */
  static Props OpaqueProps(vtkRenderer* renderer);

  /**
   * Draws the props, if they or the grid have changed since the last time. Leaves renderer and OpenGL as they
   * were. False: this OpenGL can't.
   */
  bool Draw(vtkRenderer* renderer, const Props& props, const SweepGrid& grid);

  vtkTextureObject* GetTexture() { return this->Texture ? this->Texture.operator->() : nullptr; }

  /** Changes when it is drawn. */
  vtkMTimeType GetTime() const { return this->Time.GetMTime(); }

  /** Distances along the view's z of depths 0 and 1. */
  const double* GetRange() const { return this->Range; }

  std::size_t GetMemorySize() const;
  void Release(vtkWindow* window);

private:
  using Stamp = std::pair<std::vector<double>, std::vector<std::pair<const void*, vtkMTimeType>>>;

  static Stamp StampOf(const Props& props, const SweepGrid& grid);
  void FindRange(const Props& props, const SweepGrid& grid);
  bool Allocate(vtkOpenGLRenderWindow* window, const SweepGrid& grid);
  void DrawProps(vtkRenderer* renderer, const Props& props, const SweepGrid& grid);

  TermTexture Texture;
  int Size[2] = { 0, 0 };
  double Range[2] = { 0.0, 1.0 };
  Stamp Drawn;
  vtkTimeStamp Time;
};

#endif
