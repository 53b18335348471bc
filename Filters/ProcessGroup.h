// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The processes that share the pieces of one input, and what they tell each other. Every function that
// names all processes must be called by all of them, in the same order; alone, it gives the process's own.

#ifndef ProcessGroup_h
#define ProcessGroup_h

#include "ImageGrid.h"

#include "vtkType.h"

#include <functional>
#include <vector>

class vtkAlgorithm;
class vtkInformation;
class vtkMultiProcessController;

namespace volumeoptics
{
// Whether an output is asked for one of several pieces.
int NumberOfPieces(vtkInformation* output);

class ProcessGroup
{
public:
  // Alone, unless each process is asked for the piece of its own number. Blocks of composite data are
  // each alone, because processes need not have the same number of them. controller: may be null.
  ProcessGroup(vtkMultiProcessController* controller, vtkAlgorithm* algorithm, vtkInformation* output);

  bool IsShared() const { return this->Controller != nullptr; }
  int GetRank() const { return this->Rank; }
  int GetSize() const { return this->Size; }

  // Whether something holds in all processes.
  bool All(bool holds) const;
  // Whether it holds in one of them.
  bool Any(bool holds) const { return !this->All(!holds); }

  // The least, the largest, the sum of all processes, number by number.
  void Least(double* numbers, vtkIdType count) const;
  void Largest(double* numbers, vtkIdType count) const;
  void Largest(std::vector<unsigned char>& numbers) const;
  void Sum(std::vector<vtkIdType>& numbers) const;

  // A range whose least exceeds its largest is empty.
  void Unite(double range[2]) const;

  // The extents of all processes, by their numbers.
  std::vector<Extent> Gather(const Extent& extent) const;

  // The bytes of all processes, one after the other by their numbers: those for the process `rank`
  // there, nothing elsewhere.
  std::vector<char> GatherAt(int rank, const std::vector<char>& bytes) const;
  // The same in every process.
  std::vector<char> GatherEverywhere(const std::vector<char>& bytes) const;

private:
  void Reduce(double* numbers, vtkIdType count, int operation) const;

  vtkMultiProcessController* Controller = nullptr;
  int Rank = 0;
  int Size = 1;
};
}

#endif
