// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LineFile.h"

#include "HeaderCheck.h"
#include "OutputFile.h"
#include "ReadingGuard.h"
#include "UserError.h"

#include "vtkAnisotropicVoxelEvaluator.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkGenericDataObjectReader.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLImageDataWriter.h>
#include <vtkXMLPolyDataReader.h>

#include <cmath>
#include <filesystem>
#include <type_traits>

namespace
{
// Beyond, a length's square is no float any more.
constexpr double LargestCoordinate = 1e18;

UserError Unreadable(const std::string& path, const std::string& reason)
{
  return UserError("'" + path + "' cannot be read (" + reason +
    "). Check that the file is complete and that its ending names its format.");
}

// Voxels of a header that promises more than memory holds are refused before it is taken.
template <class Reader>
vtkSmartPointer<vtkDataObject> ReadBy(const std::string& path)
{
  RequireFile(path);
  const std::string fault = std::is_base_of<vtkXMLReader, Reader>::value ? FaultOfXml(path) : "";
  if (!fault.empty())
  {
    throw Unreadable(path, fault);
  }
  const ReadingGuard guard(path);
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  reader->UpdateInformation();
  vtkInformation* header = reader->GetOutputInformation(0);
  if (guard.GetError().empty() && header && header->Has(vtkDataObject::SPACING()) &&
    header->Has(vtkDataObject::ORIGIN()) && header->Has(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()))
  {
    RequireGrid(path, header->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()), 1.0,
      header->Get(vtkDataObject::SPACING()), header->Get(vtkDataObject::ORIGIN()),
      header->Get(vtkDataObject::DIRECTION()));
  }
  if (guard.GetError().empty())
  {
    reader->Update();
  }
  if (!guard.GetError().empty())
  {
    throw Unreadable(path, guard.GetError());
  }
  return reader->GetOutputDataObject(0);
}

// Offsets ascend within the connectivity, whose points exist.
bool AreValid(vtkCellArray* cells, vtkIdType points)
{
  vtkDataArray* offsets = cells->GetOffsetsArray();
  vtkDataArray* connectivity = cells->GetConnectivityArray();
  vtkIdType before = 0;
  for (vtkIdType i = 0; i < offsets->GetNumberOfTuples(); ++i)
  {
    const auto offset = static_cast<vtkIdType>(offsets->GetComponent(i, 0));
    if (offset < before || offset > connectivity->GetNumberOfTuples() || (i == 0 && offset != 0))
    {
      return false;
    }
    before = offset;
  }
  for (vtkIdType i = 0; i < connectivity->GetNumberOfTuples(); ++i)
  {
    const double point = connectivity->GetComponent(i, 0);
    if (!(point >= 0.0 && point < static_cast<double>(points)))
    {
      return false;
    }
  }
  return true;
}

bool AreComplete(vtkFieldData* data, vtkIdType tuples)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    if (data->GetAbstractArray(i)->GetNumberOfTuples() < tuples)
    {
      return false;
    }
  }
  return true;
}

void CheckLines(vtkPolyData* lines, const std::string& path)
{
  for (vtkCellArray* cells : { lines->GetVerts(), lines->GetLines(), lines->GetPolys(), lines->GetStrips() })
  {
    if (!AreValid(cells, lines->GetNumberOfPoints()))
    {
      throw Unreadable(path, "its cells name points that it does not have");
    }
  }
  if (!AreComplete(lines->GetPointData(), lines->GetNumberOfPoints()) ||
    !AreComplete(lines->GetCellData(), lines->GetNumberOfCells()))
  {
    throw Unreadable(path, "its data are fewer than its points or cells");
  }
  vtkDataArray* points = lines->GetPoints()->GetData();
  for (vtkIdType i = 0; i < 3 * lines->GetNumberOfPoints(); ++i)
  {
    if (!(std::abs(points->GetComponent(i / 3, static_cast<int>(i % 3))) <= LargestCoordinate))
    {
      throw Unreadable(path, "its points are not finite, or beyond 1e18");
    }
  }
}
}

vtkSmartPointer<vtkPolyData> ReadLines(const std::string& path)
{
  const bool isXml = std::filesystem::path(path).extension() == ".vtp";
  const auto data = isXml ? ReadBy<vtkXMLPolyDataReader>(path) : ReadBy<vtkGenericDataObjectReader>(path);
  vtkSmartPointer<vtkPolyData> lines = vtkPolyData::SafeDownCast(data);
  if (!lines || lines->GetNumberOfLines() == 0 || lines->GetNumberOfPoints() == 0)
  {
    throw UserError("'" + path +
      "' holds no lines. Give a .vtp or .vtk file of vtkPolyData with "
      "lines, or a .vti that --voxels wrote.");
  }
  CheckLines(lines, path);
  return lines;
}

bool IsVoxelFile(const std::string& path)
{
  return std::filesystem::path(path).extension() == ".vti";
}

vtkSmartPointer<vtkImageData> ReadVoxels(const std::string& path)
{
  vtkSmartPointer<vtkImageData> voxels = vtkImageData::SafeDownCast(ReadBy<vtkXMLImageDataReader>(path));
  const double distance = vtkAnisotropicVoxelEvaluator::GetScalarOpacityUnitDistance(voxels);
  if (!voxels || !(distance > 0.0))
  {
    throw UserError(
      "'" + path + "' holds no anisotropic voxels. Write such a file by lines --voxels FILE.vti.");
  }
  return voxels;
}

void WriteVoxels(vtkImageData* voxels, const std::string& path)
{
  WriteFile(path, [&](const std::string& temporary) {
    vtkNew<vtkXMLImageDataWriter> writer;
    writer->SetInputData(voxels);
    writer->SetFileName(temporary.c_str());
    return writer->Write() == 1;
  });
}
