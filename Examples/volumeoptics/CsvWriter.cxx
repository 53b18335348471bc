// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CsvWriter.h"

#include "UserError.h"

CsvWriter::CsvWriter(const std::string& path, const std::vector<std::string>& columns)
  : File(path)
{
  if (!this->File)
  {
    throw UserError("'" + path + "' cannot be written. Check that its folder exists and is writable.");
  }
  for (std::size_t i = 0; i < columns.size(); ++i)
  {
    this->File << (i > 0 ? "," : "") << columns[i];
  }
  this->File << "\n";
}

void CsvWriter::Put(const std::string& text)
{
  const bool quoted = text.find_first_of(",\"\n") != std::string::npos;
  if (!quoted)
  {
    this->File << text;
    return;
  }
  this->File << '"';
  for (const char letter : text)
  {
    this->File << letter << (letter == '"' ? "\"" : "");
  }
  this->File << '"';
}
