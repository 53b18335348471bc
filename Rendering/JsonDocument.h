// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Settings in JSON: reading with errors that name the key, the value and what is valid instead.

#ifndef JsonDocument_h
#define JsonDocument_h

#include "vtk_jsoncpp.h"

#include <stdexcept>
#include <string>
#include <vector>

namespace volumeoptics
{
struct JsonError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

// An object; comments are allowed. Throw JsonError.
Json::Value ParseJsonObject(const std::string& text);
Json::Value ReadJsonObject(const char* fileName);

// In lines, with the shortest text of each number that reads back as the same.
std::string FormatJson(const Json::Value& value);
void WriteJsonFile(const char* fileName, const Json::Value& value); // throws JsonError

// A part of a document. Its methods throw JsonError.
class JsonPart
{
public:
  // where: the path to it, for errors; empty for the document.
  JsonPart(const Json::Value& value, std::string where);

  void AllowKeys(const std::vector<std::string>& keys) const;
  bool Has(const char* key) const { return this->Value.isMember(key); }
  JsonPart At(const char* key) const;
  JsonPart At(int index) const;
  int Size() const; // of an array

  // The number of a key, `otherwise` without the key.
  double Number(const char* key, double least, double largest, double otherwise) const;
  // Finite numbers; count: how many there must be.
  std::vector<double> Numbers(const char* key, std::size_t count) const;
  std::vector<double> Numbers(std::size_t count) const;
  void RequireEach(double least, double largest) const; // of an array's numbers

private:
  [[noreturn]] void Refuse(const std::string& what) const;

  const Json::Value& Value;
  std::string Where;
};

Json::Value JsonNumbers(const double* numbers, std::size_t count);
}

#endif
