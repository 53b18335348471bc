// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "InvesaliusProject.h"

#include "ReadingGuard.h"
#include "UserError.h"

#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUtilities.h>

#include <archive.h>
#include <archive_entry.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <map>
#include <memory>
#include <sstream>
#include <vector>

namespace
{
namespace fs = std::filesystem;

constexpr std::size_t PieceBytes = 1 << 24;

using Bytes = std::vector<char>;
using Archive = std::unique_ptr<archive, int (*)(archive*)>;

UserError Damaged(const std::string& path, const std::string& what)
{
  return UserError("'" + path + "' is not a complete InVesalius project (" + what +
    "). Install the package invesalius-examples again, or save the project again.");
}

std::string Reason(archive* file)
{
  const char* text = archive_error_string(file);
  return text ? text : "its archive is broken";
}

// Refuses what has no place in a project, whether it is read or not: nothing is ever written to disk, but
// such an archive was not made by InVesalius.
void CheckEntry(archive_entry* entry, double bytesBefore, const std::string& path)
{
  const char* name = archive_entry_pathname(entry);
  const std::string full = name ? name : "";
  const int kind = archive_entry_filetype(entry);
  const bool isPlain = (kind == AE_IFREG || kind == AE_IFDIR) && !archive_entry_hardlink(entry);
  const auto parts = fs::path(full);
  if (full.empty() || parts.is_absolute() || std::find(parts.begin(), parts.end(), "..") != parts.end() ||
    !isPlain)
  {
    throw Damaged(path, "'" + full + "' is a link or leaves the project's folder");
  }
  const double size = static_cast<double>(archive_entry_size(entry));
  if (size < 0.0 || bytesBefore + size > MostBytes())
  {
    throw Damaged(path,
      "its files unpack to more than " + std::to_string(static_cast<long long>(MostBytes())) +
        " bytes, half of the memory");
  }
}

// In pieces: the entry may be shorter than it says.
Bytes ReadEntry(archive* file, archive_entry* entry, const std::string& path)
{
  const auto size = static_cast<std::size_t>(archive_entry_size(entry));
  Bytes bytes;
  la_ssize_t count = 1;
  while (bytes.size() < size && count > 0)
  {
    const std::size_t before = bytes.size();
    bytes.resize(before + std::min(size - before, PieceBytes));
    count = archive_read_data(file, bytes.data() + before, bytes.size() - before);
    bytes.resize(before + static_cast<std::size_t>(std::max<la_ssize_t>(count, 0)));
  }
  if (bytes.size() != size)
  {
    throw Damaged(path, std::string(archive_entry_pathname(entry)) + " is cut off");
  }
  return bytes;
}

// File name, without folder -> contents, of the two kinds of entry that matter.
std::map<std::string, Bytes> ReadEntries(const std::string& path)
{
  const Archive file(archive_read_new(), archive_read_free);
  archive_read_support_filter_gzip(file.get());
  archive_read_support_format_tar(file.get());
  if (archive_read_open_filename(file.get(), path.c_str(), 1 << 16) != ARCHIVE_OK)
  {
    throw Damaged(path, Reason(file.get()));
  }
  std::map<std::string, Bytes> entries;
  archive_entry* entry = nullptr;
  int status = ARCHIVE_OK;
  double bytesBefore = 0.0;
  while ((status = archive_read_next_header(file.get(), &entry)) == ARCHIVE_OK)
  {
    CheckEntry(entry, bytesBefore, path);
    bytesBefore += static_cast<double>(archive_entry_size(entry));
    const std::string name = fs::path(archive_entry_pathname(entry)).filename().string();
    if (name == "main.plist" || name == "matrix.dat")
    {
      entries[name] = ReadEntry(file.get(), entry, path);
    }
  }
  if (status != ARCHIVE_EOF || entries.size() != 2)
  {
    throw Damaged(path, status == ARCHIVE_EOF ? "main.plist or matrix.dat is missing" : Reason(file.get()));
  }
  return entries;
}

// The element that follows <key>name</key> in a dictionary of a property list.
vtkXMLDataElement* ValueOf(vtkXMLDataElement* dictionary, const char* name)
{
  for (int i = 0; dictionary && i + 1 < dictionary->GetNumberOfNestedElements(); ++i)
  {
    vtkXMLDataElement* key = dictionary->GetNestedElement(i);
    if (std::strcmp(key->GetName(), "key") == 0 && key->GetCharacterData() &&
      std::strcmp(key->GetCharacterData(), name) == 0)
    {
      return dictionary->GetNestedElement(i + 1);
    }
  }
  return nullptr;
}

std::vector<double> Numbers(vtkXMLDataElement* array)
{
  std::vector<double> numbers;
  for (int i = 0; array && i < array->GetNumberOfNestedElements(); ++i)
  {
    const char* characters = array->GetNestedElement(i)->GetCharacterData();
    std::istringstream text(characters ? characters : "");
    double number = 0.0;
    text >> number;
    numbers.push_back(number);
  }
  return numbers;
}
}

vtkSmartPointer<vtkImageData> ReadInvesaliusProject(const std::string& path)
{
  const ReadingGuard guard(path);
  const auto entries = ReadEntries(path);
  const Bytes& list = entries.at("main.plist");
  const Bytes& matrix = entries.at("matrix.dat");

  const std::string text(list.begin(), list.end());
  const auto root =
    vtkSmartPointer<vtkXMLDataElement>::Take(vtkXMLUtilities::ReadElementFromString(text.c_str()));
  vtkXMLDataElement* dictionary = root ? root->FindNestedElementWithName("dict") : nullptr;
  const auto shape = Numbers(ValueOf(ValueOf(dictionary, "matrix"), "shape")); // z, y, x
  const auto spacing = Numbers(ValueOf(dictionary, "spacing"));                // x, y, z
  const auto isLength = [](double length) {
    return length >= 1.0 && length <= VTK_INT_MAX && length == std::floor(length);
  };
  if (shape.size() != 3 || spacing.size() != 3 || !std::all_of(shape.begin(), shape.end(), isLength) ||
    2.0 * shape[0] * shape[1] * shape[2] != static_cast<double>(matrix.size()))
  {
    throw Damaged(path, "shape, spacing and matrix.dat disagree");
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(static_cast<int>(shape[2]), static_cast<int>(shape[1]), static_cast<int>(shape[0]));
  image->SetSpacing(spacing.data());
  RequireGrid(path, image->GetExtent(), sizeof(short), image->GetSpacing(), image->GetOrigin(), nullptr);
  image->AllocateScalars(VTK_SHORT, 1);
  std::memcpy(image->GetScalarPointer(), matrix.data(), matrix.size());
  return image;
}
