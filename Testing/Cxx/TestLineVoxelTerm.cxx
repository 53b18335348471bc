// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Lines by the mapper against the evaluator's voxels drawn ray by ray in double: precisions, orders, exact product, line
// types, scales and opacity function, perspective and parallel views, transformed volumes, cropping, blocks.

#include "LineTermScene.h"

#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"

namespace
{
// Of half floats an opacity is good to 2^-12, of itself at most; a ray adds up a few of them, weighted by what is left of 1.
const double HalfFloats = 2.0e-3;
// Positions in float, at most 1e-6 of the box: 1e-4 of the distance between two voxels, whose opacities differ by less
// than 1; and the interpolation's weights.
const double Floats = 2.0e-4;

void CheckPicture(Check& check, const std::string& name, LineTermScene& scene, LinePicture& reference, double bound)
{
  const PictureDifference difference = Compare(scene.RenderFloat(), reference.Render());
  std::cout << name << ": largest " << difference.Largest << ", mean " << difference.Mean << std::endl;
  check.AtLeast(name + ", something is drawn", difference.Brightest, 0.2);
  check.AtMost(name, difference.Largest, bound);
}

void CheckPrecisions(Check& check)
{
  const auto voxels = Spirals(30, 34, 21);
  LineTermScene scene(voxels);
  for (int parallel = 0; parallel < 2; ++parallel)
  {
    scene.Camera->SetParallelProjection(parallel);
    scene.Camera->SetParallelScale(1.2);
    const std::string view = parallel ? "parallel, " : "perspective, ";
    LinePicture reference(voxels, scene);
    scene.Mapper->SetLinePrecision(16);
    CheckPicture(check, view + "16 bits", scene, reference, HalfFloats);
    scene.Mapper->SetLinePrecision(32);
    CheckPicture(check, view + "32 bits", scene, reference, Floats);
  }
}

void CheckOrders(Check& check)
{
  for (int order : { 0, 1, 8, 12 })
  {
    const auto voxels = Spirals(24, 24, 24, order, order == 8);
    LineTermScene scene(voxels);
    scene.Mapper->SetLinePrecision(32);
    LinePicture reference(voxels, scene);
    CheckPicture(check, "order " + std::to_string(order), scene, reference, Floats);
  }
}
}

int TestLineVoxelTerm(int, char*[])
{
  Check check;
  CheckPrecisions(check);
  CheckOrders(check);
  return check.ExitCode();
}
