// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TransferIntegral.h"

#include "Optics.h"

#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"

#include <algorithm>
#include <cmath>

namespace reference
{
namespace
{
// A part is halved this often at most: 1e-12 of it, where a curve begins with an infinite slope.
const int LargestLevel = 40;

double DepthOf(double opacity)
{
  return opacity < 1.0 ? -std::log1p(-std::max(opacity, 0.0)) : optics::OpaqueDepth;
}

void AddNode(double scalar, double next, double midpoint, std::vector<double>& nodes)
{
  nodes.push_back(scalar);
  nodes.push_back(scalar + midpoint * (next - scalar));
}
}

//------------------------------------------------------------------------------
SegmentIntegral Composite(const SegmentIntegral& front, const SegmentIntegral& back)
{
  const double through = std::exp(-front.depth);
  return { front.depth + back.depth, front.opacity + through * back.opacity,
    front.color + through * back.color };
}

//------------------------------------------------------------------------------
TransferIntegral::TransferIntegral(
  vtkPiecewiseFunction* opacity, vtkColorTransferFunction* color, double tolerance)
  : Opacity(opacity)
  , Color(color)
  , Tolerance(tolerance)
{
  for (int i = 0; i < opacity->GetSize(); ++i)
  {
    double node[4];
    double next[4];
    opacity->GetNodeValue(i, node);
    opacity->GetNodeValue(std::min(i + 1, opacity->GetSize() - 1), next);
    AddNode(node[0], next[0], node[2], this->Nodes);
  }
  for (int i = 0; i < color->GetSize(); ++i)
  {
    double node[6];
    double next[6];
    color->GetNodeValue(i, node);
    color->GetNodeValue(std::min(i + 1, color->GetSize() - 1), next);
    AddNode(node[0], next[0], node[4], this->Nodes);
  }
  std::sort(this->Nodes.begin(), this->Nodes.end());
}

//------------------------------------------------------------------------------
SegmentIntegral TransferIntegral::At(double scalar, double length) const
{
  SegmentIntegral slab;
  slab.depth = DepthOf(this->Opacity->GetValue(scalar)) * length;
  slab.opacity = -std::expm1(-slab.depth);
  double rgb[3];
  this->Color->GetColor(scalar, rgb);
  slab.color = slab.opacity * Vector(rgb[0], rgb[1], rgb[2]);
  return slab;
}

//------------------------------------------------------------------------------
// Three slabs at the places of Gauss's rule, whose weights are their widths: exact to the fifth power in
// the depth; none of the places is an end, where the functions may jump.
SegmentIntegral TransferIntegral::Slab(double front, double back, double attenuation) const
{
  const double places[3] = { 0.5 - std::sqrt(0.15), 0.5, 0.5 + std::sqrt(0.15) };
  const double weights[3] = { 5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0 };
  const double length = attenuation * std::abs(back - front);
  SegmentIntegral sum;
  for (int i = 0; i < 3; ++i)
  {
    sum = Composite(sum, this->At(front + places[i] * (back - front), weights[i] * length));
  }
  return sum;
}

//------------------------------------------------------------------------------
SegmentIntegral TransferIntegral::Refined(
  double front, double back, double attenuation, const SegmentIntegral& whole, int levels) const
{
  const double middle = front + 0.5 * (back - front);
  const SegmentIntegral near = this->Slab(front, middle, attenuation);
  const SegmentIntegral far = this->Slab(middle, back, attenuation);
  const SegmentIntegral both = Composite(near, far);
  const Vector change = glm::abs(both.color - whole.color);
  const double error = std::max({ change.x, change.y, change.z, std::abs(both.opacity - whole.opacity) });
  // relative, so that what is nearly transparent is exact, too; the depth, so that what is opaque is
  const bool isExact = error <= this->Tolerance * both.opacity &&
    std::abs(both.depth - whole.depth) <= this->Tolerance * both.depth;
  if (levels == 0 || isExact)
  {
    return both;
  }
  return Composite(this->Refined(front, middle, attenuation, near, levels - 1),
    this->Refined(middle, back, attenuation, far, levels - 1));
}

//------------------------------------------------------------------------------
SegmentIntegral TransferIntegral::Between(double front, double back, double attenuation) const
{
  std::vector<double> cuts = { std::min(front, back) };
  for (auto node = std::upper_bound(this->Nodes.begin(), this->Nodes.end(), cuts.front());
       node != this->Nodes.end() && *node < std::max(front, back); ++node)
  {
    cuts.push_back(*node);
  }
  cuts.push_back(std::max(front, back));
  if (back < front)
  {
    std::reverse(cuts.begin(), cuts.end());
  }
  SegmentIntegral sum;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
  {
    const SegmentIntegral whole = this->Slab(cuts[i], cuts[i + 1], attenuation);
    sum = Composite(sum, this->Refined(cuts[i], cuts[i + 1], attenuation, whole, LargestLevel));
  }
  return sum;
}

//------------------------------------------------------------------------------
// Just below and just above, for the functions may jump.
bool TransferIntegral::IsTransparentAt(double scalar) const
{
  const double aside = 1.0e-12 * (this->Nodes.back() - this->Nodes.front());
  return std::min(this->Opacity->GetValue(scalar - aside), this->Opacity->GetValue(scalar + aside)) <= 1.0e-9;
}

//------------------------------------------------------------------------------
double TransferIntegral::DepthToEnd(double scalar, bool isUpward) const
{
  if (!(this->Opacity->GetValue(scalar) > 0.0))
  {
    return 0.0;
  }
  std::vector<double> ahead;
  for (double node : this->Nodes)
  {
    if (isUpward ? node > scalar : node < scalar)
    {
      ahead.push_back(node);
    }
  }
  if (!isUpward)
  {
    std::reverse(ahead.begin(), ahead.end());
  }
  const auto end =
    std::find_if(ahead.begin(), ahead.end(), [this](double node) { return this->IsTransparentAt(node); });
  if (ahead.empty())
  {
    return 0.0;
  }
  return this->Between(scalar, end == ahead.end() ? ahead.back() : *end, 1.0).depth;
}
}
