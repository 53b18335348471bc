// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TransferFunctionStretches.h"

#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace volumeoptics
{
namespace
{
// Cuts nearer than this fraction of the range are one: scalars have no more digits.
const double LeastWidth = 1.0e-13;

// Pieces that no part of the range is longer than, whatever the table's size, and pieces between two cuts.
const double LongestPiece = 1.0 / 1024.0;
const int LeastPieces = 4;

// On each side of a curve's midpoint.
const int CutsOfCurve = 8;

// VTK's own limits: below it joins nodes by lines, above by a step.
const double LeastSharpness = 0.01;
const double LargestMidpoint = 0.99999;

struct Node
{
  double X;
  double Midpoint;
  double Sharpness;
};

std::vector<Node> NodesOf(vtkPiecewiseFunction* function)
{
  std::vector<Node> nodes;
  for (int i = 0; i < function->GetSize(); ++i)
  {
    double node[4];
    function->GetNodeValue(i, node);
    nodes.push_back({ node[0], node[2], node[3] });
  }
  return nodes;
}

std::vector<Node> NodesOf(vtkColorTransferFunction* function)
{
  std::vector<Node> nodes;
  for (int i = 0; i < function->GetSize(); ++i)
  {
    double node[6];
    function->GetNodeValue(i, node);
    nodes.push_back({ node[0], node[4], node[5] });
  }
  return nodes;
}

class Cuts
{
public:
  Cuts(const double range[2], int parts)
    : First(range[0])
    , Width(range[1] - range[0])
  {
    for (int i = 0; i <= parts; ++i)
    {
      this->Places.push_back(static_cast<double>(i) / parts);
    }
  }

  void AddNodes(const std::vector<Node>& nodes, bool allCurved)
  {
    for (std::size_t i = 0; i < nodes.size(); ++i)
    {
      this->Add(nodes[i].X);
      if (i + 1 < nodes.size() && nodes[i + 1].X > nodes[i].X)
      {
        this->AddBetween(nodes[i], nodes[i + 1].X, allCurved || nodes[i].Sharpness >= LeastSharpness);
      }
    }
  }

  std::vector<double> Sorted()
  {
    std::sort(this->Places.begin(), this->Places.end());
    std::vector<double> sorted = { 0.0 };
    for (double place : this->Places)
    {
      if (place - sorted.back() > LeastWidth)
      {
        sorted.push_back(place);
      }
    }
    sorted.back() = 1.0;
    return sorted;
  }

private:
  void Add(double scalar)
  {
    const double place = (scalar - this->First) / this->Width;
    if (place > 0.0 && place < 1.0)
    {
      this->Places.push_back(place);
    }
  }

  void AddBetween(const Node& node, double end, bool isCurved)
  {
    const double midpoint =
      node.X + std::clamp(node.Midpoint, 1.0 - LargestMidpoint, LargestMidpoint) * (end - node.X);
    this->Add(midpoint);
    for (int i = 1; isCurved && i < CutsOfCurve; ++i)
    {
      const double fraction = static_cast<double>(i) / CutsOfCurve;
      this->Add(node.X + fraction * (midpoint - node.X));
      this->Add(midpoint + fraction * (end - midpoint));
    }
  }

  double First;
  double Width;
  std::vector<double> Places;
};

// The values of a line at the ends of a stretch, from those at a quarter and at three quarters of it.
template <class Value>
std::array<Value, 2> EndsOfLine(const Value& quarter, const Value& threeQuarters)
{
  const Value half = threeQuarters - quarter;
  return { quarter - 0.5 * half, threeQuarters + 0.5 * half };
}

std::array<double, 2> EndsOfOpacity(double quarter, double threeQuarters)
{
  std::array<double, 2> ends = EndsOfLine(quarter, threeQuarters);
  for (double& end : ends)
  {
    // the line through two roundings ends beside 0 by one
    end = end > 1.0e-15 ? std::min(end, 1.0) : 0.0;
  }
  return ends;
}

// Samples of both functions, at a quarter and at three quarters of each of `count` pieces.
class Samples
{
public:
  Samples(const TransferFunctions& functions, double begin, double end, int count)
    : Opacities(2 * count)
    , Colors(6 * count)
  {
    const double quarter = (end - begin) / (4.0 * count);
    const double first = Scalar(functions, begin + quarter);
    const double last = Scalar(functions, end - quarter);
    functions.Opacity->GetTable(first, last, 2 * count, this->Opacities.data());
    if (functions.Color->GetScale() == VTK_CTF_LINEAR)
    {
      functions.Color->GetTable(first, last, 2 * count, this->Colors.data());
      return;
    }
    for (int i = 0; i < 2 * count; ++i)
    {
      const double scalar = first + (last - first) * i / (2 * count - 1);
      functions.Color->GetColor(scalar, &this->Colors[3 * i]);
    }
  }

  std::array<double, 2> Opacity(int piece) const
  {
    return EndsOfOpacity(this->Valid(2 * piece), this->Valid(2 * piece + 1));
  }

  std::array<glm::dvec3, 2> Color(int piece) const
  {
    const glm::dvec3 quarter = this->ValidColor(2 * piece);
    const glm::dvec3 threeQuarters = this->ValidColor(2 * piece + 1);
    std::array<glm::dvec3, 2> ends = EndsOfLine(quarter, threeQuarters);
    ends[0] = glm::max(ends[0], glm::min(glm::dvec3(0.0), quarter));
    ends[1] = glm::max(ends[1], glm::min(glm::dvec3(0.0), threeQuarters));
    return ends;
  }

private:
  static double Scalar(const TransferFunctions& functions, double place)
  {
    return functions.Range[0] + place * (functions.Range[1] - functions.Range[0]);
  }

  double Valid(int i) const { return this->Opacities[i] > 0.0 ? std::min(this->Opacities[i], 1.0) : 0.0; }

  glm::dvec3 ValidColor(int i) const
  {
    const auto valid = [this](int component) {
      return std::isfinite(this->Colors[component]) ? this->Colors[component] : 0.0;
    };
    return glm::dvec3(valid(3 * i), valid(3 * i + 1), valid(3 * i + 2));
  }

  std::vector<double> Opacities;
  std::vector<double> Colors;
};

bool IsCurved(vtkColorTransferFunction* color)
{
  const int space = color->GetColorSpace();
  return color->GetScale() != VTK_CTF_LINEAR || (space != VTK_CTF_RGB && space != VTK_CTF_STEP);
}

void CutPieces(
  const TransferFunctions& functions, double begin, double end, std::vector<PlacedStretch>& stretches)
{
  const int count = std::max(LeastPieces, static_cast<int>(std::ceil((end - begin) / LongestPiece)));
  const double width = (end - begin) / count;
  const Samples samples(functions, begin, end, count);
  for (int i = 0; i < count; ++i)
  {
    const std::array<double, 2> opacity = samples.Opacity(i);
    const std::array<glm::dvec3, 2> color = samples.Color(i);
    PlacedStretch stretch;
    static_cast<Stretch&>(stretch) = LinearStretch(width, functions.Attenuation, opacity, color[0], color[1]);
    stretch.begin = begin + i * width;
    stretch.transparentBelow = opacity[0] == 0.0;
    stretch.transparentAbove = opacity[1] == 0.0;
    stretches.push_back(stretch);
  }
}
}

//------------------------------------------------------------------------------
std::vector<PlacedStretch> CutIntoStretches(const TransferFunctions& functions, int parts)
{
  Cuts cuts(functions.Range, parts);
  cuts.AddNodes(NodesOf(functions.Opacity), functions.Opacity->GetUseLogScale());
  cuts.AddNodes(NodesOf(functions.Color), IsCurved(functions.Color));
  const std::vector<double> places = cuts.Sorted();
  std::vector<PlacedStretch> stretches;
  for (std::size_t i = 0; i + 1 < places.size(); ++i)
  {
    CutPieces(functions, places[i], places[i + 1], stretches);
  }
  return stretches;
}
}
