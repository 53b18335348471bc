// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FrameField.h"

#include "Optics.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <stdexcept>

namespace reference
{
namespace
{
Vector UnitOrZero(const Vector& v)
{
  const double length = glm::length(v);
  return length > 0.0 ? v / length : Vector(0.0);
}
}

//------------------------------------------------------------------------------
Frame ExactFrameField::At(const Vector& point) const
{
  const Vector gradient = this->Scalars->Gradient(point);
  Frame frame;
  frame.magnitude = glm::length(gradient);
  frame.normal = UnitOrZero(-gradient);
  if (this->Anisotropy && frame.magnitude > 0.0)
  {
    frame.anisotropy = this->Anisotropy(point, frame.normal);
  }
  return frame;
}

//------------------------------------------------------------------------------
GridFrameField::GridFrameField(vtkImageData* normals, vtkImageData* covariance, Storage storage)
  : Normals(normals, normals->GetPointData()->GetArray("Normals"))
  , Magnitude(normals, normals->GetPointData()->GetArray("GradientMagnitude"))
  , CovarianceStorage(storage)
{
  if (!covariance)
  {
    return;
  }
  this->Covariance =
    std::make_unique<GridArray>(covariance, covariance->GetPointData()->GetArray("AmbientCovariance"));
  if (this->Covariance->GetNumberOfComponents() < (storage == Storage::World ? 5 : 3))
  {
    throw std::invalid_argument("AmbientCovariance has too few components for its storage.");
  }
}

//------------------------------------------------------------------------------
glm::dvec2 GridFrameField::DecodedAnisotropy(const Vector& point, const Vector& normal) const
{
  const Vector code = this->Covariance->InterpolateVector(point);
  switch (this->CovarianceStorage)
  {
    case Storage::Components:
      return optics::DecodeComponents(code);
    case Storage::World:
    {
      optics::WorldTensor tensor;
      tensor.diagonal = code;
      tensor.mixed =
        glm::dvec2(this->Covariance->Interpolate(point, 3), this->Covariance->Interpolate(point, 4));
      return optics::DecodeWorld(normal, tensor);
    }
    default:
      return optics::DecodeMap(normal, code);
  }
}

//------------------------------------------------------------------------------
Frame GridFrameField::At(const Vector& point) const
{
  Frame frame;
  frame.normal = UnitOrZero(this->Normals.InterpolateVector(point));
  frame.magnitude = this->Magnitude.Interpolate(point, 0);
  if (this->Covariance && frame.normal != Vector(0.0))
  {
    frame.anisotropy = this->DecodedAnisotropy(point, frame.normal);
  }
  return frame;
}
}
