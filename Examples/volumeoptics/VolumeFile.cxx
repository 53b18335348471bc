// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "VolumeFile.h"

#include "HeaderCheck.h"
#include "InvesaliusProject.h"
#include "ReadingGuard.h"
#include "UserError.h"

#include <vtkAlgorithm.h>
#include <vtkDICOMImageReader.h>
#include <vtkDataArray.h>
#include <vtkGenericDataObjectReader.h>
#include <vtkImageExtractComponents.h>
#include <vtkImageReader2.h>
#include <vtkInformation.h>
#include <vtkMath.h>
#include <vtkMatrix3x3.h>
#include <vtkMatrix4x4.h>
#include <vtkMetaImageReader.h>
#include <vtkNIFTIImageReader.h>
#include <vtkNew.h>
#include <vtkNrrdReader.h>
#include <vtkPointData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkXMLImageDataReader.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <limits>
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

UserError Unreadable(const std::string& path, const std::string& reason)
{
  return UserError("'" + path + "' cannot be read as a volume (" + reason +
    "). Check that the file is complete and that its ending names its format.");
}

// What the header promises, before memory is taken for it. Returns the bytes of its scalars.
double CheckHeader(vtkAlgorithm* reader, const std::string& path)
{
  reader->UpdateInformation();
  vtkInformation* header = reader->GetOutputInformation(0);
  int extent[6];
  if (header == nullptr || !header->Has(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()))
  {
    return 0.0; // the object is made while reading
  }
  header->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
  vtkInformation* scalars = vtkDataObject::GetActiveFieldInformation(
    header, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
  const int type = scalars ? scalars->Get(vtkDataObject::FIELD_ARRAY_TYPE()) : VTK_UNSIGNED_CHAR;
  const int components = scalars ? scalars->Get(vtkDataObject::FIELD_NUMBER_OF_COMPONENTS()) : 1;
  const double one[] = { 1.0, 1.0, 1.0 }, none[] = { 0.0, 0.0, 0.0 };
  const double* spacing = header->Get(vtkDataObject::SPACING());
  const double* origin = header->Get(vtkDataObject::ORIGIN());
  const double bytes = 1.0 * std::max(components, 1) * vtkDataArray::GetDataTypeSize(type);
  RequireGrid(path, extent, bytes, spacing ? spacing : one, origin ? origin : none,
    header->Get(vtkDataObject::DIRECTION()));
  return bytes * (extent[1] - extent[0] + 1.0) * (extent[3] - extent[2] + 1.0) *
    (extent[5] - extent[4] + 1.0);
}

// What was read is as large as it says.
void CheckContents(vtkImageData* image, const std::string& path)
{
  RequireGrid(path, image->GetExtent(), 1.0, image->GetSpacing(), image->GetOrigin(),
    image->GetDirectionMatrix()->GetData());
  for (int i = 0; i < image->GetPointData()->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = image->GetPointData()->GetAbstractArray(i);
    if (array->GetNumberOfTuples() < image->GetNumberOfPoints())
    {
      throw Unreadable(path, "its data are fewer than its points");
    }
  }
}

// bytes: of the file's data.
vtkSmartPointer<vtkImageData> Run(
  vtkAlgorithm* reader, const std::string& path, double bytes = std::numeric_limits<double>::infinity())
{
  const ReadingGuard guard(path);
  if (CheckHeader(reader, path) > bytes)
  {
    throw Unreadable(path, "its header promises more voxels than it holds");
  }
  if (guard.GetError().empty())
  {
    reader->Update();
  }
  auto* image = vtkImageData::SafeDownCast(reader->GetOutputDataObject(0));
  auto* other = vtkDataSet::SafeDownCast(reader->GetOutputDataObject(0));
  if (!guard.GetError().empty())
  {
    throw Unreadable(path, guard.GetError());
  }
  if (image == nullptr && other != nullptr)
  {
    throw UserError("'" + path + "' holds a " + other->GetClassName() +
      ", not a volume. Resample it to an image first, e.g. by vtkResampleToImage.");
  }
  if (image == nullptr || image->GetNumberOfPoints() == 0)
  {
    throw Unreadable(path, "it has no voxels");
  }
  CheckContents(image, path);
  return image;
}

template <class Reader>
vtkSmartPointer<vtkImageData> RunFile(
  const std::string& path, double bytes = std::numeric_limits<double>::infinity())
{
  vtkNew<Reader> reader;
  if constexpr (std::is_base_of<vtkImageReader2, Reader>::value)
  {
    const ReadingGuard guard(path);
    if (reader->CanReadFile(path.c_str()) == 0)
    {
      throw Unreadable(path, "no valid header");
    }
  }
  reader->SetFileName(path.c_str());
  return Run(reader, path, bytes);
}

vtkSmartPointer<vtkImageData> ReadVti(const std::string& path)
{
  const std::string fault = FaultOfXml(path);
  if (!fault.empty())
  {
    throw Unreadable(path, fault);
  }
  return RunFile<vtkXMLImageDataReader>(path);
}

vtkSmartPointer<vtkImageData> ReadNrrd(const std::string& path)
{
  double bytes = 0.0;
  const std::string fault = FaultOfNrrd(path, bytes);
  if (!fault.empty())
  {
    throw Unreadable(path, fault);
  }
  return RunFile<vtkNrrdReader>(path, bytes);
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
    if (!(vtkMath::Normalize(axis) > 0.0) || !std::isfinite(axis[0] + axis[1] + axis[2]))
    {
      throw Unreadable(path, "its qform or sform has an axis without a direction");
    }
    for (int row = 0; row < 3; ++row)
    {
      direction->SetElement(row, column, axis[row]);
    }
  }
  image->SetDirectionMatrix(direction);
  image->SetOrigin(form->GetElement(0, 3), form->GetElement(1, 3), form->GetElement(2, 3));
  CheckContents(image, path);
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
    return ReadVti(path);
  }
  if (EndsWith(name, ".mhd") || EndsWith(name, ".mha"))
  {
    return RunFile<vtkMetaImageReader>(path);
  }
  if (EndsWith(name, ".nrrd") || EndsWith(name, ".nhdr"))
  {
    return ReadNrrd(path);
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
  RequireFile(path, true);
  const std::string name = LowerCase(path);
  const bool faceAlongY = EndsWith(name, ".inv3") || EndsWith(name, ".nii") || EndsWith(name, ".nii.gz");
  Volume volume;
  volume.Image = OneScalar(ReadByEnding(path), path);
  volume.Name = fs::path(path).filename().string();
  volume.Front = faceAlongY ? 1.0 : -1.0;
  return volume;
}
