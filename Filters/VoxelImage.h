// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// An RGBA image of anisotropic voxels as a camera sees them, brick by brick.

#ifndef VoxelImage_h
#define VoxelImage_h

#include "HarmonicBasis.h"
#include "LineVoxels.h"
#include "Optics.h"
#include "VoxelEvaluation.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkPiecewiseFunction.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace volumeoptics
{
// What stands for 1.
inline double LargestOfScalar(int scalarType)
{
  return scalarType == VTK_UNSIGNED_CHAR ? 255.0 : scalarType == VTK_UNSIGNED_SHORT ? 65535.0 : 1.0;
}

class ViewOfVoxels
{
public:
  explicit ViewOfVoxels(vtkCamera* camera)
    : IsParallel(camera->GetParallelProjection())
  {
    camera->GetPosition(&this->Position.x);
    double direction[3];
    camera->GetDirectionOfProjection(direction);
    this->Direction = -glm::dvec3(direction[0], direction[1], direction[2]);
  }

  glm::dvec3 From(const glm::dvec3& point) const
  {
    const glm::dvec3 way = this->Position - point;
    const double length = glm::length(way);
    return this->IsParallel || !(length > 0.0) ? this->Direction : way / length;
  }

private:
  bool IsParallel;
  glm::dvec3 Position, Direction;
};

template <class Scalar>
class VoxelImage
{
public:
  VoxelImage(const LineVoxels& voxels, const ViewOfVoxels& view, bool perVoxel, vtkImageData* output)
    : Voxels(voxels)
    , Basis(voxels.MaximumOrder, false)
    , Eye(view)
    , PerVoxel(perVoxel)
    , Largest(LargestOfScalar(output->GetScalarType()))
    , Scalars(static_cast<Scalar*>(output->GetScalarPointer()))
  {
  }

  std::vector<LineScale> Scales;
  vtkPiecewiseFunction* Function = nullptr;
  double OpacityLength = 1.0; // of the drawn opacity, as a share of a voxel's mean chord

  void EvaluateBrick(long long brick)
  {
    const int index = this->Voxels.BrickIndices[brick];
    const LineGrid& grid = this->Voxels.Grid;
    if (index < 0)
    {
      return;
    }
    double basis[HarmonicBasis::LargestCount];
    const glm::dvec3 middle =
      grid.CenterOf(grid.FirstVoxelOf(brick)) + 0.5 * (glm::dvec3(grid.Brick) - 1.0) * grid.Voxel;
    this->Basis.Evaluate(this->Eye.From(middle), basis);
    std::vector<vtkTypeInt64> next, end;
    for (const LineCoefficients& set : this->Voxels.Types)
    {
      next.push_back(set.BrickStarts[index]);
      end.push_back(set.BrickStarts[index + 1]);
    }
    for (int place = 0; place < grid.VoxelsOfBrick(); ++place)
    {
      const glm::ivec3 voxel = grid.VoxelAt(brick, place);
      if (glm::any(glm::greaterThanEqual(voxel, grid.Dimensions)))
      {
        continue;
      }
      if (this->PerVoxel)
      {
        this->Basis.Evaluate(this->Eye.From(grid.CenterOf(voxel)), basis);
      }
      this->EvaluateVoxel(place, next, end, basis, this->At(voxel));
    }
  }

  // The most opaque voxel becomes opaque.
  void MarkOpacityRange()
  {
    const glm::ivec3 size = this->Voxels.Grid.Dimensions;
    const long long count = static_cast<long long>(size.x) * size.y * size.z;
    Scalar* most = this->Scalars;
    for (long long i = 1; i < count; ++i)
    {
      Scalar* rgba = this->Scalars + 4 * i;
      most = rgba[3] > most[3] ? rgba : most;
    }
    if (most[3] > 0)
    {
      most[3] = static_cast<Scalar>(this->Largest);
    }
  }

  // Gives the empty voxels of the brick the mean colour of their neighbours, weighted by opacity.
  void SpreadBrick(long long brick)
  {
    const LineGrid& grid = this->Voxels.Grid;
    for (int place = 0; this->HasOccupiedAround(brick) && place < grid.VoxelsOfBrick(); ++place)
    {
      const glm::ivec3 voxel = grid.VoxelAt(brick, place);
      if (glm::all(glm::lessThan(voxel, grid.Dimensions)) && this->At(voxel)[3] == 0)
      {
        this->SpreadInto(voxel);
      }
    }
  }

private:
  Scalar* At(const glm::ivec3& voxel) const
  {
    const glm::ivec3 size = this->Voxels.Grid.Dimensions;
    return this->Scalars +
      4 * (voxel.x + static_cast<long long>(size.x) * (voxel.y + static_cast<long long>(size.y) * voxel.z));
  }

  Scalar ToScalar(double value) const
  {
    const double scaled = std::clamp(value, 0.0, 1.0) * this->Largest;
    return static_cast<Scalar>(this->Largest > 1.0 ? std::round(scaled) : scaled);
  }

  void EvaluateVoxel(int place, std::vector<vtkTypeInt64>& next, const std::vector<vtkTypeInt64>& end,
    const double* basis, Scalar* rgba) const
  {
    glm::dvec3 color(0.0);
    double depth = 0.0;
    for (std::size_t t = 0; t < next.size(); ++t)
    {
      const LineCoefficients& set = this->Voxels.Types[t];
      if (next[t] < end[t] && set.Places[next[t]] == place)
      {
        const auto part = volumeoptics::EvaluateVoxel(set, next[t]++, basis, this->Scales[t]);
        color += part.Depth * part.Color;
        depth += part.Depth;
      }
    }
    if (depth > 0.0)
    {
      for (int c = 0; c < 3; ++c)
      {
        rgba[c] = this->ToScalar(color[c] / depth);
      }
      rgba[3] = this->ToScalar(optics::OneMinusExp(this->OpacityLength * this->DrawnDepth(depth)));
    }
  }

  double DrawnDepth(double depth) const
  {
    const double opacity = this->Function ? this->Function->GetValue(optics::OneMinusExp(depth)) : 0.0;
    return std::min(
      this->Function ? optics::OpticalDepth(std::clamp(opacity, 0.0, 1.0)) : depth, optics::LargestLineDepth);
  }

  bool HasOccupiedAround(long long brick) const
  {
    bool isOccupied = false;
    this->ForEachNeighbour(this->Voxels.Grid.FirstVoxelOf(brick) / this->Voxels.Grid.Brick,
      this->Voxels.Grid.Bricks(), [&](const glm::ivec3& other) {
        const long long number = this->Voxels.Grid.BrickOf(other * this->Voxels.Grid.Brick);
        isOccupied = isOccupied || this->Voxels.BrickIndices[number] >= 0;
      });
    return isOccupied;
  }

  void SpreadInto(const glm::ivec3& voxel) const
  {
    glm::dvec3 sum(0.0);
    double weight = 0.0;
    this->ForEachNeighbour(voxel, this->Voxels.Grid.Dimensions, [&](const glm::ivec3& other) {
      const Scalar* rgba = this->At(other);
      const double opacity = rgba[3];
      if (opacity > 0.0) // the colour of another one may be another thread's to write just now
      {
        sum += opacity * glm::dvec3(rgba[0], rgba[1], rgba[2]);
        weight += opacity;
      }
    });
    for (int c = 0; c < 3 && weight > 0.0; ++c)
    {
      this->At(voxel)[c] = this->ToScalar(sum[c] / weight / this->Largest);
    }
  }

  template <class Visit>
  static void ForEachNeighbour(const glm::ivec3& place, const glm::ivec3& size, const Visit& visit)
  {
    const glm::ivec3 first = glm::max(place - 1, glm::ivec3(0)), last = glm::min(place + 1, size - 1);
    for (int z = first.z; z <= last.z; ++z)
    {
      for (int y = first.y; y <= last.y; ++y)
      {
        for (int x = first.x; x <= last.x; ++x)
        {
          visit(glm::ivec3(x, y, z));
        }
      }
    }
  }

  const LineVoxels& Voxels;
  HarmonicBasis Basis;
  const ViewOfVoxels& Eye;
  bool PerVoxel;
  double Largest;
  Scalar* Scalars;
};
}

#endif
