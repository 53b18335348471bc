// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The grids of many visibility sweeps in one 3D texture, so that any number of lights takes one texture unit.

#ifndef ShadowAtlas_h
#define ShadowAtlas_h

#include "TermTexture.h"

#include <array>
#include <vector>

class ShadowAtlas
{
public:
  using Triple = std::array<int, 3>;

  /**
   * Room for grids of these sizes. False: they are more, or larger, than a 3D texture of this OpenGL holds.
   * True, but with nothing in it, also where it was changed: see IsNew().
   */
  bool Allocate(vtkOpenGLRenderWindow* window, const std::vector<Triple>& sizes, int bits);

  /** Allocate() has emptied it. */
  bool IsNew() const { return this->New; }

  /** Takes over a grid; the texture's own size must be that which was allocated. */
  void Copy(int grid, vtkTextureObject* source);

  /** The first texel of a grid. */
  const Triple& GetFirst(int grid) const { return this->Firsts[grid]; }
  const Triple& GetSize(int grid) const { return this->Sizes[grid]; }

  TermTexture& GetTexture() { return this->Texture; }
  std::size_t GetMemorySize() const;
  void Release(vtkWindow* window);

private:
  bool Arrange(int largestSize);

  TermTexture Texture;
  std::vector<Triple> Sizes;
  std::vector<Triple> Firsts;
  Triple Extent = {};
  int Bits = 0;
  bool New = false;
};

#endif
