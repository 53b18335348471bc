// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Progress.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <unistd.h>

namespace
{
bool Quiet = false;

bool InTerminal()
{
  static const bool terminal = isatty(STDERR_FILENO) != 0;
  return terminal;
}

constexpr int BarLength = 28;
}

void Progress::SetQuiet(bool quiet)
{
  Quiet = quiet;
}

void Progress::Say(const std::string& line)
{
  if (!Quiet)
  {
    std::fprintf(stderr, "%s%s\n", InTerminal() ? "\r\033[K" : "", line.c_str());
  }
}

Progress::Progress(const std::string& task)
  : Task(task)
  , Start(std::chrono::steady_clock::now())
{
  if (!Quiet && !InTerminal())
  {
    std::fprintf(stderr, "%s ...\n", task.c_str());
  }
}

Progress::~Progress()
{
  if (std::uncaught_exceptions() > 0)
  {
    return; // the error is told instead
  }
  Say(this->Task + ": " + TimeText(this->Seconds()));
}

void Progress::Update(double fraction, const std::string& detail)
{
  const int percent = static_cast<int>(100.0 * std::clamp(fraction, 0.0, 1.0));
  if (Quiet || !InTerminal() || (percent == this->LastPercent && detail.empty()))
  {
    return;
  }
  this->LastPercent = percent;
  const int filled = percent * BarLength / 100;
  const std::string bar = std::string(filled, '#') + std::string(BarLength - filled, '.');
  std::fprintf(stderr, "\r\033[K%s [%s] %3d %% %s", this->Task.c_str(), bar.c_str(), percent, detail.c_str());
  std::fflush(stderr);
}

void Progress::Line(const std::string& step)
{
  if (!Quiet && !InTerminal())
  {
    std::fprintf(stderr, "  %s (%s)\n", step.c_str(), TimeText(this->Seconds()).c_str());
  }
}

double Progress::Seconds() const
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - this->Start).count();
}

std::string TimeText(double seconds)
{
  char text[32];
  if (seconds < 1.0)
  {
    std::snprintf(text, sizeof(text), "%.0f ms", 1000.0 * seconds);
  }
  else
  {
    std::snprintf(text, sizeof(text), "%.1f s", seconds);
  }
  return text;
}
