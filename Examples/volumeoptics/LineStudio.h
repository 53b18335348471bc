// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Makes the lines of the gallery and draws them, as voxels or as tubes.

#ifndef LineStudio_h
#define LineStudio_h

#include "GalleryLines.h"
#include "LineScene.h"

#include <vtkSmartPointer.h>

#include <memory>

class vtkPolyData;

class LineStudio
{
public:
  explicit LineStudio(WindowKind kind)
    : Kind(kind)
  {
  }

  struct Result
  {
    double VoxelSeconds = 0.0, FrameSeconds = 0.0;
    std::string Renderer;
  };
  // Writes a PNG file.
  Result Draw(const LinePicture& lines, const PictureSettings& picture, const std::string& path);

private:
  vtkPolyData* LinesOf(const LinePicture& lines);
  vtkImageData* VoxelsOf(const LinePicture& lines);

  WindowKind Kind;
  // The latest ones, and what they were made of.
  nlohmann::json LineKey, VoxelKey;
  vtkSmartPointer<vtkPolyData> Lines;
  vtkSmartPointer<vtkImageData> Voxels;
  double VoxelSeconds = 0.0;
};

#endif
