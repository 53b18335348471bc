// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Checks for unit tests: a failure prints its numbers (the first hundred do), the test goes on, and
// ExitCode() tells.

#ifndef Check_h
#define Check_h

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <string>

namespace
{
class Check
{
public:
  // |value - expected| <= tolerance; a NaN fails.
  bool Near(const std::string& what, double value, double expected, double tolerance)
  {
    const bool ok = std::abs(value - expected) <= tolerance;
    return this->Report(ok, what, value, "expected", expected, tolerance);
  }

  bool AtMost(const std::string& what, double value, double bound)
  {
    return this->Report(value <= bound, what, value, "at most", bound, 0.0);
  }

  bool AtLeast(const std::string& what, double value, double bound)
  {
    return this->Report(value >= bound, what, value, "at least", bound, 0.0);
  }

  bool Finite(const std::string& what, double value)
  {
    return this->Report(std::isfinite(value), what, value, "finite, not", value, 0.0);
  }

  // what: the whole story, for what is no number
  bool That(bool holds, const std::string& what)
  {
    if (!holds && ++this->Failures <= 100)
    {
      std::cout << "FAILED " << what << std::endl;
    }
    return holds;
  }

  int ExitCode() const { return this->Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE; }

private:
  bool Report(
    bool ok, const std::string& what, double value, const char* relation, double reference, double tolerance)
  {
    if (!ok && ++this->Failures <= 100)
    {
      std::cout.precision(std::numeric_limits<double>::max_digits10);
      std::cout << "FAILED " << what << ": " << value << ", " << relation << ' ' << reference;
      if (tolerance > 0.0)
      {
        std::cout << " +- " << tolerance << " (off by " << value - reference << ')';
      }
      std::cout << std::endl;
    }
    return ok;
  }

  int Failures = 0;
};

// Exact arithmetic would give equality: a few dozen roundings of a double of order 1.
constexpr double Rounding = 1e-14;
}

#endif
