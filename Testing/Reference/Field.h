// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Scalar fields as the reference renderer sees them: a value and a gradient at a point.

#ifndef Field_h
#define Field_h

#include "AnalyticFields.h"
#include "Grid.h"

namespace reference
{
class Field
{
public:
  virtual ~Field() = default;
  virtual double Value(const Vector& point) const = 0;
  // Per length of dataset space.
  virtual Vector Gradient(const Vector& point) const = 0;
};

// A field in closed form, with its exact gradient.
class ExactField : public Field
{
public:
  explicit ExactField(int type, const analytic::Parameters& parameters = analytic::Parameters())
    : Formula(type, parameters)
  {
  }
  double Value(const Vector& p) const override { return this->Formula.Value({ p.x, p.y, p.z }); }
  Vector Gradient(const Vector& p) const override
  {
    const analytic::Dual dual = this->Formula.ValueAndGradient({ p.x, p.y, p.z });
    return Vector(dual.gradient[0], dual.gradient[1], dual.gradient[2]);
  }

private:
  analytic::AnalyticField Formula;
};

// Point scalars of an image (the given component), interpolated; the gradient by central differences
// over one voxel to either side, as VTK's mapper takes it.
class GridField : public Field
{
public:
  explicit GridField(vtkImageData* image, int component = 0);
  const Grid& GetGrid() const { return this->Scalars.GetGrid(); }
  double Value(const Vector& point) const override
  {
    return this->Scalars.Interpolate(point, this->Component);
  }
  Vector Gradient(const Vector& point) const override;

private:
  GridArray Scalars;
  int Component;
};
}

#endif
