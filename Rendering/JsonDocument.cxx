// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "JsonDocument.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>

namespace volumeoptics
{
namespace
{
// Values in messages are cut here.
const std::size_t LongestText = 60;

std::string InOneLine(const Json::Value& value)
{
  Json::StreamWriterBuilder builder;
  builder["indentation"] = "";
  return Json::writeString(builder, value);
}

std::string Text(const Json::Value& value)
{
  const std::string text = InOneLine(value);
  return text.size() <= LongestText ? text : text.substr(0, LongestText) + "...";
}

// The shortest text that reads back as the same number.
std::string ShortestText(double number)
{
  char text[32];
  return std::string(text, std::to_chars(text, text + sizeof text, number).ptr);
}

void Write(std::ostream& stream, const Json::Value& value, const std::string& indentation);

// Elements in lines of their own, or, of arrays of numbers, in one.
void WriteElements(std::ostream& stream, const Json::Value& value, const std::string& indentation)
{
  const bool isLine = value.isArray() &&
    std::all_of(value.begin(), value.end(), [](const Json::Value& element) { return element.isNumeric(); });
  const std::string next = indentation + "  ";
  for (auto element = value.begin(); element != value.end(); ++element)
  {
    stream << (element == value.begin() ? ""
                  : isLine              ? ", "
                                        : ",")
           << (isLine ? "" : "\n" + next)
           << (value.isObject() ? Json::valueToQuotedString(element.name().c_str()) + ": " : "");
    Write(stream, *element, next);
  }
  stream << (isLine || value.empty() ? "" : "\n" + indentation);
}

void Write(std::ostream& stream, const Json::Value& value, const std::string& indentation)
{
  if (value.isObject() || value.isArray())
  {
    stream << (value.isObject() ? "{" : "[");
    WriteElements(stream, value, indentation);
    stream << (value.isObject() ? "}" : "]");
  }
  else
  {
    stream << (value.isDouble() ? ShortestText(value.asDouble()) : InOneLine(value));
  }
}

std::string Text(double number)
{
  std::ostringstream text;
  text << number;
  return text.str();
}
}

Json::Value ParseJsonObject(const std::string& text)
{
  std::istringstream stream(text);
  Json::Value object;
  std::string errors;
  try
  {
    if (Json::parseFromStream(Json::CharReaderBuilder(), stream, &object, &errors) && object.isObject())
    {
      return object;
    }
  }
  catch (const Json::Exception& error) // nested too deeply
  {
    errors = error.what();
  }
  throw JsonError("it is not a JSON object" + (errors.empty() ? "." : ": " + errors));
}

Json::Value ReadJsonObject(const char* fileName)
{
  std::ifstream file(fileName ? fileName : "");
  if (!file)
  {
    throw JsonError("it cannot be opened. Check the path.");
  }
  return ParseJsonObject(std::string(std::istreambuf_iterator<char>(file), {}));
}

std::string FormatJson(const Json::Value& value)
{
  std::ostringstream text;
  Write(text, value, "");
  return text.str() + "\n";
}

void WriteJsonFile(const char* fileName, const Json::Value& value)
{
  std::ofstream file(fileName ? fileName : "");
  file << FormatJson(value) << std::flush;
  if (!file)
  {
    throw JsonError("it cannot be written. Check that its folder exists and is writable.");
  }
}

JsonPart::JsonPart(const Json::Value& value, std::string where)
  : Value(value)
  , Where(std::move(where))
{
}

void JsonPart::Refuse(const std::string& what) const
{
  throw JsonError((this->Where.empty() ? "the document" : this->Where) + " is " + Text(this->Value) +
    "; it must be " + what + ".");
}

void JsonPart::AllowKeys(const std::vector<std::string>& keys) const
{
  if (!this->Value.isObject())
  {
    this->Refuse("an object");
  }
  for (const std::string& key : this->Value.getMemberNames())
  {
    if (std::find(keys.begin(), keys.end(), key) == keys.end())
    {
      std::string names;
      std::for_each(keys.begin(), keys.end(),
        [&](const std::string& name) { names += (names.empty() ? "" : ", ") + name; });
      throw JsonError((this->Where.empty() ? "the document" : this->Where) + " has the unknown key " + key +
        "; its keys are " + names + ".");
    }
  }
}

JsonPart JsonPart::At(const char* key) const
{
  if (!this->Has(key))
  {
    throw JsonError((this->Where.empty() ? "the document" : this->Where) + " has no " + key + "; add it.");
  }
  return { this->Value[key], this->Where.empty() ? key : this->Where + "." + key };
}

JsonPart JsonPart::At(int index) const
{
  return { this->Value[index], this->Where + "[" + std::to_string(index) + "]" };
}

int JsonPart::Size() const
{
  if (!this->Value.isArray())
  {
    this->Refuse("an array");
  }
  return static_cast<int>(this->Value.size());
}

double JsonPart::Number(const char* key, double least, double largest, double otherwise) const
{
  if (!this->Has(key))
  {
    return otherwise;
  }
  const JsonPart part = this->At(key);
  if (!part.Value.isNumeric() || !(part.Value.asDouble() >= least && part.Value.asDouble() <= largest))
  {
    part.Refuse("a number in [" + Text(least) + ", " + Text(largest) + "]");
  }
  return part.Value.asDouble();
}

std::vector<double> JsonPart::Numbers(const char* key, std::size_t count) const
{
  return this->At(key).Numbers(count);
}

std::vector<double> JsonPart::Numbers(std::size_t count) const
{
  std::vector<double> numbers;
  if (this->Value.isArray())
  {
    for (const Json::Value& number : this->Value)
    {
      numbers.push_back(number.isNumeric() ? number.asDouble() : std::nan(""));
    }
  }
  const bool areFinite =
    std::all_of(numbers.begin(), numbers.end(), [](double number) { return std::isfinite(number); });
  if (numbers.size() != count || !areFinite || !this->Value.isArray())
  {
    this->Refuse("an array of " + std::to_string(count) + " finite numbers");
  }
  return numbers;
}

void JsonPart::RequireEach(double least, double largest) const
{
  for (const Json::Value& number : this->Value)
  {
    if (!number.isNumeric() || !(number.asDouble() >= least && number.asDouble() <= largest))
    {
      this->Refuse("numbers in [" + Text(least) + ", " + Text(largest) + "]");
    }
  }
}

Json::Value JsonNumbers(const double* numbers, std::size_t count)
{
  Json::Value array(Json::arrayValue);
  for (std::size_t i = 0; i < count; ++i)
  {
    array.append(numbers[i]);
  }
  return array;
}
}
