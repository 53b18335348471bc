// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// A scene whose extinction a test states itself, point by point: what the double reference draws of volumes that are
// cropped, masked, classified by two functions, in ways that the reference has none of.

#ifndef ClassifiedByHand_h
#define ClassifiedByHand_h

#include "RayCaster.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>

namespace
{
// Per length of dataset space, at a point that the given field fills.
using Extinction = std::function<double(const reference::Field& field, const reference::Vector& point)>;

inline double ExtinctionOf(double opacity, double distance)
{
  return -std::log1p(-opacity) / distance;
}

// The scalar is the extinction itself, as a share of the largest one.
class ExtinctionField : public reference::Field
{
public:
  ExtinctionField(std::shared_ptr<const reference::Field> data, Extinction extinction, double largest)
    : Data(std::move(data))
    , AtPoint(std::move(extinction))
    , Largest(largest)
  {
  }
  double Value(const reference::Vector& p) const override
  {
    return this->AtPoint(*this->Data, p) / this->Largest;
  }
  reference::Vector Gradient(const reference::Vector& p) const override { return this->Data->Gradient(p); }

private:
  std::shared_ptr<const reference::Field> Data;
  Extinction AtPoint;
  double Largest;
};

// The same scene with that extinction; its colour must not depend on the scalar.
inline reference::Scene ClassifiedByHand(reference::Scene scene, const Extinction& extinction, double largest)
{
  scene.field = std::make_shared<ExtinctionField>(scene.field, extinction, largest);
  scene.opacity = vtkSmartPointer<vtkPiecewiseFunction>::New();
  // optical depths in steps of 1/64: their curve is a chord's width off, 3e-5
  for (int i = 0; i <= 64; ++i)
  {
    scene.opacity->AddPoint(i / 64.0, 1.0 - std::exp(-i / 64.0));
  }
  scene.unitDistance = 1.0 / largest;
  return scene;
}
}

#endif
