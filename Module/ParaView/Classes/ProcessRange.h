// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// A range of scalars that all processes agree on.

#ifndef ProcessRange_h
#define ProcessRange_h

class vtkDataArray;

/**
 * The finite values of an array's component on all processes, each of which must call it, also with nullptr.
 * (1, 0) if there are none.
 */
void FindRangeOfProcesses(vtkDataArray* scalars, int component, double range[2]);

/** Processes that share the data; 1 without MPI. */
int CountProcesses();

#endif
