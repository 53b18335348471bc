// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The tangent frame of the unclassified scalar at a point: normal, gradient magnitude, anisotropy.

#ifndef FrameField_h
#define FrameField_h

#include "Field.h"

#include <functional>
#include <memory>

namespace reference
{
struct Frame
{
  Vector normal = Vector(0.0);             // -grad(s)/|grad(s)|, unit, or 0
  double magnitude = 0.0;                  // |grad(s)| per length of dataset space
  glm::dvec2 anisotropy = glm::dvec2(0.0); // (a1, a2) in the normal's basis, see AnisotropyFrame.glsl
};

class FrameField
{
public:
  virtual ~FrameField() = default;
  virtual Frame At(const Vector& point) const = 0;
};

// The frame of a field's own gradient; the anisotropy, if any, from a function of point and normal.
class ExactFrameField : public FrameField
{
public:
  using AnisotropyFunction = std::function<glm::dvec2(const Vector& point, const Vector& normal)>;

  explicit ExactFrameField(std::shared_ptr<const Field> field, AnisotropyFunction anisotropy = nullptr)
    : Scalars(std::move(field))
    , Anisotropy(std::move(anisotropy))
  {
  }
  Frame At(const Vector& point) const override;

private:
  std::shared_ptr<const Field> Scalars;
  AnisotropyFunction Anisotropy;
};

// How an array AmbientCovariance stores the anisotropy: see AnisotropyFrame.glsl.
enum class Storage
{
  Map = 0,    // 3 components
  Components, // 3 components
  World       // 5 components: xx yy xy xz yz
};

// The arrays Normals, GradientMagnitude and AmbientCovariance of the filters, interpolated and then
// decoded at the interpolated, normalised normal, as the mapper does. The images may be one and the
// same; without covariance (nullptr) the frame is isotropic. Directions are those of dataset space.
class GridFrameField : public FrameField
{
public:
  GridFrameField(vtkImageData* normals, vtkImageData* covariance = nullptr, Storage storage = Storage::Map);
  Frame At(const Vector& point) const override;

private:
  glm::dvec2 DecodedAnisotropy(const Vector& point, const Vector& normal) const;

  GridArray Normals;
  GridArray Magnitude;
  std::unique_ptr<GridArray> Covariance;
  Storage CovarianceStorage;
};
}

#endif
