// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Colour and opacity of anisotropic voxels as a camera sees them: the GPU evaluates the harmonics of every
// occupied voxel in the voxel's own view direction, when the view or a scale has changed, into a list, and copies it to its
// places in the atlas. Rays interpolate there.

#ifndef LineEvaluation_h
#define LineEvaluation_h

#include "LineTextures.h"
#include "TransferFunctionTexture.h"
#include "VoxelEvaluation.h"

#include "vtkNew.h"

#include <string>
#include <vector>

class vtkOpenGLFramebufferObject;
class vtkOpenGLVertexArrayObject;
class vtkPiecewiseFunction;
class vtkShaderProgram;

/** In the frame of the voxels' axes, whose origin is the first voxel's corner. */
struct LineView
{
  glm::dvec3 Position = glm::dvec3(0.0);
  glm::dvec3 ToEye = glm::dvec3(0.0, 0.0, 1.0); // of the middle of the picture
  bool IsParallel = false;
};

class LineEvaluation
{
public:
  LineEvaluation();
  ~LineEvaluation();

  /** scales: of each of the types. function: of opacity, or null. */
  void Update(LineTextures& lines, const LineView& view, const std::vector<volumeoptics::LineScale>& scales,
    vtkPiecewiseFunction* function, int bits, vtkOpenGLRenderWindow* window);
  /** To be called when the textures have changed. */
  void Invalidate() { this->Evaluated.clear(); }
  void Release(vtkWindow* window);
  std::size_t GetMemorySize() const;

  /** Of an evaluated voxel: colour times opacity, opacity. */
  TermTexture Atlas;

private:
  void Allocate(const LineTextures& lines, int bits, vtkOpenGLRenderWindow* window);
  void AllocateTarget(TermTexture& target, const glm::ivec2& size);
  void Evaluate(LineTextures& lines, const LineView& view, const std::vector<volumeoptics::LineScale>& scales,
    bool mapsOpacity);
  void Place(LineTextures& lines);
  vtkShaderProgram* MakeProgramReady(const std::string& fragment);
  // One fragment for each texel.
  void Draw(TermTexture& target);

  vtkOpenGLRenderWindow* Window = nullptr;
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  vtkNew<vtkOpenGLVertexArrayObject> NoArrays; // vertices have a number and no other attribute
  TermTexture Looks;                           // of each voxel, one after the other
  vtkNew<vtkPiecewiseFunction> Identity;
  TransferFunctionTexture Function;
  std::vector<double> Evaluated; // what the atlas was evaluated with
  int Bits = 16;
};

#endif
