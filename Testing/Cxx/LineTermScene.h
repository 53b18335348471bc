// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Lines drawn by the mapper, and the same picture in double: the evaluator's voxels along each pixel's ray.

#ifndef LineTermScene_h
#define LineTermScene_h

#include "FloatTarget.h"
#include "LineTesting.h"
#include "WindowPixels.h"
#include "vtkAnalyticLineSource.h"
#include "vtkOpticsVolumeMapper.h"

#include "vtkCamera.h"
#include "vtkFloatArray.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <glm/gtc/type_ptr.hpp>

#include <functional>
#include <memory>

namespace
{
[[maybe_unused]] vtkSmartPointer<vtkImageData> VoxelsOf(vtkAnisotropicLineVoxelizer* voxelizer)
{
  voxelizer->Update();
  auto copy = vtkSmartPointer<vtkImageData>::New();
  copy->DeepCopy(voxelizer->GetOutput());
  return copy;
}

// Spirals in [-1, 1]^3.
[[maybe_unused]] vtkSmartPointer<vtkImageData> Spirals(
  int x, int y, int z, int order = 4, bool exactProduct = false, int segments = 4000, double radius = 0.01)
{
  vtkNew<vtkAnalyticLineSource> source;
  source->SetNumberOfSegments(segments);
  vtkNew<vtkAnisotropicLineVoxelizer> voxelizer;
  voxelizer->SetInputConnection(source->GetOutputPort());
  voxelizer->SetSampleDimensions(x, y, z);
  voxelizer->SetModelBounds(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0);
  voxelizer->SetRadius(radius);
  voxelizer->SetMaximumOrder(order);
  voxelizer->SetExactProduct(exactProduct);
  return VoxelsOf(voxelizer);
}

struct LineTermScene
{
  explicit LineTermScene(vtkImageData* voxels, int size = 100)
  {
    this->Mapper->SetInputData(voxels);
    this->Mapper->SetAutoAdjustSampleDistances(0);
    this->Mapper->SetSampleDistance(0.03F);
    this->Mapper->SetUseJittering(0);
    this->Volume->SetMapper(this->Mapper);
    this->Renderer->AddVolume(this->Volume);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(size, size);
    this->Window->AddRenderer(this->Renderer);
    this->Camera = this->Renderer->GetActiveCamera();
    this->Camera->SetPosition(1.5, -4.0, 2.0);
    this->Camera->SetViewUp(0.0, 0.0, 1.0);
    this->Camera->SetClippingRange(1.0, 10.0);
  }

  std::vector<unsigned char> Render() { return RenderPixels(this->Window); }
  std::vector<float> RenderFloat() { return ::RenderFloat(this->Window, this->Renderer); }

  vtkNew<vtkOpticsVolumeMapper> Mapper;
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkRenderer> Renderer;
  vtkSmartPointer<vtkRenderWindow> Window = vtkSmartPointer<vtkRenderWindow>::New();
  vtkCamera* Camera;
};

// Colours and opacities of voxels as the evaluator gives them, drawn ray by ray.
class LinePicture
{
public:
  LinePicture(vtkImageData* voxels, LineTermScene& scene)
    : Scene(scene)
    , Grid(GridOf(voxels))
  {
    // the camera in the coordinates of the voxels
    vtkNew<vtkMatrix4x4> worldToData;
    vtkMatrix4x4::Invert(scene.Volume->GetMatrix(), worldToData);
    this->WorldToData = glm::transpose(glm::make_mat4(worldToData->GetData()));
    vtkNew<vtkCamera> camera;
    camera->DeepCopy(scene.Camera);
    const glm::dvec3 position = this->Transform(this->WorldToData, scene.Camera->GetPosition());
    const glm::dvec3 focalPoint = this->Transform(this->WorldToData, scene.Camera->GetFocalPoint());
    camera->SetPosition(position.x, position.y, position.z);
    camera->SetFocalPoint(focalPoint.x, focalPoint.y, focalPoint.z);
    this->Evaluator->SetInputData(voxels);
    this->Evaluator->SetCamera(camera);
    this->Evaluator->SetOutputScalarType(VTK_FLOAT);
    this->Evaluator->SetOpacityLength(1.0);
    this->Evaluator->MarkOpacityRangeOff();
  }

  vtkNew<vtkAnisotropicVoxelEvaluator> Evaluator;
  // What is drawn of the data; all of it if empty.
  std::function<bool(const glm::dvec3&)> IsVisible;
  // Whether to look for a point in another picture's voxels.
  std::function<const LinePicture*(const glm::dvec3&)> Replacement;

  // Associated colour, opacity; row 0 is the lowest.
  std::vector<glm::dvec4> Render()
  {
    this->Update();
    const int* size = this->Scene.Window->GetSize();
    vtkMatrix4x4* toDevice =
      this->Scene.Camera->GetCompositeProjectionTransformMatrix(double(size[0]) / size[1], -1.0, 1.0);
    vtkNew<vtkMatrix4x4> inverse;
    vtkMatrix4x4::Invert(toDevice, inverse);
    const glm::dmat4 toData = this->WorldToData * glm::transpose(glm::make_mat4(inverse->GetData()));
    std::vector<glm::dvec4> pixels;
    for (int y = 0; y < size[1]; ++y)
    {
      for (int x = 0; x < size[0]; ++x)
      {
        const double device[2] = { (x + 0.5) / size[0] * 2.0 - 1.0, (y + 0.5) / size[1] * 2.0 - 1.0 };
        const double front[3] = { device[0], device[1], -1.0 }, back[3] = { device[0], device[1], 1.0 };
        pixels.push_back(this->Cast(Transform(toData, front), Transform(toData, back)));
      }
    }
    return pixels;
  }

  void Update()
  {
    this->Evaluator->Update();
    this->Rgba = vtkFloatArray::SafeDownCast(this->Evaluator->GetOutput()->GetPointData()->GetScalars());
  }

  // Colour, extinction by length.
  glm::dvec4 At(const glm::dvec3& point) const
  {
    const LinePicture* other = this->Replacement ? this->Replacement(point) : nullptr;
    return other ? other->Interpolate(point) : this->Interpolate(point);
  }

  bool Contains(const glm::dvec3& point) const
  {
    const glm::dvec3 voxel = (point - this->Grid.Corner) / this->Grid.Voxel;
    return glm::all(glm::greaterThanEqual(voxel, glm::dvec3(0.0))) &&
      glm::all(glm::lessThanEqual(voxel, glm::dvec3(this->Grid.Dimensions)));
  }

private:
  static volumeoptics::LineGrid GridOf(vtkImageData* voxels)
  {
    std::string error;
    return volumeoptics::LineVoxels(voxels, error).Grid;
  }

  static glm::dvec3 Transform(const glm::dmat4& matrix, const double* point)
  {
    const glm::dvec4 moved = matrix * glm::dvec4(point[0], point[1], point[2], 1.0);
    return glm::dvec3(moved) / moved.w;
  }

  // Depths, and colours weighted by them, between the voxels' middles, constant beyond the outermost ones.
  glm::dvec4 Interpolate(const glm::dvec3& point) const
  {
    const glm::dvec3 voxel = (point - this->Grid.Corner) / this->Grid.Voxel;
    const glm::ivec3 size = this->Grid.Dimensions;
    if (!this->Contains(point))
    {
      return glm::dvec4(0.0);
    }
    const glm::dvec3 middles = glm::clamp(voxel - 0.5, glm::dvec3(0.0), glm::dvec3(size - 1));
    const glm::ivec3 first = glm::min(glm::ivec3(middles), glm::max(size - 2, glm::ivec3(0)));
    const glm::dvec3 share = middles - glm::dvec3(first);
    glm::dvec4 sum(0.0);
    for (int corner = 0; corner < 8; ++corner)
    {
      const glm::ivec3 offset(corner & 1, corner >> 1 & 1, corner >> 2);
      const glm::ivec3 at = glm::min(first + offset, size - 1);
      const glm::dvec3 weights = glm::mix(1.0 - share, share, glm::dvec3(offset));
      const float* rgba =
        this->Rgba->GetPointer(4 * (at.x + static_cast<vtkIdType>(size.x) * (at.y + size.y * at.z)));
      const double depth = std::min(-std::log1p(-std::min(double(rgba[3]), 1.0 - 1e-16)), 12.0);
      sum += weights.x * weights.y * weights.z * depth * glm::dvec4(rgba[0], rgba[1], rgba[2], 1.0);
    }
    const double unit = 4.0 * this->Grid.Volume() / this->Grid.Surface();
    return glm::dvec4(glm::dvec3(sum) / std::max(sum.w, 1e-300), sum.w / unit);
  }

  // VTK's samples: from a step behind the entry on, as long as they are inside.
  glm::dvec4 Cast(const glm::dvec3& front, const glm::dvec3& back) const
  {
    const glm::dvec3 way = glm::normalize(back - front);
    const glm::dvec3 bricks = glm::dvec3(this->Grid.Bricks() * this->Grid.Brick) * this->Grid.Voxel;
    const glm::dvec3 first = (this->Grid.Corner - front) / way;
    const glm::dvec3 second = (this->Grid.Corner + bricks - front) / way;
    const glm::dvec3 near = glm::min(first, second), far = glm::max(first, second);
    const double entry = std::max({ near.x, near.y, near.z, 0.0 }), exit = std::min({ far.x, far.y, far.z });
    const double step = this->Scene.Mapper->GetSampleDistance();
    glm::dvec4 picture(0.0);
    for (double t = entry + step; t <= exit && picture.w <= 1.0 - 1.0 / 255.0; t += step)
    {
      const glm::dvec3 point = front + t * way;
      const glm::dvec4 lines = this->IsVisible && !this->IsVisible(point) ? glm::dvec4(0.0) : this->At(point);
      const double opacity = -std::expm1(-lines.w * step);
      picture += (1.0 - picture.w) * opacity * glm::dvec4(glm::dvec3(lines), 1.0);
    }
    return picture;
  }

  LineTermScene& Scene;
  volumeoptics::LineGrid Grid;
  glm::dmat4 WorldToData;
  vtkFloatArray* Rgba = nullptr;
};

struct PictureDifference
{
  double Largest = 0.0;
  double Mean = 0.0;      // over the pixels that are covered
  double Brightest = 0.0; // of the reference
};

// pixels: of a float target with a black background.
[[maybe_unused]] PictureDifference Compare(
  const std::vector<float>& pixels, const std::vector<glm::dvec4>& reference)
{
  PictureDifference difference;
  double covered = 0.0;
  for (std::size_t i = 0; i < reference.size(); ++i)
  {
    double largest = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      largest = std::max(largest, std::abs(pixels[4 * i + c] - reference[i][c]));
      difference.Brightest = std::max(difference.Brightest, reference[i][c]);
    }
    difference.Largest = largest <= difference.Largest ? difference.Largest : largest; // a NaN stays
    difference.Mean += largest;
    covered += reference[i].w > 0.0 ? 1.0 : 0.0;
  }
  difference.Mean /= std::max(covered, 1.0);
  return difference;
}
}

#endif
