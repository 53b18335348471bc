// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Lines as anisotropic voxels in one window.

#ifndef LineScene_h
#define LineScene_h

#include "PictureSettings.h"
#include "VolumeScene.h"
#include "vtkAnisotropicLineVoxelizer.h"
#include "vtkAnisotropicVoxelEvaluator.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <memory>
#include <string>

class vtkPolyData;

struct LineSettings
{
  int Grid = 256; // voxels along the longest side
  int Order = 4;
  double Radius = -1.0; // below 0: a tenth of a voxel
  double RadiusScale = 1.0;
  double Tolerance = 1.0e-5;
  bool ExactProduct = true;
  std::string ColorArray, RadiusArray;
  double Ambient = 0.15, Diffuse = 0.85, Specular = 0.3, SpecularPower = 32.0;
  double Color[3] = { 1.0, 1.0, 1.0 };
  double WorldLight[3] = { 0.0, 0.0, 0.0 }; // direction to it; 0: the picture's light
};

// Grid, material and light; cubic voxels, and one empty voxel around the lines.
void SetUpVoxelizer(const LineSettings& settings, const LightSettings& light, const double bounds[6],
  vtkAnisotropicLineVoxelizer* voxelizer);

// What evaluates the voxels' harmonics: vtkOpticsVolumeMapper on the GPU, or vtkAnisotropicVoxelEvaluator.
enum class LineRenderer
{
  Mapper,
  Evaluator
};

// Draws voxels, an image of vtkAnisotropicLineVoxelizer.
class LineScene
{
public:
  LineScene(vtkImageData* voxels, const PictureSettings& picture, WindowKind kind,
    LineRenderer renderer = LineRenderer::Mapper);

  vtkAnisotropicVoxelEvaluator* GetEvaluator() { return this->Evaluator; }
  void SetRadiusScale(int type, double scale);
  void SetOpacityScale(int type, double scale);
  // Lights the rest of the scene as the lines are, by what their voxels say.
  void LightAs(vtkImageData* voxels);
  VolumeScene& GetScene() { return *this->Scene; }
  // Seconds from the call to the finished frame, evaluation included.
  double Render();

private:
  vtkNew<vtkAnisotropicVoxelEvaluator> Evaluator;
  std::unique_ptr<VolumeScene> Scene;
};

#endif
