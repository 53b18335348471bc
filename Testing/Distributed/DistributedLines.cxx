// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Lines as voxels under MPI: any number of processes has, in each of them, the voxels that one has of all lines;
// byte for byte the same in all of them, to the rounding of float those of one. Also where a process has
// no lines, none of a type, or not the array.

#include "../Cxx/LineTesting.h"
#include "Processes.h"
#include "vtkAnalyticLineSource.h"

#include "vtkCellData.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTrivialProducer.h"
#include "vtkUnsignedCharArray.h"

#include <functional>

namespace
{
using Voxels = vtkSmartPointer<vtkImageData>;

// Lines of three types and with colours, of which the types from 1 on are in a third of them.
vtkSmartPointer<vtkPolyData> MakeAll()
{
  auto data = lines::MakeLines(lines::RandomLines(600, 5));
  vtkNew<vtkIntArray> types;
  types->SetName("Type");
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("Color");
  colors->SetNumberOfComponents(3);
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    types->InsertNextValue(cell < 400 ? 0 : cell < 500 ? 3 : 7);
    const unsigned char color[3] = { static_cast<unsigned char>(cell % 256), 100, 200 };
    colors->InsertNextTypedTuple(color);
  }
  data->GetCellData()->AddArray(types);
  data->GetCellData()->AddArray(colors);
  return data;
}

// The lines from first to last, with their points.
vtkSmartPointer<vtkPolyData> Part(vtkPolyData* all, vtkIdType first, vtkIdType last)
{
  auto part = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkCellArray> cells;
  auto data = part->GetCellData();
  data->CopyAllocate(all->GetCellData(), last - first);
  for (vtkIdType cell = first; cell < last; ++cell)
  {
    vtkIdType count = 0;
    const vtkIdType* points = nullptr;
    all->GetLines()->GetCellAtId(cell, count, points);
    data->CopyData(all->GetCellData(), cell, cells->InsertNextCell(count, points));
  }
  part->SetPoints(all->GetPoints());
  part->SetLines(cells);
  return part;
}

// Gives the lines in equal pieces.
class PieceSource : public vtkPolyDataAlgorithm
{
public:
  static PieceSource* New();
  vtkTypeMacro(PieceSource, vtkPolyDataAlgorithm);
  vtkSmartPointer<vtkPolyData> All;

protected:
  PieceSource() { this->SetNumberOfInputPorts(0); }
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    outputs->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
    return 1;
  }
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    vtkInformation* info = outputs->GetInformationObject(0);
    const vtkIdType piece = info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER());
    const vtkIdType pieces = info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES());
    const vtkIdType count = this->All->GetNumberOfCells();
    vtkPolyData::GetData(outputs)->ShallowCopy(
      Part(this->All, count * piece / pieces, count * (piece + 1) / pieces));
    return 1;
  }
};
vtkStandardNewMacro(PieceSource);

// One checksum of all arrays' bytes.
double Checksum(vtkImageData* voxels)
{
  std::size_t sum = 1469598103934665603U;
  const auto add = [&](vtkFieldData* data) {
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = data->GetArray(i);
      const auto* bytes = static_cast<const unsigned char*>(array->GetVoidPointer(0));
      const vtkIdType size = array->GetNumberOfValues() * array->GetDataTypeSize();
      for (vtkIdType at = 0; at < size; ++at)
      {
        sum = (sum ^ bytes[at]) * 1099511628211U;
      }
    }
  };
  add(voxels->GetFieldData());
  add(voxels->GetCellData());
  return static_cast<double>(sum % 1000000007U);
}

void CompareArrays(vtkImageData* whole, vtkImageData* shared, const std::string& name, Check& check)
{
  vtkFieldData* wanted = whole->GetFieldData();
  check.Near(
    name + ": arrays", shared->GetFieldData()->GetNumberOfArrays(), wanted->GetNumberOfArrays(), 0.0);
  for (int i = 0; i < wanted->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* expected = wanted->GetArray(i);
    vtkDataArray* found = shared->GetFieldData()->GetArray(expected->GetName());
    const std::string array = name + ": " + expected->GetName();
    if (!check.That(found && found->GetNumberOfValues() == expected->GetNumberOfValues(), array + " differs"))
    {
      continue;
    }
    const int components = expected->GetNumberOfComponents();
    double largest = 0.0, off = 0.0;
    for (vtkIdType value = 0; value < expected->GetNumberOfValues(); ++value)
    {
      const double one = expected->GetComponent(value / components, static_cast<int>(value % components));
      const double other = found->GetComponent(value / components, static_cast<int>(value % components));
      largest = std::max(largest, std::abs(one));
      off = std::max(off, std::abs(one - other));
    }
    // Sums in float of as many parts as there are processes, in place of double: half a unit in the last
    // place (6e-8) of the voxel's value each. All else is exact.
    const bool isFloat = expected->GetDataType() == VTK_FLOAT;
    check.AtMost(array, off, isFloat ? 1e-6 * largest : 0.0);
  }
}

class LinesTest
{
public:
  LinesTest(Processes& processes, Check& check)
    : All(processes)
    , Result(check)
  {
    this->Voxelizer->SetSampleDimensions(20, 17, 9);
    this->Voxelizer->SetLineTypeArray("Type");
    this->Voxelizer->SetColorArray("Color");
    // At the tolerance rounding decides what is dropped.
    this->Voxelizer->SetCoefficientTolerance(0.0);
  }

  Voxels Whole(vtkPolyData* all)
  {
    this->Voxelizer->SetController(nullptr);
    this->Voxelizer->SetInputData(all);
    this->Voxelizer->SetNumberOfPieces(1);
    this->Voxelizer->Update();
    auto whole = Voxels::New();
    whole->DeepCopy(this->Voxelizer->GetOutput());
    return whole;
  }

  vtkImageData* Shared(vtkAlgorithm* source)
  {
    this->Voxelizer->SetController(vtkMultiProcessController::GetGlobalController());
    this->Voxelizer->SetInputConnection(source->GetOutputPort());
    this->Voxelizer->UpdatePiece(this->All.Rank(), this->All.Size(), 0);
    return this->Voxelizer->GetOutput();
  }

  void Compare(vtkImageData* whole, vtkImageData* shared, const std::string& name)
  {
    CompareArrays(whole, shared, name, this->Result);
    const double own = Checksum(shared);
    this->Result.Near(name + ": checksum over processes", this->All.Sum(own), own * this->All.Size(), 0.0);
    vtkDataArray* bricks = shared->GetCellData()->GetScalars();
    bool isEqual = bricks->GetNumberOfValues() == whole->GetCellData()->GetScalars()->GetNumberOfValues();
    for (vtkIdType i = 0; isEqual && i < bricks->GetNumberOfTuples(); ++i)
    {
      isEqual = bricks->GetComponent(i, 0) == whole->GetCellData()->GetScalars()->GetComponent(i, 0);
    }
    this->Result.That(isEqual, name + ": bricks differ");
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Result.Near(name + ": origin", shared->GetOrigin()[axis], whole->GetOrigin()[axis], 0.0);
      this->Result.Near(name + ": spacing", shared->GetSpacing()[axis], whole->GetSpacing()[axis], 0.0);
    }
  }

  Processes& All;
  Check& Result;
  vtkNew<vtkAnisotropicLineVoxelizer> Voxelizer;
};

void CheckPieces(LinesTest& test)
{
  const auto all = MakeAll();
  vtkNew<PieceSource> source;
  source->All = all;
  const Voxels whole = test.Whole(all);
  for (int pieces : { 1, 3 })
  {
    test.Voxelizer->SetNumberOfPieces(pieces);
    test.Compare(whole, test.Shared(source), "lines in " + std::to_string(pieces) + " pieces a process");
  }
  test.Voxelizer->ResultOnAllProcessesOff();
  vtkImageData* first = test.Shared(source);
  if (test.All.Rank() == 0)
  {
    CompareArrays(whole, first, "the first process", test.Result);
  }
  test.Result.That((first->GetNumberOfPoints() > 0) == (test.All.Rank() == 0), "the first process alone");
  test.Voxelizer->ResultOnAllProcessesOn();
  test.Voxelizer->SetModelBounds(0.1, 0.9, 0.1, 0.9, 0.1, 0.9);
  const Voxels inBox = test.Whole(all);
  test.Compare(inBox, test.Shared(source), "lines in a box that is set");
  test.Voxelizer->SetModelBounds(1.0, -1.0, 1.0, -1.0, 1.0, -1.0);
}

// Everything is in one process, without so much as the arrays in the others; or nothing anywhere.
void CheckEmptyProcesses(LinesTest& test)
{
  const auto all = MakeAll();
  const Voxels whole = test.Whole(all);
  vtkNew<vtkPolyData> nothing;
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(test.All.Rank() == test.All.Size() - 1 ? all.Get() : nothing.Get());
  test.Compare(whole, test.Shared(producer), "one process has all");
  vtkNew<vtkTrivialProducer> none;
  none->SetOutput(nothing);
  vtkImageData* empty = test.Shared(none);
  test.Result.Near("no lines: types", lines::CountOf(empty, "LineTypes"), 0.0, 0.0);
  test.Result.Near("no lines: range of bricks", empty->GetCellData()->GetScalars()->GetRange()[1], -1.0, 0.0);
}

void CheckSource(LinesTest& test)
{
  vtkNew<vtkAnalyticLineSource> source;
  vtkNew<vtkAnisotropicLineVoxelizer> voxelizer;
  voxelizer->SetSampleDimensions(16, 16, 16);
  voxelizer->SetCoefficientTolerance(0.0);
  voxelizer->SetController(nullptr);
  voxelizer->SetInputConnection(source->GetOutputPort());
  voxelizer->Update();
  vtkNew<vtkImageData> whole;
  whole->DeepCopy(voxelizer->GetOutput());
  voxelizer->SetController(vtkMultiProcessController::GetGlobalController());
  voxelizer->UpdatePiece(test.All.Rank(), test.All.Size(), 0);
  test.Compare(whole, voxelizer->GetOutput(), "a source that names its bounds");
}

// One process lacks the array of types: all stop, and say so.
void CheckFailure(LinesTest& test)
{
  const auto lines = MakeAll();
  if (test.All.Rank() == 0)
  {
    lines->GetCellData()->RemoveArray("Type");
  }
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(lines);
  vtkNew<vtkCallbackCommand> silence; // the executive repeats that there was an error
  silence->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  test.Voxelizer->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, silence);
  lines::Messages messages(test.Voxelizer);
  vtkImageData* voxels = test.Shared(producer);
  test.Result.That(messages.Has(test.All.Rank() == 0 ? "no array" : "Another process"), "a failure is said");
  test.Result.Near("points after a failure", voxels->GetNumberOfPoints(), 0.0, 0.0);
  test.Voxelizer->GetExecutive()->RemoveObserver(silence);
}
}

int main(int argc, char* argv[])
{
  Processes all(argc, argv);
  Check check;
  LinesTest test(all, check);
  CheckPieces(test);
  CheckEmptyProcesses(test);
  CheckSource(test);
  CheckFailure(test);
  return all.ExitCode(check.ExitCode());
}
