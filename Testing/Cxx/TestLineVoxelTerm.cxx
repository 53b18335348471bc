// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Lines by the mapper against the evaluator's voxels drawn ray by ray in double: precisions, orders, exact product, line
// types, scales and opacity function, perspective and parallel views, transformed volumes, cropping, blocks.

#include "LineTermScene.h"

#include "vtkMatrix3x3.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPolyData.h"
#include "vtkTransform.h"

namespace
{
// Of half floats an opacity is good to 2^-12 of itself, and colour times opacity as well; a coefficient to as much of the
// degree 0, of which a voxel's look is a sum.
const double HalfFloats = 1.0e-3;
// Of bytes 14 coefficients are off by up to a 254th of the largest of them, a third of degree 0: a voxel's colour by .26 %
// (rms), a pixel that shows several voxels of .6 by .0007, the worst of 10,000 pixels by four times as much.
const double Bytes = 0.003;
// Positions in float, 1e-6 of a voxel and less, and the interpolation's weights.
const double Floats = 5.0e-5;

void CheckPicture(
  Check& check, const std::string& name, LineTermScene& scene, LinePicture& reference, double bound)
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
    scene.Mapper->SetLinePrecision(8);
    CheckPicture(check, view + "8 bits", scene, reference, Bytes);
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

// Two types of lines, of other colours, scaled each by its own factors; then an opacity function.
void CheckTypes(Check& check)
{
  const auto lines = lines::MakeLines(lines::RandomLines(300, 7));
  vtkNew<vtkIntArray> types;
  types->SetName("Type");
  for (vtkIdType i = 0; i < lines->GetNumberOfCells(); ++i)
  {
    types->InsertNextValue(i % 3 == 0 ? 5 : 2);
  }
  lines->GetCellData()->AddArray(types);
  vtkNew<vtkAnisotropicLineVoxelizer> voxelizer;
  voxelizer->SetInputData(lines);
  voxelizer->SetLineTypeArray("Type");
  voxelizer->SetSampleDimensions(20, 20, 20);
  voxelizer->SetModelBounds(0.0, 1.0, 0.0, 1.0, 0.0, 1.0);
  voxelizer->SetRadius(0.01);
  for (int type : { 2, 5 })
  {
    vtkNew<vtkProperty> material;
    material->SetColor(type == 2 ? 1.0 : 0.1, 0.4, type == 5 ? 1.0 : 0.2);
    voxelizer->SetMaterial(type, material);
  }
  const auto voxels = VoxelsOf(voxelizer);
  LineTermScene scene(voxels);
  scene.Mapper->SetLinePrecision(32);
  scene.Camera->SetFocalPoint(0.5, 0.5, 0.5);
  LinePicture reference(voxels, scene);
  const auto scale = [&](int type, double radius, double opacity) {
    scene.Mapper->SetLineRadiusScale(type, radius);
    reference.Evaluator->SetRadiusScale(type, radius);
    scene.Mapper->SetLineOpacityScale(type, opacity);
    reference.Evaluator->SetOpacityScale(type, opacity);
  };
  CheckPicture(check, "two types", scene, reference, Floats);
  scale(5, 3.0, 0.7);
  CheckPicture(check, "the second one scaled", scene, reference, Floats);
  scale(2, 0.0, 1.0);
  CheckPicture(check, "the first one hidden", scene, reference, Floats);
  vtkNew<vtkPiecewiseFunction> function;
  function->AddPoint(0.0, 0.0);
  function->AddPoint(0.1, 0.0);
  function->AddPoint(0.3, 0.6);
  function->AddPoint(1.0, 0.9);
  scene.Mapper->SetLineOpacityFunction(function);
  reference.Evaluator->SetOpacityFunction(function);
  // a table of 1024 entries bends where the function has a corner: by 1/1024 of its largest slope at most
  CheckPicture(check, "an opacity function", scene, reference, Floats + 4.0e-3);
}

// A volume that is moved, turned and scaled; parts hidden.
void CheckSpaces(Check& check)
{
  const auto voxels = Spirals(24, 24, 24);
  LineTermScene scene(voxels);
  scene.Mapper->SetLinePrecision(32);
  scene.Volume->RotateX(30.0);
  scene.Volume->RotateZ(20.0);
  scene.Volume->SetScale(0.8);
  scene.Volume->SetPosition(0.1, 0.2, -0.3);
  LinePicture reference(voxels, scene);
  CheckPicture(check, "moved, turned and scaled", scene, reference, Floats);

  scene.Mapper->SetCropping(1);
  scene.Mapper->SetCroppingRegionPlanes(-0.4, 0.3, -0.5, 0.6, -0.2, 0.5);
  reference.IsVisible = [](const glm::dvec3& p) {
    return p.x > -0.4 && p.x < 0.3 && p.y > -0.5 && p.y < 0.6 && p.z > -0.2 && p.z < 0.5;
  };
  // a sample within rounding of a plane may be on its other side: a step's opacity
  const PictureDifference cropped = Compare(scene.RenderFloat(), reference.Render());
  check.AtMost("cropped, mean", cropped.Mean, 1.0e-3);
  check.AtLeast("cropped", cropped.Brightest, 0.2);
  scene.Mapper->SetCropping(0);

  // clipped rays begin at the plane: samples elsewhere, of a step that is small against a voxel
  vtkNew<vtkPlane> plane;
  plane->SetNormal(0.3, 0.5, 1.0);
  plane->SetOrigin(scene.Volume->GetPosition());
  scene.Mapper->AddClippingPlane(plane);
  scene.Mapper->SetSampleDistance(0.005F);
  vtkNew<vtkMatrix4x4> toWorld;
  toWorld->DeepCopy(scene.Volume->GetMatrix());
  reference.IsVisible = [&](const glm::dvec3& p) {
    const double data[4] = { p.x, p.y, p.z, 1.0 };
    double world[4];
    toWorld->MultiplyPoint(data, world);
    return plane->EvaluateFunction(world) > 0.0;
  };
  const PictureDifference clipped = Compare(scene.RenderFloat(), reference.Render());
  check.AtMost("clipped, mean", clipped.Mean, 2.0e-3);
  check.AtLeast("clipped", clipped.Brightest, 0.2);
}

// An image that is turned about its origin by its direction matrix, and a volume that is turned so by its own.
void CheckDirection(Check& check)
{
  const auto voxels = Spirals(24, 24, 24);
  LineTermScene scene(voxels);
  scene.Mapper->SetLinePrecision(32);
  vtkNew<vtkTransform> turn;
  turn->RotateX(25.0);
  turn->RotateZ(-15.0);
  scene.Volume->SetOrigin(voxels->GetOrigin());
  scene.Volume->SetOrientation(turn->GetOrientation());
  const std::vector<float> byVolume = scene.RenderFloat();
  scene.Volume->SetOrientation(0.0, 0.0, 0.0);
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      voxels->GetDirectionMatrix()->SetElement(row, column, turn->GetMatrix()->GetElement(row, column));
    }
  }
  vtkNew<vtkImageData> turned;
  turned->ShallowCopy(voxels);
  turned->SetDirectionMatrix(voxels->GetDirectionMatrix());
  scene.Mapper->SetInputData(turned);
  const std::vector<float> byImage = scene.RenderFloat();
  double largest = 0.0, brightest = 0.0;
  for (std::size_t i = 0; i < byImage.size(); ++i)
  {
    largest = std::max(largest, std::abs(double(byImage[i]) - byVolume[i]));
    brightest = std::max<double>(brightest, byImage[i]);
  }
  check.AtMost("turned by the image's direction", largest, Floats);
  check.AtLeast("turned by the image's direction, brightness", brightest, 0.2);
}

// Single lines in a wide grid, whose sides are no whole bricks, from several sides: rays leap over many bricks, and over
// empty cells beside the lines.
void CheckLeaps(Check& check)
{
  vtkNew<vtkAnisotropicLineVoxelizer> voxelizer;
  voxelizer->SetInputData(lines::MakeLines(
    { { { -0.9, -0.8, -0.7 }, { 0.9, 0.3, 0.6 } }, { { 0.2, 0.99, -0.9 }, { 0.3, -0.99, 0.8 } },
      { { -0.999, 0.5, 0.2 }, { 0.999, 0.5, 0.25 } }, { { -0.4, -0.2, -0.999 }, { -0.4, -0.25, 0.999 } } }));
  voxelizer->SetSampleDimensions(101, 63, 90);
  voxelizer->SetModelBounds(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0);
  voxelizer->SetRadius(0.008);
  const auto voxels = VoxelsOf(voxelizer);
  LineTermScene scene(voxels, 60);
  scene.Mapper->SetLinePrecision(32);
  scene.Mapper->SetSampleDistance(0.011F);
  for (const glm::dvec3& position :
    { glm::dvec3(1.5, -4.0, 2.0), glm::dvec3(-4.0, 1.0, -1.0), glm::dvec3(0.5, 4.0, -0.5) })
  {
    scene.Camera->SetPosition(&position.x);
    LinePicture reference(voxels, scene);
    CheckPicture(check, "single lines", scene, reference, Floats);
  }
}

// A block of voxels half as large in place of a part of the spirals.
void CheckBlock(Check& check)
{
  const auto coarse = Spirals(24, 24, 24);
  vtkNew<vtkAnalyticLineSource> source;
  source->SetNumberOfSegments(4000);
  vtkNew<vtkAnisotropicLineVoxelizer> voxelizer;
  voxelizer->SetInputConnection(source->GetOutputPort());
  voxelizer->SetSampleDimensions(22, 14, 26);
  voxelizer->SetModelBounds(-0.5, 0.41, -0.9, 0.3, -0.6, 0.5);
  voxelizer->SetRadius(0.01);
  const auto fine = VoxelsOf(voxelizer);
  LineTermScene scene(coarse);
  scene.Mapper->SetLinePrecision(32);
  const auto without = scene.Render();
  scene.Mapper->SetLineBlockInputData(fine);
  LinePicture reference(coarse, scene), block(fine, scene);
  block.Update();
  reference.Replacement = [&](const glm::dvec3& p) { return block.Contains(p) ? &block : nullptr; };
  // a sample within rounding of a face may be on its other side
  const PictureDifference difference = Compare(scene.RenderFloat(), reference.Render());
  check.AtMost("block, mean", difference.Mean, 2.0e-4);
  check.AtMost("block, largest", difference.Largest, 0.05);
  check.That(scene.Render() != without, "the block is not drawn");
  scene.Mapper->SetLineBlockInputConnection(nullptr);
  check.That(scene.Render() == without, "a block that is taken away is drawn");
  const lines::Messages messages(scene.Mapper);
  voxelizer->SetInputData(vtkNew<vtkPolyData>());
  scene.Mapper->SetLineBlockInputData(VoxelsOf(voxelizer));
  check.That(scene.Render() == without, "a block without lines is left out");
  check.That(messages.Has("holds no lines"), "as is said, once");
}
}

int TestLineVoxelTerm(int, char*[])
{
  Check check;
  CheckPrecisions(check);
  CheckOrders(check);
  CheckTypes(check);
  CheckSpaces(check);
  CheckDirection(check);
  CheckLeaps(check);
  CheckBlock(check);
  return check.ExitCode();
}
