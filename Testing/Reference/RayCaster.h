// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The double-precision ray caster: the truth for every accuracy figure.

#ifndef RayCaster_h
#define RayCaster_h

#include "Scene.h"

#include "vtkSmartPointer.h"

#include <vector>

class vtkImageData;

namespace reference
{
// As VTK's shader.
constexpr double EarlyTerminationOpacity = 1.0 - 1.0 / 255.0;

// Associated colour and opacity, unclamped; row 0 is the lowest, as in VTK.
struct Image
{
  int width = 0;
  int height = 0;
  std::vector<glm::dvec4> pixels;

  const glm::dvec4& At(int x, int y) const { return this->pixels[static_cast<size_t>(y) * this->width + x]; }
};

struct Ray
{
  Vector origin;    // on the near plane
  Vector direction; // unit
  Interval inside;  // the part in the volume and in front of the near plane
};
// Through a point of the picture in pixels: the middle of the lower left one is (0.5, 0.5).
Ray RayThrough(const Scene& scene, double x, double y);

glm::dvec4 IntegrateRay(const Scene& scene, const Ray& ray);

// All pixels, threaded by vtkSMPTools. Throws std::invalid_argument if the scene lacks something.
Image Render(const Scene& scene);

// Over a background; opaque.
Image Over(const Image& image, const Vector& background);

// Four components of doubles named RGBA.
vtkSmartPointer<vtkImageData> ToImageData(const Image& image);

// Difference of red, green and blue, where 1 is white.
struct Difference
{
  double rootMeanSquare = 0.0;
  double maximum = 0.0;
};
Difference Compare(const Image& image, const Image& other);

// Against a picture of three or four components: of unsigned char (the reference is then clamped to
// [0, 1]) or of floating point (it is not). The reference is put over the background first.
Difference Compare(const Image& image, vtkImageData* picture, const Vector& background = Vector(0.0));
}

#endif
