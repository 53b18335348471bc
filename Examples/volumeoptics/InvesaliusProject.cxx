// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "InvesaliusProject.h"

#include "UserError.h"

#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUtilities.h>

#include <archive.h>
#include <archive_entry.h>

#include <cstring>
#include <map>
#include <memory>
#include <sstream>
#include <vector>

namespace
{
using Bytes = std::vector<char>;
using Archive = std::unique_ptr<archive, int (*)(archive*)>;

UserError Damaged(const std::string& path, const std::string& what)
{
  return UserError("'" + path + "' is not a complete InVesalius project (" + what +
    "). Install the package invesalius-examples again, or save the project again.");
}

Bytes ReadEntry(archive* file, archive_entry* entry, const std::string& path)
{
  Bytes bytes(archive_entry_size(entry));
  const la_ssize_t count = archive_read_data(file, bytes.data(), bytes.size());
  if (count != static_cast<la_ssize_t>(bytes.size()))
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
    throw Damaged(path, archive_error_string(file.get()));
  }
  std::map<std::string, Bytes> entries;
  archive_entry* entry = nullptr;
  int status = ARCHIVE_OK;
  while ((status = archive_read_next_header(file.get(), &entry)) == ARCHIVE_OK)
  {
    const std::string full = archive_entry_pathname(entry);
    const std::string name = full.substr(full.find_last_of('/') + 1);
    if (name == "main.plist" || name == "matrix.dat")
    {
      entries[name] = ReadEntry(file.get(), entry, path);
    }
  }
  if (status != ARCHIVE_EOF || entries.size() != 2)
  {
    throw Damaged(
      path, status == ARCHIVE_EOF ? "main.plist or matrix.dat is missing" : archive_error_string(file.get()));
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
    std::istringstream text(array->GetNestedElement(i)->GetCharacterData());
    double number = 0.0;
    text >> number;
    numbers.push_back(number);
  }
  return numbers;
}
}

vtkSmartPointer<vtkImageData> ReadInvesaliusProject(const std::string& path)
{
  const auto entries = ReadEntries(path);
  const Bytes& list = entries.at("main.plist");
  const Bytes& matrix = entries.at("matrix.dat");

  const std::string text(list.begin(), list.end());
  const auto root =
    vtkSmartPointer<vtkXMLDataElement>::Take(vtkXMLUtilities::ReadElementFromString(text.c_str()));
  vtkXMLDataElement* dictionary = root ? root->FindNestedElementWithName("dict") : nullptr;
  const auto shape = Numbers(ValueOf(ValueOf(dictionary, "matrix"), "shape")); // z, y, x
  const auto spacing = Numbers(ValueOf(dictionary, "spacing"));                // x, y, z
  if (shape.size() != 3 || spacing.size() != 3 ||
    2.0 * shape[0] * shape[1] * shape[2] != static_cast<double>(matrix.size()))
  {
    throw Damaged(path, "shape, spacing and matrix.dat disagree");
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(static_cast<int>(shape[2]), static_cast<int>(shape[1]), static_cast<int>(shape[0]));
  image->SetSpacing(spacing.data());
  image->AllocateScalars(VTK_SHORT, 1);
  std::memcpy(image->GetScalarPointer(), matrix.data(), matrix.size());
  return image;
}
