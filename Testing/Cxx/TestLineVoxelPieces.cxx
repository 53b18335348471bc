// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Lines that come in pieces: from a file as from memory, and many more of them in no more memory.

#include "FreedMemory.h"
#include "LineTesting.h"

#include "vtkAnalyticLineSource.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLPolyDataWriter.h"

#include <sys/resource.h>

namespace
{
vtkSmartPointer<vtkImageData> Voxelize(vtkAlgorithmOutput* lines, int pieces)
{
  vtkNew<vtkAnisotropicLineVoxelizer> voxelizer;
  voxelizer->SetInputConnection(lines);
  voxelizer->SetNumberOfPieces(pieces);
  voxelizer->SetModelBounds(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0);
  voxelizer->SetSampleDimensions(48, 48, 48);
  voxelizer->SetMaximumOrder(2);
  voxelizer->SetCoefficientTolerance(0.0);
  voxelizer->Update();
  return voxelizer->GetOutput();
}

// A reader that is asked for a piece reads this piece of the file alone.
void CheckReader(Check& check)
{
  const std::string path = VOLUMEOPTICS_TEMPORARY "/TestLineVoxelPieces.vtp";
  vtkNew<vtkAnalyticLineSource> source;
  source->SetNumberOfSegments(30000);
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputConnection(source->GetOutputPort());
  writer->SetNumberOfPieces(6);
  writer->SetFileName(path.c_str());
  check.That(writer->Write() == 1, "written");
  const auto whole = Voxelize(source->GetOutputPort(), 1);
  check.AtLeast("voxels", lines::CountOf(whole, "LineType0_Places"), 500.0);
  for (int pieces : { 1, 3, 6 })
  {
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(path.c_str());
    const auto voxels = Voxelize(reader->GetOutputPort(), pieces);
    check.AtMost(std::to_string(pieces) + " pieces of a file", lines::Difference(whole, voxels), 1e-6);
    const double read = reader->GetOutput()->GetNumberOfPoints();
    check.AtMost("points of the last piece", read, 1.1 * 30150.0 / pieces);
  }
}

// MiB that the process has held at most so far.
double PeakMemory()
{
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss / 1024.0;
}

// 4 million segments take 90 MiB, a piece of a hundredth of them 1 MiB.
void CheckMemory(Check& check)
{
  vtkNew<vtkAnalyticLineSource> source;
  source->SetNumberOfSegments(400000);
  const auto few = Voxelize(source->GetOutputPort(), 10);
  const double before = PeakMemory();
  source->SetNumberOfSegments(4000000);
  const auto many = Voxelize(source->GetOutputPort(), 100);
  const double grown = PeakMemory() - before;
  std::cout << "ten times the segments in pieces: " << grown << " MiB more" << std::endl;
  if (!FreedMemoryIsKept)
  {
    check.AtMost("ten times the segments, MiB more", grown, 30.0);
  }
  check.AtLeast("they are there", lines::FieldSum(many, "LineType0_Coefficients", 3),
    5.0 * lines::FieldSum(few, "LineType0_Coefficients", 3));
}
}

int TestLineVoxelPieces(int, char*[])
{
  Check check;
  CheckReader(check);
  CheckMemory(check);
  return check.ExitCode();
}
