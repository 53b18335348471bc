// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ProcessGroup.h"

#include "vtkAlgorithm.h"
#include "vtkCommunicator.h"
#include "vtkCompositeDataSet.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkMultiProcessController.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <numeric>

namespace volumeoptics
{
namespace
{
// Where the bytes of each process begin.
std::vector<vtkIdType> OffsetsOf(const std::vector<vtkIdType>& lengths)
{
  std::vector<vtkIdType> offsets(lengths.size(), 0);
  std::partial_sum(lengths.begin(), lengths.end() - 1, offsets.begin() + 1);
  return offsets;
}
}

int NumberOfPieces(vtkInformation* output)
{
  return output->Has(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES())
    ? output->Get(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES())
    : 1;
}

ProcessGroup::ProcessGroup(
  vtkMultiProcessController* controller, vtkAlgorithm* algorithm, vtkInformation* output)
{
  const int size = controller ? controller->GetNumberOfProcesses() : 1;
  const bool isComposite =
    vtkCompositeDataSet::SafeDownCast(algorithm->GetExecutive()->GetInputData(0, 0)) != nullptr;
  const bool isOwnPiece = size > 1 && NumberOfPieces(output) == size &&
    output->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) == controller->GetLocalProcessId();
  if (isOwnPiece && !isComposite)
  {
    this->Controller = controller;
    this->Rank = controller->GetLocalProcessId();
    this->Size = size;
  }
}

void ProcessGroup::Reduce(double* numbers, vtkIdType count, int operation) const
{
  if (this->Controller && count > 0)
  {
    const std::vector<double> own(numbers, numbers + count);
    this->Controller->AllReduce(own.data(), numbers, count, operation);
  }
}

bool ProcessGroup::All(bool holds) const
{
  double least = holds ? 1.0 : 0.0;
  this->Least(&least, 1);
  return least > 0.0;
}

void ProcessGroup::Least(double* numbers, vtkIdType count) const
{
  this->Reduce(numbers, count, vtkCommunicator::MIN_OP);
}

void ProcessGroup::Largest(double* numbers, vtkIdType count) const
{
  this->Reduce(numbers, count, vtkCommunicator::MAX_OP);
}

void ProcessGroup::Largest(std::vector<unsigned char>& numbers) const
{
  if (this->Controller && !numbers.empty())
  {
    const std::vector<unsigned char> own = numbers;
    this->Controller->AllReduce(
      own.data(), numbers.data(), static_cast<vtkIdType>(own.size()), vtkCommunicator::MAX_OP);
  }
}

void ProcessGroup::Sum(std::vector<vtkIdType>& numbers) const
{
  if (this->Controller && !numbers.empty())
  {
    const std::vector<vtkIdType> own = numbers;
    this->Controller->AllReduce(
      own.data(), numbers.data(), static_cast<vtkIdType>(own.size()), vtkCommunicator::SUM_OP);
  }
}

void ProcessGroup::Unite(double range[2]) const
{
  const bool isEmpty = range[0] > range[1];
  double least = isEmpty ? VTK_DOUBLE_MAX : range[0];
  double largest = isEmpty ? -VTK_DOUBLE_MAX : range[1];
  this->Least(&least, 1);
  this->Largest(&largest, 1);
  range[0] = least > largest ? 1.0 : least;
  range[1] = least > largest ? 0.0 : largest;
}

std::vector<Extent> ProcessGroup::Gather(const Extent& extent) const
{
  std::vector<Extent> extents(this->Size, extent);
  if (this->Controller)
  {
    this->Controller->AllGather(extent.data(), extents[0].data(), static_cast<vtkIdType>(extent.size()));
  }
  return extents;
}

std::vector<char> ProcessGroup::GatherAt(int rank, const std::vector<char>& bytes) const
{
  if (!this->Controller)
  {
    return bytes;
  }
  const auto length = static_cast<vtkIdType>(bytes.size());
  std::vector<vtkIdType> lengths(this->Size, 0);
  this->Controller->Gather(&length, lengths.data(), 1, rank);
  std::vector<vtkIdType> offsets = OffsetsOf(lengths);
  std::vector<char> all(lengths.back() + offsets.back());
  this->Controller->GatherV(bytes.data(), all.data(), length, lengths.data(), offsets.data(), rank);
  return all;
}

std::vector<char> ProcessGroup::GatherEverywhere(const std::vector<char>& bytes) const
{
  if (!this->Controller)
  {
    return bytes;
  }
  const auto length = static_cast<vtkIdType>(bytes.size());
  std::vector<vtkIdType> lengths(this->Size, 0);
  this->Controller->AllGather(&length, lengths.data(), 1);
  std::vector<vtkIdType> offsets = OffsetsOf(lengths);
  std::vector<char> all(lengths.back() + offsets.back());
  this->Controller->AllGatherV(bytes.data(), all.data(), length, lengths.data(), offsets.data());
  return all;
}
}
