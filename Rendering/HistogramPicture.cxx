// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HistogramPicture.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace volumeoptics
{
namespace
{
using Color = std::array<double, 3>;

// From black through blue to white, so that faint lines show.
const Color Background = { 0.04, 0.05, 0.08 };
const Color Middle = { 0.25, 0.5, 0.85 };
const Color Brightest = { 1.0, 1.0, 1.0 };
const Color EqualOpacity = { 1.0, 0.45, 0.1 };
// Lines this share of the range from the vertical link equal opacities anyway.
const double TrivialWidth = 0.03;
// Exponent of the logarithm's intensity: keeps thinly filled areas dark beside bundles.
const double Contrast = 1.4;
// Lines are summed up in this many bins an axis at most.
const int LargestLineBins = 256;

struct Line
{
  double Bottom; // positions in [0, 1]
  double Top;
  double Count;
  bool LinksEqual;
};

double OpacityAt(vtkPiecewiseFunction* opacity, double scalar)
{
  return opacity->GetSize() > 0 ? opacity->GetValue(scalar) : 0.0;
}

Color Mixed(const Color& a, const Color& b, double share)
{
  Color color;
  std::transform(
    a.begin(), a.end(), b.begin(), color.begin(), [=](double x, double y) { return x + share * (y - x); });
  return color;
}

// marked: share of the density that is marked.
Color Tone(double intensity, double marked)
{
  const Color plain = intensity < 0.5 ? Mixed(Background, Middle, 2.0 * intensity)
                                      : Mixed(Middle, Brightest, 2.0 * intensity - 1.0);
  const Color mark = Mixed(Background, EqualOpacity, std::sqrt(intensity));
  return Mixed(plain, mark, marked);
}

// Relative to the largest, after the logarithm.
double Intensity(double density, double largest, bool logScale)
{
  if (!(largest > 0.0))
  {
    return 0.0;
  }
  return logScale ? std::pow(std::log1p(density) / std::log1p(largest), Contrast) : density / largest;
}

// Neighbouring bins as one.
std::vector<Line> Lines(vtkImageData* histogram, const HistogramPictureSettings& settings)
{
  const int* dimensions = histogram->GetDimensions();
  vtkDataArray* counts = histogram->GetPointData()->GetScalars();
  const int factor = (std::max(dimensions[0], dimensions[1]) + LargestLineBins - 1) / LargestLineBins;
  const int columns = (dimensions[0] + factor - 1) / factor;
  const int rows = (dimensions[1] + factor - 1) / factor;
  std::vector<double> sums(static_cast<std::size_t>(columns) * rows);
  for (vtkIdType i = 0; i < counts->GetNumberOfTuples(); ++i)
  {
    const vtkIdType column = i % dimensions[0] / factor;
    const vtkIdType row = i / dimensions[0] / factor;
    const double count = counts->GetComponent(i, 0);
    sums[column + columns * row] += count > 0.0 && std::isfinite(count) ? count : 0.0;
  }
  std::vector<double> opacities;
  for (int i = 0; settings.Opacity && i < std::max(columns, rows); ++i)
  {
    const double bin = (i + 0.5) * factor - 0.5;
    opacities.push_back(
      OpacityAt(settings.Opacity, histogram->GetOrigin()[0] + bin * histogram->GetSpacing()[0]));
  }
  std::vector<Line> lines;
  for (int row = 0; row < rows; ++row)
  {
    for (int column = 0; column < columns; ++column)
    {
      if (sums[column + columns * row] > 0.0)
      {
        const bool isSlanted = std::abs(column - row) > TrivialWidth * columns;
        const bool isEqual = settings.Opacity && isSlanted &&
          std::abs(opacities[column] - opacities[row]) <= settings.OpacityTolerance;
        lines.push_back(
          { (column + 0.5) / columns, (row + 0.5) / rows, sums[column + columns * row], isEqual });
      }
    }
  }
  return lines;
}

struct Densities
{
  std::vector<double> All;
  std::vector<double> Marked;
};

Densities Rasterize(const std::vector<Line>& lines, int width, int height)
{
  Densities densities;
  densities.All.resize(static_cast<std::size_t>(width) * height);
  densities.Marked.resize(densities.All.size());
  vtkSMPTools::For(0, height, [&](vtkIdType first, vtkIdType last) {
    for (vtkIdType y = first; y < last; ++y)
    {
      const double t = height > 1 ? y / (height - 1.0) : 0.5;
      for (const Line& line : lines)
      {
        // shared by the two pixels whose centres it passes between
        const double x = std::max((line.Bottom + t * (line.Top - line.Bottom)) * width - 0.5, 0.0);
        const int pixel = std::min(static_cast<int>(x), width - 1);
        const int next = std::min(pixel + 1, width - 1);
        const double share = std::min(x - pixel, 1.0);
        std::vector<double>* const targets[] = { &densities.All,
          line.LinksEqual ? &densities.Marked : nullptr };
        for (std::vector<double>* target : targets)
        {
          if (target)
          {
            (*target)[y * width + pixel] += (1.0 - share) * line.Count;
            (*target)[y * width + next] += share * line.Count;
          }
        }
      }
    }
  });
  return densities;
}

void SetPixel(vtkImageData* picture, vtkIdType pixel, const Color& color)
{
  auto* bytes = static_cast<unsigned char*>(picture->GetScalarPointer()) + 3 * pixel;
  std::transform(color.begin(), color.end(), bytes, [](double value) {
    return static_cast<unsigned char>(std::lround(255.0 * std::clamp(value, 0.0, 1.0)));
  });
}

vtkSmartPointer<vtkImageData> NewPicture(int width, int height)
{
  auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->SetDimensions(width, height, 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  return picture;
}

bool HasCounts(vtkImageData* histogram)
{
  return histogram && histogram->GetPointData()->GetScalars() &&
    histogram->GetPointData()->GetScalars()->GetNumberOfTuples() > 0;
}
}

vtkSmartPointer<vtkImageData> LineHistogramPicture(
  vtkImageData* histogram, int width, int height, const HistogramPictureSettings& settings)
{
  auto picture = NewPicture(width, height);
  Densities densities;
  densities.All.resize(static_cast<std::size_t>(width) * height);
  densities.Marked.resize(densities.All.size());
  if (HasCounts(histogram))
  {
    densities = Rasterize(Lines(histogram, settings), width, height);
  }
  const double largest = *std::max_element(densities.All.begin(), densities.All.end());
  for (std::size_t i = 0; i < densities.All.size(); ++i)
  {
    const double density = densities.All[i];
    const double marked = density > 0.0 ? densities.Marked[i] / density : 0.0;
    SetPixel(picture, i, Tone(Intensity(density, largest, settings.LogScale), marked));
  }
  return picture;
}

vtkSmartPointer<vtkImageData> Transposed(vtkImageData* picture)
{
  const int* dimensions = picture->GetDimensions();
  auto transposed = NewPicture(dimensions[1], dimensions[0]);
  for (int y = 0; y < dimensions[1]; ++y)
  {
    for (int x = 0; x < dimensions[0]; ++x)
    {
      const auto* from = static_cast<const unsigned char*>(picture->GetScalarPointer(x, y, 0));
      std::copy(from, from + 3,
        static_cast<unsigned char*>(transposed->GetScalarPointer(dimensions[1] - 1 - y, x, 0)));
    }
  }
  return transposed;
}

vtkSmartPointer<vtkImageData> HistogramPicture(vtkImageData* histogram, int width, int height, bool logScale)
{
  const int* dimensions = histogram ? histogram->GetDimensions() : nullptr;
  const int columns = HasCounts(histogram) ? std::min(width, dimensions[0]) : 1;
  const int rows = HasCounts(histogram) ? std::min(height, dimensions[1]) : 1;
  std::vector<double> sums(static_cast<std::size_t>(columns) * rows);
  for (vtkIdType i = 0; HasCounts(histogram) && i < histogram->GetNumberOfPoints(); ++i)
  {
    const vtkIdType column = i % dimensions[0] * columns / dimensions[0];
    const vtkIdType row = i / dimensions[0] * rows / dimensions[1];
    sums[column + columns * row] += histogram->GetPointData()->GetScalars()->GetComponent(i, 0);
  }
  auto picture = NewPicture(columns, rows);
  const double largest = *std::max_element(sums.begin(), sums.end());
  for (std::size_t i = 0; i < sums.size(); ++i)
  {
    SetPixel(picture, i, Tone(Intensity(sums[i], largest, logScale), 0.0));
  }
  return picture;
}
}
