// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// A small plot in SVG: series of points on logarithmic axes, joined and labelled.

#ifndef SvgPlot_h
#define SvgPlot_h

#include <string>
#include <vector>

struct PlotPoint
{
  double X, Y;
  std::string Label;
};

struct PlotSeries
{
  std::string Name;
  std::vector<PlotPoint> Points;
};

struct Plot
{
  std::string Title, XTitle, YTitle;
  std::vector<PlotSeries> Series;
  bool LogarithmicX = true;
  bool LogarithmicY = true;
};

// Points that a logarithmic axis cannot show are put on its lower end. Throws UserError.
void WriteSvg(const std::string& path, const Plot& plot);

#endif
