// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The volume rendering integral between two scalars by adaptive quadrature: the truth for
// vtkPreIntegratedTable, with which it shares no code.

#ifndef TransferIntegral_h
#define TransferIntegral_h

#include "Grid.h"

#include <vector>

class vtkColorTransferFunction;
class vtkPiecewiseFunction;

namespace reference
{
// Of a segment of a ray.
struct SegmentIntegral
{
  double depth = 0.0;
  double opacity = 0.0;
  Vector color = Vector(0.0); // associated
};

// Front to back.
SegmentIntegral Composite(const SegmentIntegral& front, const SegmentIntegral& back);

class TransferIntegral
{
public:
  // The functions must outlive it, unchanged.
  TransferIntegral(vtkPiecewiseFunction* opacity, vtkColorTransferFunction* color, double tolerance = 1.0e-9);

  // Along scalars from front to back, [Kraus2005] eqs 6 and 7. attenuation: per unit of the scalar, of an
  // optical depth of 1. Colours and opacity up to the tolerance in each part between two nodes.
  SegmentIntegral Between(double front, double back, double attenuation) const;

  // A scalar that stays the same over an optical path of this length.
  SegmentIntegral At(double scalar, double length) const;

  // Optical depth from a scalar, upwards or downwards, to where its peak ends: the next node at which the
  // opacity is 0, or the last one; 0 where it is 0 itself. For an attenuation of 1.
  double DepthToEnd(double scalar, bool isUpward) const;

private:
  bool IsTransparentAt(double scalar) const;
  SegmentIntegral Slab(double front, double back, double attenuation) const;
  SegmentIntegral Refined(
    double front, double back, double attenuation, const SegmentIntegral& whole, int levels) const;

  vtkPiecewiseFunction* Opacity;
  vtkColorTransferFunction* Color;
  double Tolerance;
  std::vector<double> Nodes; // ascending, with the midpoints, where the functions may bend or jump
};
}

#endif
