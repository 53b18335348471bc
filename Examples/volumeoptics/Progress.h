// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Progress on stderr: a bar in a terminal, one line a task elsewhere.

#ifndef Progress_h
#define Progress_h

#include <chrono>
#include <string>

class Progress
{
public:
  static void SetQuiet(bool quiet);
  // A line of information, unless quiet.
  static void Say(const std::string& line);

  explicit Progress(const std::string& task);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // fraction in [0, 1]; detail is shown behind the bar.
  void Update(double fraction, const std::string& detail = "");
  // A step that is done: a line of its own where there is no terminal.
  void Line(const std::string& step);
  double Seconds() const;

private:
  std::string Task;
  std::chrono::steady_clock::time_point Start;
  int LastPercent = -1;
};

// "12.3 s" or "45 ms".
std::string TimeText(double seconds);

#endif
