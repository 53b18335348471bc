// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// What a visibility sweep draws on: a slice's visibility, one layer of a 3D texture, and the light that
// passes each of its directions, in textures of which one slice's are read while the next one's are written.

#ifndef SweepTarget_h
#define SweepTarget_h

#include "SweepRegions.h"
#include "TermTexture.h"

#include "vtkTimeStamp.h"

#include <array>
#include <memory>

class vtkOpenGLRenderWindow;
class vtkOpenGLState;
class vtkShaderProgram;
class vtkWindow;

class SweepTarget
{
public:
  /** Textures in which up to 16 directions are kept. */
  static constexpr int LargestNumberOfTextures = 4;

  struct Format
  {
    std::array<int, 3> Size;
    int Directions;     // up to four in a texture
    int Bits;           // of a number: 8, 16, 32
    bool IsByDirection; // what is left of each direction is kept, not of their mean

    int GetNumberOfTextures() const { return (this->Directions + 3) / 4; }
    int GetNumberOfLayers() const { return this->IsByDirection ? this->GetNumberOfTextures() : 1; }
    bool operator==(const Format& other) const
    {
      return this->Size == other.Size && this->Directions == other.Directions && this->Bits == other.Bits &&
        this->IsByDirection == other.IsByDirection;
    }
  };

  SweepTarget();
  ~SweepTarget();

  /** False: this OpenGL does not draw on such textures. */
  bool Allocate(vtkOpenGLRenderWindow* window, const Format& format);

  /** Begin() keeps aside what is bound and set in the window, End() brings it back. Around the region of a slice all
   * light arrives. */
  void Begin();
  void DrawSlice(int slice, const SweepRectangle& region, vtkShaderProgram* program);
  void End();

  /** When the textures were made anew. */
  vtkMTimeType GetTime() const { return this->Time.GetMTime(); }

  TermTexture& GetVisibility() { return this->Visibility; }
  std::size_t GetMemorySize() const;
  void Release(vtkWindow* window);

private:
  class KeptState;
  using Textures = std::array<TermTexture, LargestNumberOfTextures>;

  bool IsComplete();
  void Attach(int slice, Textures& written);
  bool IsWhole(const SweepRectangle& region) const;
  void FillWithLight(int first, int stride);

  vtkOpenGLRenderWindow* Window = nullptr;
  Format Current = {};
  vtkTimeStamp Time;
  TermTexture Visibility;
  Textures Passed[2]; // what passes even and odd slices
  std::unique_ptr<KeptState> Kept;
  unsigned int Framebuffer = 0;
  unsigned int VertexArray = 0;
};

#endif
