// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "RayCaster.h"

#include "LightingTransfer.h"
#include "SegmentRay.h"
#include "Shading.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace reference
{
namespace
{
Vector Unproject(const Camera& camera, double x, double y, double depth)
{
  const glm::dvec4 device(2.0 * x / camera.width - 1.0, 2.0 * y / camera.height - 1.0, depth, 1.0);
  const glm::dvec4 point = camera.deviceToDataset * device;
  return Vector(point) / point.w;
}

// Before any thread starts: what is missing.
void RequireComplete(const Scene& scene)
{
  if (!scene.field || !scene.opacity || !scene.color)
  {
    throw std::invalid_argument("A scene needs a field, an opacity and a colour function.");
  }
  const bool reflects = scene.reflectance != Reflectance::VTK && scene.reflectance != Reflectance::None;
  if (scene.shade && reflects && !scene.frames)
  {
    throw std::invalid_argument("Blinn-Phong, Ward and Lafortune need frames: set Scene::frames.");
  }
  if (!(scene.step > 0.0) || !(scene.unitDistance > 0.0))
  {
    throw std::invalid_argument("Step and unit distance of a scene must be above 0.");
  }
}

Difference Summarize(double sumOfSquares, double maximum, size_t pixels)
{
  const double count = std::max(3.0 * static_cast<double>(pixels), 1.0);
  return { std::sqrt(sumOfSquares / count), maximum };
}
}

//------------------------------------------------------------------------------
Ray RayThrough(const Scene& scene, double x, double y)
{
  const Vector nearPoint = Unproject(scene.camera, x, y, -1.0);
  const Vector farPoint = Unproject(scene.camera, x, y, 1.0);
  Ray ray;
  ray.origin = nearPoint;
  ray.direction = glm::normalize(farPoint - nearPoint);
  ray.inside = Intersect(scene.grid, ray.origin, ray.direction);
  const Vector axis =
    glm::normalize(Unproject(scene.camera, 0.5 * scene.camera.width, 0.5 * scene.camera.height, 1.0) -
      Unproject(scene.camera, 0.5 * scene.camera.width, 0.5 * scene.camera.height, -1.0));
  ray.inside.entry = std::max(ray.inside.entry, scene.camera.nearOffset / glm::dot(ray.direction, axis));
  return ray;
}

//------------------------------------------------------------------------------
// Front-to-back compositing of (alpha R, alpha). As in VTK, a ray that meets the volume takes its first
// sample in any case. A sample on the far face belongs to the ray, whatever rounding says.
glm::dvec4 IntegrateRay(const Scene& scene, const Ray& ray)
{
  if (GoesBySegments(scene))
  {
    return IntegrateSegments(scene, ray);
  }
  glm::dvec4 sum(0.0);
  if (ray.inside.entry >= ray.inside.exit)
  {
    return sum;
  }
  Sample sample;
  sample.entry = ray.origin + ray.inside.entry * ray.direction;
  sample.toViewer = -ray.direction;
  const double steps = (ray.inside.exit - ray.inside.entry) / scene.step + 1.0e-9;
  double at = scene.firstSample;
  do
  {
    sample.position = sample.entry + at * scene.step * ray.direction;
    sample.scalar = scene.field->Value(sample.position);
    const Classified classified = ClassifiedAt(scene, sample);
    if (classified.opacity > 0.0)
    {
      const Vector radiance = Radiance(scene, sample, classified.color, 0.0);
      sum += (1.0 - sum.a) * classified.opacity * glm::dvec4(radiance, 1.0);
    }
    at += 1.0;
  } while (at <= steps && !(scene.terminatesEarly && sum.a > EarlyTerminationOpacity));
  return sum;
}

//------------------------------------------------------------------------------
Image Render(const Scene& scene)
{
  RequireComplete(scene);
  Image image;
  image.width = scene.camera.width;
  image.height = scene.camera.height;
  image.pixels.resize(static_cast<size_t>(image.width) * image.height);
  vtkSMPTools::For(0, image.height, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType y = begin; y < end; ++y)
    {
      for (int x = 0; x < image.width; ++x)
      {
        image.pixels[static_cast<size_t>(y) * image.width + x] =
          IntegrateRay(scene, RayThrough(scene, x + 0.5, y + 0.5));
      }
    }
  });
  return image;
}

//------------------------------------------------------------------------------
Image Over(const Image& image, const Vector& background)
{
  Image result = image;
  for (glm::dvec4& pixel : result.pixels)
  {
    pixel += (1.0 - pixel.a) * glm::dvec4(background, 1.0);
  }
  return result;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> ToImageData(const Image& image)
{
  auto result = vtkSmartPointer<vtkImageData>::New();
  result->SetDimensions(image.width, image.height, 1);
  result->AllocateScalars(VTK_DOUBLE, 4);
  result->GetPointData()->GetScalars()->SetName("RGBA");
  auto* values = static_cast<double*>(result->GetScalarPointer());
  for (const glm::dvec4& pixel : image.pixels)
  {
    for (int c = 0; c < 4; ++c)
    {
      *values++ = pixel[c];
    }
  }
  return result;
}

//------------------------------------------------------------------------------
Difference Compare(const Image& image, const Image& other)
{
  if (image.width != other.width || image.height != other.height)
  {
    throw std::invalid_argument("Pictures of different size can't be compared.");
  }
  double sumOfSquares = 0.0;
  double maximum = 0.0;
  for (size_t i = 0; i < image.pixels.size(); ++i)
  {
    const Vector difference = Vector(image.pixels[i]) - Vector(other.pixels[i]);
    sumOfSquares += glm::dot(difference, difference);
    for (int c = 0; c < 3; ++c)
    {
      maximum = std::max(maximum, std::abs(difference[c]));
    }
  }
  return Summarize(sumOfSquares, maximum, image.pixels.size());
}

//------------------------------------------------------------------------------
Difference Compare(const Image& image, vtkImageData* picture, const Vector& background)
{
  vtkDataArray* scalars = picture->GetPointData()->GetScalars();
  const int* dimensions = picture->GetDimensions();
  if (!scalars || scalars->GetNumberOfComponents() < 3)
  {
    throw std::invalid_argument("The picture to compare with needs three or four components.");
  }
  const bool isByte = scalars->GetDataType() == VTK_UNSIGNED_CHAR;
  Image other;
  other.width = dimensions[0];
  other.height = dimensions[1];
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    const Vector rgb(scalars->GetComponent(i, 0), scalars->GetComponent(i, 1), scalars->GetComponent(i, 2));
    other.pixels.emplace_back(isByte ? rgb / 255.0 : rgb, 1.0);
  }
  Image shown = Over(image, background);
  if (isByte)
  {
    for (glm::dvec4& pixel : shown.pixels)
    {
      pixel = glm::clamp(pixel, 0.0, 1.0);
    }
  }
  return Compare(shown, other);
}
}
