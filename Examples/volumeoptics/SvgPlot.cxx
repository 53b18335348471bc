// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SvgPlot.h"

#include "UserError.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>

namespace
{
constexpr double Width = 860.0, Height = 540.0;
constexpr double Left = 80.0, Right = 650.0, Top = 50.0, Bottom = 480.0;
const char* const Colors[] = { "#0b6fb8", "#c8501e", "#2d8a4e", "#8452a8", "#b08800", "#b3356b", "#4a5a66",
  "#1aa3a3" };

// One axis: from data to pixels, and where its ticks are.
struct Axis
{
  bool Logarithmic;
  double Low, High;  // in log10 where logarithmic
  double Begin, End; // pixels

  double Position(double value) const
  {
    const double scaled =
      this->Logarithmic ? (value > 0.0 ? std::max(std::log10(value), this->Low) : this->Low) : value;
    return this->Begin + (scaled - this->Low) / (this->High - this->Low) * (this->End - this->Begin);
  }

  std::vector<double> Ticks() const
  {
    std::vector<double> ticks;
    const double step = this->Logarithmic ? 1.0 : (this->High - this->Low) / 5.0;
    for (double at = this->Low; at <= this->High + 1.0e-9; at += step)
    {
      ticks.push_back(this->Logarithmic ? std::pow(10.0, at) : at);
    }
    return ticks;
  }
};

Axis MakeAxis(const Plot& plot, bool horizontal)
{
  const bool logarithmic = horizontal ? plot.LogarithmicX : plot.LogarithmicY;
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const PlotSeries& series : plot.Series)
  {
    for (const PlotPoint& point : series.Points)
    {
      const double value = horizontal ? point.X : point.Y;
      if (std::isfinite(value) && (value > 0.0 || !logarithmic))
      {
        low = std::min(low, logarithmic ? std::floor(std::log10(value)) : value);
        high = std::max(high, logarithmic ? std::ceil(std::log10(value)) : value);
      }
    }
  }
  low = low > high ? 0.0 : low;
  low = logarithmic ? low : std::min(low, 0.0);
  high = high <= low ? low + 1.0 : high;
  return horizontal ? Axis{ logarithmic, low, high, Left, Right }
                    : Axis{ logarithmic, low, high, Bottom, Top };
}

std::string Escaped(const std::string& text)
{
  std::string escaped;
  for (const char letter : text)
  {
    escaped += letter == '&' ? "&amp;" : letter == '<' ? "&lt;" : std::string(1, letter);
  }
  return escaped;
}

void PutText(std::ostream& svg, double x, double y, const std::string& text, const char* style = "")
{
  svg << "<text x=\"" << x << "\" y=\"" << y << "\" " << style << ">" << Escaped(text) << "</text>\n";
}

void PutAxes(std::ostream& svg, const Plot& plot, const Axis& x, const Axis& y)
{
  char text[32];
  for (const double tick : x.Ticks())
  {
    const double at = x.Position(tick);
    svg << "<path class=\"grid\" d=\"M" << at << " " << Top << "V" << Bottom << "\"/>\n";
    std::snprintf(text, sizeof(text), "%.4g", tick);
    PutText(svg, at, Bottom + 20.0, text, "text-anchor=\"middle\"");
  }
  for (const double tick : y.Ticks())
  {
    const double at = y.Position(tick);
    svg << "<path class=\"grid\" d=\"M" << Left << " " << at << "H" << Right << "\"/>\n";
    std::snprintf(text, sizeof(text), "%.4g", tick);
    PutText(svg, Left - 8.0, at + 4.0, text, "text-anchor=\"end\"");
  }
  PutText(svg, Left, 28.0, plot.Title, "style=\"font-size:17px;font-weight:600\"");
  PutText(svg, (Left + Right) / 2.0, Height - 15.0, plot.XTitle, "text-anchor=\"middle\"");
  svg << "<g transform=\"translate(20," << (Top + Bottom) / 2.0 << ") rotate(-90)\">";
  PutText(svg, 0.0, 0.0, plot.YTitle, "text-anchor=\"middle\"");
  svg << "</g>\n";
}

void PutSeries(std::ostream& svg, std::size_t index, const PlotSeries& series, const Axis& x, const Axis& y)
{
  const char* color = Colors[index % (sizeof(Colors) / sizeof(Colors[0]))];
  svg << "<polyline fill=\"none\" stroke=\"" << color << "\" stroke-width=\"1.5\" points=\"";
  for (const PlotPoint& point : series.Points)
  {
    svg << x.Position(point.X) << "," << y.Position(point.Y) << " ";
  }
  svg << "\"/>\n";
  for (const PlotPoint& point : series.Points)
  {
    svg << "<circle cx=\"" << x.Position(point.X) << "\" cy=\"" << y.Position(point.Y)
        << "\" r=\"3.5\" fill=\"" << color << "\"/>\n";
    PutText(
      svg, x.Position(point.X) + 6.0, y.Position(point.Y) - 5.0, point.Label, "style=\"font-size:10px\"");
  }
  const double row = Top + 10.0 + 22.0 * index;
  svg << "<circle cx=\"" << Right + 25.0 << "\" cy=\"" << row - 4.0 << "\" r=\"4\" fill=\"" << color
      << "\"/>\n";
  PutText(svg, Right + 36.0, row, series.Name);
}
}

void WriteSvg(const std::string& path, const Plot& plot)
{
  std::ofstream svg(path);
  svg << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << Width << " " << Height << "\" width=\""
      << Width << "\" height=\"" << Height << "\">\n<style>text{font:12px sans-serif;fill:#222}"
      << ".grid{stroke:#ddd;stroke-width:1}</style>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
  const Axis x = MakeAxis(plot, true);
  const Axis y = MakeAxis(plot, false);
  PutAxes(svg, plot, x, y);
  for (std::size_t i = 0; i < plot.Series.size(); ++i)
  {
    PutSeries(svg, i, plot.Series[i], x, y);
  }
  svg << "</svg>\n";
  if (!svg)
  {
    throw UserError("'" + path + "' cannot be written. Check that its folder exists and is writable.");
  }
}
