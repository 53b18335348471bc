// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkAnalyticLineSource.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkAnalyticLineSource);

namespace
{
const double Turn = 6.283185307179586;
const double GoldenRatio = 0.6180339887498949; // its multiples fill [0, 1) evenly

double Fraction(double x)
{
  return x - std::floor(x);
}

// One spiral around one axis, at s in [0, 1].
class Spiral
{
public:
  Spiral(vtkIdType line, int axes)
    : Axis(static_cast<int>(line % axes))
    , Angle(Turn * this->Axis / axes)
    , Phase(Fraction(Number(line, axes) * GoldenRatio))
    , Distance(0.3 + 0.7 * std::sqrt(Fraction(Number(line, axes) * GoldenRatio * GoldenRatio + 0.5)))
  {
  }

  int GetAxis() const { return this->Axis; }

  glm::dvec3 At(double s) const
  {
    // the axes rise side by side and lean over, each to its own direction
    const glm::dvec3 outward(std::cos(this->Angle), std::sin(this->Angle), 0.0);
    const glm::dvec3 around(-outward.y, outward.x, 0.0);
    const glm::dvec3 center =
      outward * (0.3 + 0.3 * s * s) + around * 0.25 * s + glm::dvec3(0.0, 0.0, 1.6 * s - 0.8);
    const double radius = this->Distance * (0.05 + 0.2 * s);
    const double turn = Turn * (this->Phase + 6.0 * s);
    return center +
      radius *
      (std::cos(turn) * outward + std::sin(turn) * glm::normalize(around + glm::dvec3(0.0, 0.0, 0.4)));
  }

private:
  // of the line among those of its axis
  static double Number(vtkIdType line, int axes)
  {
    const vtkIdType number = line / axes;
    return static_cast<double>(number);
  }

  int Axis;
  double Angle, Phase, Distance;
};

// Lines of so many points one after the other, the last one of what is left.
vtkSmartPointer<vtkCellArray> MakeCells(vtkIdType lines, vtkIdType pointsOfLine, vtkIdType points)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (vtkIdType line = 0; line < lines; ++line)
  {
    const vtkIdType begin = line * pointsOfLine, end = std::min(begin + pointsOfLine, points);
    cells->InsertNextCell(static_cast<int>(end - begin));
    for (vtkIdType point = begin; point < end; ++point)
    {
      cells->InsertCellPoint(point);
    }
  }
  return cells;
}
}

//------------------------------------------------------------------------------
int vtkAnalyticLineSource::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  outputs->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkAnalyticLineSource::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkInformation* info = outputs->GetInformationObject(0);
  const int pieces = std::max(info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES()), 1);
  const int piece = info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER());
  const vtkIdType lines = (this->NumberOfSegments + this->SegmentsPerLine - 1) / this->SegmentsPerLine;
  const vtkIdType first = lines * piece / pieces, last = lines * (piece + 1) / pieces;
  const vtkIdType segmentsBefore = first * this->SegmentsPerLine;
  const vtkIdType segments = std::min(last * this->SegmentsPerLine, this->NumberOfSegments) - segmentsBefore;

  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(first < last ? segments + last - first : 0);
  vtkNew<vtkFloatArray> progress;
  progress->SetName("Progress");
  progress->SetNumberOfValues(points->GetNumberOfPoints());
  vtkNew<vtkUnsignedCharArray> types;
  types->SetName("LineType");
  types->SetNumberOfValues(last - first);
  const auto cells = MakeCells(last - first, this->SegmentsPerLine + 1, points->GetNumberOfPoints());
  vtkSMPTools::For(first, last, [&](vtkIdType from, vtkIdType to) {
    for (vtkIdType line = from; line < to; ++line)
    {
      const Spiral spiral(line, this->NumberOfAxes);
      const vtkIdType begin = (line - first) * (this->SegmentsPerLine + 1);
      const vtkIdType end = std::min(begin + this->SegmentsPerLine + 1, points->GetNumberOfPoints());
      types->SetValue(line - first, static_cast<unsigned char>(spiral.GetAxis() % 2));
      for (vtkIdType point = begin; point < end; ++point)
      {
        const double s = static_cast<double>(point - begin) / this->SegmentsPerLine;
        const glm::dvec3 position = spiral.At(s);
        points->SetPoint(point, &position.x);
        progress->SetValue(point, static_cast<float>(s));
      }
    }
  });
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  output->SetPoints(points);
  output->SetLines(cells);
  output->GetPointData()->AddArray(progress);
  output->GetCellData()->AddArray(types);
  return 1;
}

//------------------------------------------------------------------------------
void vtkAnalyticLineSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfSegments: " << this->NumberOfSegments << "\n";
  os << indent << "SegmentsPerLine: " << this->SegmentsPerLine << "\n";
  os << indent << "NumberOfAxes: " << this->NumberOfAxes << "\n";
}
