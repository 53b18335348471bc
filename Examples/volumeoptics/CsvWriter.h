// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Comma-separated values: text is quoted, numbers keep six digits.

#ifndef CsvWriter_h
#define CsvWriter_h

#include <fstream>
#include <string>
#include <vector>

class CsvWriter
{
public:
  CsvWriter(const std::string& path, const std::vector<std::string>& columns); // throws UserError

  template <class... Values>
  void Write(const Values&... values)
  {
    std::size_t column = 0;
    ((this->Separate(column++), this->Put(values)), ...);
    this->File << "\n" << std::flush;
  }

private:
  void Separate(std::size_t column) { this->File << (column > 0 ? "," : ""); }
  void Put(const std::string& text);
  void Put(const char* text) { this->Put(std::string(text)); }
  void Put(double number) { this->File << number; }

  std::ofstream File;
};

#endif
