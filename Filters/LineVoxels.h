// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Anisotropic voxels as an image: a cell is a brick of voxels, its scalar BrickIndex the brick's number
// among the occupied ones, or -1. The coefficients are field data, sparse, see
// vtkAnisotropicLineVoxelizer.

#ifndef LineVoxels_h
#define LineVoxels_h

#include "LineGrid.h"
#include "LineLighting.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <array>
#include <string>
#include <vector>

class vtkDataArray;
class vtkImageData;

namespace volumeoptics
{
// Red, green, blue times area; area.
constexpr int AreaChannel = 3;
constexpr int LineChannels = 4;

// The coefficient sets of one line type. Voxels of brick b: from BrickStarts[b] to BrickStarts[b + 1];
// coefficients of voxel v: from VoxelStarts[v] to VoxelStarts[v + 1].
struct LineCoefficients
{
  int Type = 0;
  const vtkTypeInt64* BrickStarts = nullptr;
  const unsigned short* Places = nullptr; // in the brick
  const vtkTypeInt64* VoxelStarts = nullptr;
  const unsigned char* Harmonics = nullptr; // l (l + 1) + m
  const float* Values = nullptr;            // [coefficient][channel]
  vtkTypeInt64 NumberOfVoxels = 0;
  glm::dvec3 LeastColor = glm::dvec3(0.0), LargestColor = glm::dvec3(1.0);

  vtkTypeInt64 GetNumberOfCoefficients() const { return this->VoxelStarts[this->NumberOfVoxels]; }
};

// Whether the cells of an image are bricks of anisotropic voxels.
bool HoldsLineVoxels(vtkImageData* image);

// Edges of the image's voxels: anisotropic ones, or else its own.
void GetVoxelSpacing(vtkImageData* image, double spacing[3]);

class LineVoxels
{
public:
  // Reads what an image holds; the arrays stay the image's. error: what is wrong, or empty.
  LineVoxels(vtkImageData* image, std::string& error);

  LineGrid Grid;
  int MaximumOrder = 0;
  const int* BrickIndices = nullptr; // of all bricks
  std::vector<LineCoefficients> Types;

private:
  std::string ReadGrid(vtkImageData* image);
  std::string ReadType(vtkImageData* image, int type);
  long long NumberOfOccupiedBricks = 0;
};

// Whether the lights are those that the voxels were made with.
bool HasLights(vtkImageData* image, const std::vector<LineLight>& lights);

// What a brick of one line type holds, its coefficients compressed.
struct LineBrick
{
  std::vector<unsigned short> Places;
  std::vector<int> Counts; // of coefficients of each voxel
  std::vector<unsigned char> Harmonics;
  std::vector<float> Values;
};

struct LineTypeBricks
{
  int Type = 0;
  std::vector<LineBrick> Bricks; // by brick index
  std::array<double, 6> ColorRange = { 0.0, 0.0, 0.0, 1.0, 1.0, 1.0 };
};

// Sets the image's geometry, scalars and field data.
void WriteLineVoxels(const LineGrid& grid, int maximumOrder, const std::vector<int>& brickIndices,
  const std::vector<LineTypeBricks>& types, const std::vector<LineLight>& lights, vtkImageData* image);
}

#endif
