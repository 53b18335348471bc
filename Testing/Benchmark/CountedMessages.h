// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The bytes that this process hands to MPI, counted between the program and the library by MPI's own
// profiling names. Include it in one file of a program, which then has MPI's functions in its own name.

#ifndef CountedMessages_h
#define CountedMessages_h

#include <mpi.h>

namespace
{
long long MessageBytes = 0;

void CountMessage(int count, MPI_Datatype type)
{
  int size = 0;
  PMPI_Type_size(type, &size);
  MessageBytes += static_cast<long long>(count) * size;
}
}

extern "C"
{
  int MPI_Send(const void* data, int count, MPI_Datatype type, int to, int tag, MPI_Comm comm)
  {
    CountMessage(count, type);
    return PMPI_Send(data, count, type, to, tag, comm);
  }
  int MPI_Allreduce(
    const void* data, void* result, int count, MPI_Datatype type, MPI_Op operation, MPI_Comm comm)
  {
    CountMessage(count, type);
    return PMPI_Allreduce(data, result, count, type, operation, comm);
  }
  int MPI_Gather(const void* data, int count, MPI_Datatype type, void* result, int counts,
    MPI_Datatype resultType, int root, MPI_Comm comm)
  {
    CountMessage(count, type);
    return PMPI_Gather(data, count, type, result, counts, resultType, root, comm);
  }
  int MPI_Gatherv(const void* data, int count, MPI_Datatype type, void* result, const int counts[],
    const int offsets[], MPI_Datatype resultType, int root, MPI_Comm comm)
  {
    CountMessage(count, type);
    return PMPI_Gatherv(data, count, type, result, counts, offsets, resultType, root, comm);
  }
  int MPI_Allgather(const void* data, int count, MPI_Datatype type, void* result, int counts,
    MPI_Datatype resultType, MPI_Comm comm)
  {
    CountMessage(count, type);
    return PMPI_Allgather(data, count, type, result, counts, resultType, comm);
  }
  int MPI_Allgatherv(const void* data, int count, MPI_Datatype type, void* result, const int counts[],
    const int offsets[], MPI_Datatype resultType, MPI_Comm comm)
  {
    CountMessage(count, type);
    return PMPI_Allgatherv(data, count, type, result, counts, offsets, resultType, comm);
  }
}

#endif
