// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Colour and opacity of anisotropic voxels as a camera sees them: the GPU evaluates the harmonics of every voxel of
// the atlas in the voxel's own view direction, when the view or a scale has changed. Rays interpolate the result.

#ifndef LineEvaluation_h
#define LineEvaluation_h

#include "LineTextures.h"
#include "TransferFunctionTexture.h"
#include "VoxelEvaluation.h"

#include "vtkNew.h"

#include <memory>
#include <vector>

class vtkOpenGLFramebufferObject;
class vtkOpenGLQuadHelper;
class vtkPiecewiseFunction;

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
  void Allocate(const glm::ivec2& size, int bits, vtkOpenGLRenderWindow* window);
  void Draw(LineTextures& lines, const LineView& view, const std::vector<volumeoptics::LineScale>& scales,
    bool mapsOpacity);
  void MakeProgramReady(const LineTextures& lines);
  void SetSizes(const LineTextures& lines);
  void SetView(const LineView& view);
  void SetTypes(const LineTextures& lines, const std::vector<volumeoptics::LineScale>& scales);

  vtkOpenGLRenderWindow* Window = nullptr;
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
  std::string FragmentShader;
  vtkNew<vtkPiecewiseFunction> Identity;
  TransferFunctionTexture Function;
  std::vector<double> Evaluated; // what the atlas was evaluated with
  int Bits = 16;
};

#endif
