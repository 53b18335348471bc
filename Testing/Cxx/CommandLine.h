// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Options of a test that is run by hand, too.

#ifndef CommandLine_h
#define CommandLine_h

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

namespace
{
class CommandLine
{
public:
  CommandLine(int argc, char* argv[])
    : Words(argv, argv + argc)
  {
  }

  bool Has(const std::string& option) const
  {
    return std::find(this->Words.begin(), this->Words.end(), option) != this->Words.end();
  }

  // The place-th word behind an option, as a number.
  int GetNumber(const std::string& option, int place, int otherwise) const
  {
    const auto found = std::find(this->Words.begin(), this->Words.end(), option);
    return std::distance(found, this->Words.end()) > place + 1 ? std::atoi((found + place + 1)->c_str())
                                                               : otherwise;
  }

private:
  std::vector<std::string> Words;
};
}

#endif
