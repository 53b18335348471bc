// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Anisotropic voxels on the GPU, sparse as they are: a list of the occupied ones, the place of each one's first
// coefficient, coefficients one after the other, and a map of bricks.

#ifndef LineTextures_h
#define LineTextures_h

#include "LineAtlas.h"
#include "TermTexture.h"

#include <string>
#include <vector>

class LineTextures
{
public:
  struct Type
  {
    int Number;
    float Scale; // that the coefficients were divided by
    glm::vec3 LeastColor, LargestColor;
  };

  /** Uploads the voxels; bits: 8, 16 or 32 a number. Otherwise what is wrong, and what to do about it. */
  std::string Upload(vtkImageData* image, int bits, vtkOpenGLRenderWindow* window);
  bool IsAlive(vtkOpenGLRenderWindow* window) const { return this->Bricks.IsAlive(window); }
  void Release(vtkWindow* window);
  std::size_t GetMemorySize() const { return this->MemorySize; }

  volumeoptics::LineGrid Grid;
  int MaximumOrder = 0;
  std::vector<Type> Types;
  glm::ivec2 AtlasSize = glm::ivec2(0); // 0: there are no lines
  int NumberOfVoxels = 0;

  TermTexture Bricks; // of each brick the texel of its tile, or the distance to the next brick with one
  TermTexture Cells;  // of each tile which cells have lines
  TermTexture Ranks;  // of each texel of the atlas which of its tile's voxels it holds, from 1 on; 0: none
  TermTexture FirstSources; // of each tile where its voxels begin
  TermTexture Sources;      // numbers of voxels
  TermTexture Voxels;       // place in the grid
  TermTexture Starts;       // of each type, of each voxel, the first coefficient
  TermTexture Harmonics;
  TermTexture Coefficients;
  TermTexture Ranges; // 8 bits alone: of each type, of each voxel, degree 0 and what 1 stands for above it

private:
  struct Format
  {
    unsigned int Internal, External, Number;
    int Channels, VTKType, Bytes; // Bytes of a texel on the GPU
  };
  std::string CheckSizes(const volumeoptics::LineVoxels& voxels, vtkOpenGLRenderWindow* window) const;
  std::string CheckAtlas(const LineAtlas& atlas, vtkOpenGLRenderWindow* window) const;
  void UploadAtlas(LineAtlas& atlas, vtkOpenGLRenderWindow* window);
  void ReadTypes(const volumeoptics::LineVoxels& voxels, int bits);
  void UploadCoefficients(const volumeoptics::LineVoxels& voxels, const std::vector<std::int32_t>& starts,
    int bits, vtkOpenGLRenderWindow* window);
  void UploadBytes(
    const std::vector<float>& texels, const std::vector<std::int32_t>& starts, vtkOpenGLRenderWindow* window);
  void UploadTexels(TermTexture& texture, const glm::ivec2& size, void* texels, const Format& format,
    vtkOpenGLRenderWindow* window);
  // One texel after the other, in rows.
  template <class Value>
  void UploadList(
    TermTexture& texture, std::vector<Value>& values, const Format& format, vtkOpenGLRenderWindow* window);

  std::size_t MemorySize = 0;
};

#endif
