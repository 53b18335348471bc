// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Anisotropic voxels on the GPU, sparse as they are: of each voxel of the occupied bricks the place of its first
// coefficient, coefficients one after the other, and a map of the bricks.

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

  /** Uploads the voxels; bits: 16 or 32 a number. Otherwise what is wrong, and what to do about it. */
  std::string Upload(vtkImageData* image, int bits, vtkOpenGLRenderWindow* window);
  bool IsAlive(vtkOpenGLRenderWindow* window) const { return this->Bricks.IsAlive(window); }
  void Release(vtkWindow* window);
  std::size_t GetMemorySize() const { return this->MemorySize; }

  volumeoptics::LineGrid Grid;
  LineAtlas Atlas;
  int MaximumOrder = 0;
  bool HasProduct = false;
  std::vector<Type> Types;
  int NumberOfOccupiedBricks = 0;

  TermTexture Bricks; // of each brick the texel of its tile, and its number among the occupied; below 0: none
  TermTexture Tiles;  // of each tile its first voxel
  TermTexture Starts; // of each voxel of each occupied brick of each type its first coefficient
  TermTexture Harmonics;
  TermTexture Coefficients;
  TermTexture Products;

private:
  std::string CheckSizes(const volumeoptics::LineVoxels& voxels, vtkOpenGLRenderWindow* window) const;
  void UploadBricks(const volumeoptics::LineVoxels& voxels, vtkOpenGLRenderWindow* window);
  void UploadTiles(vtkOpenGLRenderWindow* window);
  void UploadStarts(const volumeoptics::LineVoxels& voxels, vtkOpenGLRenderWindow* window);
  void UploadCoefficients(const volumeoptics::LineVoxels& voxels, int bits, vtkOpenGLRenderWindow* window);
  struct Format
  {
    unsigned int Internal, External, Number;
    int Channels, VTKType, Bytes; // Bytes of a texel on the GPU
  };
  // One texel after the other, in rows.
  template <class Value>
  void UploadList(
    TermTexture& texture, std::vector<Value> values, const Format& format, vtkOpenGLRenderWindow* window);

  std::size_t MemorySize = 0;
};

#endif
