// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Normals, gradient magnitude and anisotropy on the GPU, as codes of 8, 16 or 32 bits.

#ifndef FrameTextures_h
#define FrameTextures_h

#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"

#include <array>
#include <vector>

class vtkFloatArray;
class vtkImageData;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

/** Frames of a volume on one grid. */
struct FrameGrid
{
  vtkImageData* Geometry = nullptr;
  vtkFloatArray* Normals = nullptr;    // 3 components, unit or 0
  vtkFloatArray* Magnitude = nullptr;  // 1 component, per world length
  vtkFloatArray* Anisotropy = nullptr; // 3 or 5 components in [-1, 1], or null
};

class FrameTextures
{
public:
  /** Uploads what has changed; bits: 8, 16 or 32. False where this OpenGL cannot hold the grid. */
  bool Update(const FrameGrid& grid, int bits, vtkOpenGLRenderWindow* window);

  /** stepPerRange: the step h over the range of the scalars, so that magnitudes become changes. */
  void SetUniforms(vtkShaderProgram* program, double stepPerRange);

  void Unbind();
  void Release(vtkWindow* window);
  std::size_t GetMemorySize() const;

private:
  struct Channel
  {
    const float* Values;
    int Stride;
    bool IsSigned;
    double Scale; // brings the values to [-1, 1] or [0, 1]
  };
  using Texture = vtkSmartPointer<vtkTextureObject>;

  Texture Upload(const std::vector<Channel>& channels, const FrameGrid& grid, vtkOpenGLRenderWindow* window);
  void UploadAll(const FrameGrid& grid, vtkOpenGLRenderWindow* window);
  std::vector<Texture> GetTextures() const;

  Texture Normals;
  Texture Anisotropy;
  Texture AnisotropyMixed; // the last two of World's five numbers
  double LargestMagnitude = 1.0;
  double DataToTexture[16] = {};
  int Bits = 8;

  struct Stamp
  {
    const void* Source = nullptr;
    vtkMTimeType Time = 0;
    bool operator==(const Stamp& other) const
    {
      return this->Source == other.Source && this->Time == other.Time;
    }
  };
  std::array<Stamp, 4> Uploaded;
  int UploadedBits = 0;
};

#endif
