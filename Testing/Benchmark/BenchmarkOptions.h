// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The words after a benchmark's name: options with a number each, and the rest.

#ifndef BenchmarkOptions_h
#define BenchmarkOptions_h

#include <cstdlib>
#include <iostream>
#include <map>
#include <string>
#include <vector>

namespace
{
class BenchmarkOptions
{
public:
  // numbers: the options that there are, and their defaults. Another one, or one without its number, ends the program.
  BenchmarkOptions(int argc, char** argv, const std::map<std::string, double>& numbers)
    : Numbers(numbers)
  {
    for (int i = 1; i < argc; ++i)
    {
      const std::string word = argv[i];
      if (word.rfind("--", 0) != 0)
      {
        this->Words.push_back(word);
        continue;
      }
      const auto number = this->Numbers.find(word);
      char* end = nullptr;
      const double value = i + 1 < argc ? std::strtod(argv[++i], &end) : 0.0;
      if (number == this->Numbers.end() || end == nullptr || *end != '\0')
      {
        this->Refuse(word);
      }
      number->second = value;
    }
  }

  double Real(const std::string& name) const { return this->Numbers.at(name); }
  int Whole(const std::string& name) const { return static_cast<int>(this->Real(name)); }
  const std::vector<std::string>& GetWords() const { return this->Words; }
  std::string GetFile() const { return this->Words.empty() ? std::string() : this->Words[0]; }

private:
  [[noreturn]] void Refuse(const std::string& word) const
  {
    std::cerr << word << " is not an option with a number. There are:";
    for (const auto& [name, value] : this->Numbers)
    {
      std::cerr << " " << name << " " << value;
    }
    std::cerr << "\n";
    std::exit(EXIT_FAILURE);
  }

  std::map<std::string, double> Numbers;
  std::vector<std::string> Words;
};
}

#endif
