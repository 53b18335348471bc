// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HeaderCheck.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <regex>
#include <sstream>
#include <vector>

namespace
{
namespace fs = std::filesystem;

constexpr std::size_t LongestHeader = 1 << 20;
constexpr std::streamoff LongestEnding = 256;
constexpr int MostFiles = 100000;

std::string Beginning(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  std::string text(LongestHeader, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(file.gcount()));
  return text;
}

std::string Ending(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  const auto size = static_cast<std::streamoff>(fs::file_size(path));
  file.seekg(std::max(size - LongestEnding, std::streamoff(0)));
  return { std::istreambuf_iterator<char>(file), {} };
}

// The numbers of a text; NaN for a word that is none. "none" stands for an axis without a direction.
std::vector<double> NumbersOf(std::string text)
{
  std::replace_if(
    text.begin(), text.end(), [](char c) { return c == '(' || c == ')' || c == ','; }, ' ');
  std::istringstream words(text);
  std::vector<double> numbers;
  for (std::string word; words >> word;)
  {
    char* end = nullptr;
    const double number = std::strtod(word.c_str(), &end);
    const bool isNumber = *end == '\0';
    if (word != "none")
    {
      numbers.push_back(isNumber ? number : std::nan(""));
    }
  }
  return numbers;
}

bool AreFinite(const std::vector<double>& numbers)
{
  return std::all_of(numbers.begin(), numbers.end(), [](double number) { return std::isfinite(number); });
}

using Fields = std::map<std::string, std::string>;

// The fields above the first blank line, and after "LIST" the names of files, one a line.
Fields ReadFields(const std::string& header, std::vector<std::string>& listed)
{
  std::istringstream lines(header);
  Fields fields;
  bool isList = false;
  for (std::string line; std::getline(lines, line);)
  {
    line.erase(line.find_last_not_of(" \r\t") + 1);
    const auto colon = line.find(": ");
    if (isList)
    {
      listed.push_back(line);
    }
    else if (colon != std::string::npos && line[0] != '#')
    {
      const std::string name = line.substr(0, colon);
      fields[name == "datafile" ? "data file" : name] = line.substr(colon + 2);
      isList = (name == "data file" || name == "datafile") && line.substr(colon + 2, 4) == "LIST";
    }
  }
  return fields;
}

// VTK's reader hands the pattern of numbered files to snprintf.
std::string FaultOfPattern(const std::string& description)
{
  std::istringstream words(description);
  std::string pattern;
  long least = 0, most = 0, step = 1;
  words >> pattern >> least >> most >> step;
  static const std::regex numbered("[^%]*%[0-9]{0,2}d[^%]*");
  const bool isRight = std::regex_match(pattern, numbered) && step > 0 && least >= 0 && most >= least &&
    (most - least) / step < MostFiles;
  return isRight ? "" : "its pattern of data files is none of one number, counted up";
}

std::string FaultOfSizes(const Fields& fields)
{
  const auto field = [&](const char* name) {
    const auto found = fields.find(name);
    return found == fields.end() ? std::string() : found->second;
  };
  const auto dimension = NumbersOf(field("dimension"));
  const auto sizes = NumbersOf(field("sizes"));
  const auto isSize = [](double size) { return size >= 1.0 && size <= std::numeric_limits<int>::max(); };
  if (dimension.size() != 1 || !(dimension[0] >= 1.0 && dimension[0] <= 4.0) ||
    static_cast<double>(sizes.size()) != dimension[0] || !std::all_of(sizes.begin(), sizes.end(), isSize))
  {
    return "its sizes are not one to four numbers above 0, as many as its dimension";
  }
  const auto isLength = [&](double length) {
    return (length > 0.0 && std::isfinite(length)) || (sizes.size() == 4 && std::isnan(length)); // no space
  };
  const auto spacings = NumbersOf(field("spacings"));
  return std::all_of(spacings.begin(), spacings.end(), isLength) &&
      AreFinite(NumbersOf(field("space directions"))) && AreFinite(NumbersOf(field("space origin")))
    ? ""
    : "its spacings, space directions or space origin are not finite numbers, spacings above 0";
}

bool IsBeside(const std::string& name)
{
  const fs::path path(name);
  return path.is_relative() && std::find(path.begin(), path.end(), "..") == path.end();
}

// Of files beside the header.
double BytesOf(const std::vector<std::string>& names, const fs::path& folder)
{
  double bytes = 0.0;
  for (const std::string& name : names)
  {
    std::error_code error;
    const auto size = fs::is_regular_file(folder / name, error) ? fs::file_size(folder / name, error) : 0;
    bytes += error ? 0.0 : static_cast<double>(size);
  }
  return bytes;
}
}

std::string FaultOfXml(const std::string& path)
{
  if (Ending(path).find("</VTKFile>") == std::string::npos)
  {
    return "it does not end as such files do"; // with appended data VTK's reader does not notice
  }
  const std::string text = Beginning(path);
  static const std::regex attribute("(Spacing|Origin|Direction)=\"([^\"]*)\"");
  const auto begin = text.find("<ImageData");
  if (begin == std::string::npos)
  {
    return "";
  }
  const std::string element = text.substr(begin, text.find('>', begin) - begin);
  for (std::sregex_iterator found(element.begin(), element.end(), attribute), end; found != end; ++found)
  {
    const std::vector<double> numbers = NumbersOf((*found)[2]);
    if (!AreFinite(numbers) || numbers.size() != ((*found)[1] == "Direction" ? 9 : 3))
    {
      return "its " + (*found)[1].str() + " are not " + ((*found)[1] == "Direction" ? "9" : "3") +
        " finite numbers";
    }
  }
  return "";
}

std::string FaultOfNrrd(const std::string& path, double& bytes)
{
  const std::string text = Beginning(path);
  const auto end = std::min(text.find("\n\n"), text.find("\n\r\n"));
  std::vector<std::string> files;
  const Fields fields = ReadFields(text.substr(0, end), files);
  const auto dataFile = fields.find("data file");
  const bool isDetached = dataFile != fields.end();
  // VTK's reader has no end, either, where the last line has none
  const bool isEnded = end != std::string::npos || (isDetached && !text.empty() && text.back() == '\n');
  if (!isEnded || text.substr(0, end).find('\0') != std::string::npos)
  {
    return "its header does not end";
  }
  const bool isPattern = isDetached && dataFile->second.find('%') != std::string::npos;
  const std::string fault = isPattern ? FaultOfPattern(dataFile->second) : "";
  const bool isList = isDetached && dataFile->second.substr(0, 4) == "LIST";
  if (isDetached && !isPattern && !isList)
  {
    files.push_back(dataFile->second);
  }
  if (!std::all_of(files.begin(), files.end(), IsBeside) || (isPattern && !IsBeside(dataFile->second)))
  {
    return "its data files are not in its folder";
  }
  const auto encoding = fields.find("encoding");
  const bool isRaw = encoding != fields.end() && encoding->second == "raw" && !isPattern;
  bytes = !isRaw ? std::numeric_limits<double>::infinity()
    : isDetached
    ? BytesOf(files, fs::path(path).parent_path())
    : static_cast<double>(fs::file_size(path)) - static_cast<double>(end + (text[end + 1] == '\r' ? 3 : 2));
  return fault.empty() ? FaultOfSizes(fields) : fault;
}
