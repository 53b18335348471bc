// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// What the tests of distributed data share: MPI for a main(), a verdict of all processes.

#ifndef Processes_h
#define Processes_h

#include "vtkCommunicator.h"
#include "vtkMPIController.h"
#include "vtkNew.h"

#include <cstdlib>

namespace
{
class Processes
{
public:
  Processes(int& argc, char**& argv)
  {
    this->Controller->Initialize(&argc, &argv);
    vtkMultiProcessController::SetGlobalController(this->Controller);
  }
  ~Processes()
  {
    vtkMultiProcessController::SetGlobalController(nullptr);
    this->Controller->Finalize();
  }
  Processes(const Processes&) = delete;
  void operator=(const Processes&) = delete;

  int Rank() { return this->Controller->GetLocalProcessId(); }
  int Size() { return this->Controller->GetNumberOfProcesses(); }

  double Sum(double number)
  {
    double sum = 0.0;
    this->Controller->AllReduce(&number, &sum, 1, vtkCommunicator::SUM_OP);
    return sum;
  }
  // Failure if one process fails.
  int ExitCode(int own) { return this->Sum(own != EXIT_SUCCESS) > 0.0 ? EXIT_FAILURE : EXIT_SUCCESS; }

private:
  vtkNew<vtkMPIController> Controller;
};
}

#endif
