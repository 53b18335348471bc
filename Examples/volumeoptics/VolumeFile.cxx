// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "VolumeFile.h"

#include "InvesaliusProject.h"
#include "UserError.h"

#include <vtkAlgorithm.h>
#include <vtkCallbackCommand.h>
#include <vtkDICOMImageReader.h>
#include <vtkDataArray.h>
#include <vtkExecutive.h>
#include <vtkGenericDataObjectReader.h>
#include <vtkImageExtractComponents.h>
#include <vtkImageReader2.h>
#include <vtkLogger.h>
#include <vtkMath.h>
#include <vtkMatrix3x3.h>
#include <vtkMatrix4x4.h>
#include <vtkMetaImageReader.h>
#include <vtkNIFTIImageReader.h>
#include <vtkNew.h>
#include <vtkNrrdReader.h>
#include <vtkPointData.h>
#include <vtkXMLImageDataReader.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <type_traits>

namespace
{
namespace fs = std::filesystem;

const char* const Readable =
  ".vti, .mhd, .mha, .nrrd, .nhdr, .nii, .nii.gz, .vtk, .dcm, a DICOM folder or .inv3";

bool EndsWith(const std::string& text, const std::string& end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

std::string LowerCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

void KeepMessage(vtkObject*, unsigned long, void* clientData, void* callData)
{
  auto* kept = static_cast<std::string*>(clientData);
  if (kept->empty() && callData)
  {
    *kept = static_cast<const char*>(callData);
  }
}

// VTK's messages end with the text that matters, on a line of its own.
std::string LastLine(const std::string& message)
{
  std::string text = message;
  std::replace(text.begin(), text.end(), '\r', ' ');
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())))
  {
    text.pop_back();
  }
  while (!text.empty() && text.back() == '.')
  {
    text.pop_back();
  }
  const auto at = text.find("): ");
  text = at == std::string::npos ? text : text.substr(at + 3);
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

UserError Unreadable(const std::string& path, const std::string& reason)
{
  return UserError("'" + path + "' cannot be read as a volume (" + reason +
    "). Check that the file is complete and that its ending names its format.");
}

vtkSmartPointer<vtkImageData> Run(vtkAlgorithm* reader, const std::string& path)
{
  std::string message;
  vtkNew<vtkCallbackCommand> keep;
  keep->SetCallback(KeepMessage);
  keep->SetClientData(&message);
  for (const auto event : { vtkCommand::ErrorEvent, vtkCommand::WarningEvent })
  {
    reader->AddObserver(event, keep);
    reader->GetExecutive()->AddObserver(event, keep);
  }
  const auto verbosity = vtkLogger::GetCurrentVerbosityCutoff();
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  reader->Update();
  vtkLogger::SetStderrVerbosity(verbosity);
  auto* image = vtkImageData::SafeDownCast(reader->GetOutputDataObject(0));
  auto* other = vtkDataSet::SafeDownCast(reader->GetOutputDataObject(0));
  if (image == nullptr && other != nullptr)
  {
    throw UserError("'" + path + "' holds a " + other->GetClassName() +
      ", not a volume. Resample it to an image first, e.g. by vtkResampleToImage.");
  }
  if (image == nullptr || image->GetNumberOfPoints() == 0)
  {
    throw Unreadable(path, message.empty() ? "it has no voxels" : LastLine(message));
  }
  return image;
}

template <class Reader>
vtkSmartPointer<vtkImageData> RunFile(const std::string& path)
{
  vtkNew<Reader> reader;
  if constexpr (std::is_base_of<vtkImageReader2, Reader>::value)
  {
    if (reader->CanReadFile(path.c_str()) == 0)
    {
      throw Unreadable(path, "no valid header");
    }
  }
  reader->SetFileName(path.c_str());
  return Run(reader, path);
}

vtkSmartPointer<vtkImageData> ReadDicom(const std::string& path)
{
  vtkNew<vtkDICOMImageReader> reader;
  if (fs::is_directory(path))
  {
    if (fs::is_empty(path))
    {
      throw UserError("The folder '" + path + "' is empty. Name the folder of one DICOM series.");
    }
    reader->SetDirectoryName(path.c_str());
  }
  else
  {
    reader->SetFileName(path.c_str());
  }
  return Run(reader, path);
}

// Places the voxels in the world of the header's qform or sform, which VTK's reader leaves to us.
vtkSmartPointer<vtkImageData> ReadNifti(const std::string& path)
{
  vtkNew<vtkNIFTIImageReader> reader;
  reader->SetFileName(path.c_str());
  auto image = Run(reader, path);
  vtkMatrix4x4* form = reader->GetSFormMatrix() ? reader->GetSFormMatrix() : reader->GetQFormMatrix();
  if (form == nullptr)
  {
    return image;
  }
  vtkNew<vtkMatrix3x3> direction;
  for (int column = 0; column < 3; ++column)
  {
    double axis[3];
    for (int row = 0; row < 3; ++row)
    {
      axis[row] = form->GetElement(row, column);
    }
    vtkMath::Normalize(axis);
    for (int row = 0; row < 3; ++row)
    {
      direction->SetElement(row, column, axis[row]);
    }
  }
  image->SetDirectionMatrix(direction);
  image->SetOrigin(form->GetElement(0, 3), form->GetElement(1, 3), form->GetElement(2, 3));
  return image;
}

vtkSmartPointer<vtkImageData> ReadByEnding(const std::string& path)
{
  const std::string name = LowerCase(path);
  if (fs::is_directory(path) || EndsWith(name, ".dcm"))
  {
    return ReadDicom(path);
  }
  if (EndsWith(name, ".vti"))
  {
    return RunFile<vtkXMLImageDataReader>(path);
  }
  if (EndsWith(name, ".mhd") || EndsWith(name, ".mha"))
  {
    return RunFile<vtkMetaImageReader>(path);
  }
  if (EndsWith(name, ".nrrd") || EndsWith(name, ".nhdr"))
  {
    return RunFile<vtkNrrdReader>(path);
  }
  if (EndsWith(name, ".nii") || EndsWith(name, ".nii.gz"))
  {
    return ReadNifti(path);
  }
  if (EndsWith(name, ".vtk"))
  {
    return RunFile<vtkGenericDataObjectReader>(path);
  }
  if (EndsWith(name, ".inv3"))
  {
    return ReadInvesaliusProject(path);
  }
  throw UserError("'" + path + "' has an ending that is not known. Convert it to one of: " + Readable + ".");
}

// Leaves one component of one array of the points.
vtkSmartPointer<vtkImageData> OneScalar(vtkSmartPointer<vtkImageData> image, const std::string& path)
{
  vtkPointData* data = image->GetPointData();
  if (data->GetScalars() == nullptr && data->GetNumberOfArrays() > 0)
  {
    data->SetActiveScalars(data->GetArrayName(0));
  }
  if (data->GetScalars() == nullptr || image->GetDataDimension() < 1)
  {
    throw UserError("'" + path + "' has no scalars at its points. Give it one point data array.");
  }
  if (data->GetScalars()->GetNumberOfComponents() == 1)
  {
    return image;
  }
  vtkNew<vtkImageExtractComponents> first;
  first->SetInputData(image);
  first->SetComponents(0);
  first->Update();
  return first->GetOutput();
}
}

Volume ReadVolume(const std::string& path)
{
  if (!fs::exists(path))
  {
    throw UserError("'" + path + "' does not exist. Check the path.");
  }
  const std::string name = LowerCase(path);
  const bool faceAlongY = EndsWith(name, ".inv3") || EndsWith(name, ".nii") || EndsWith(name, ".nii.gz");
  Volume volume;
  volume.Image = OneScalar(ReadByEnding(path), path);
  volume.Name = fs::path(path).filename().string();
  volume.Front = faceAlongY ? 1.0 : -1.0;
  return volume;
}
