// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Streamlines of a flow in closed form that winds around a ring, on tori within each other.

#ifndef RingFlow_h
#define RingFlow_h

#include <vtkSmartPointer.h>
#include <vtkType.h>

class vtkPolyData;

// About so many segments, in lines of 200, traced by Runge and Kutta's rule of fourth order in
// [-1, 1]^2 x [-0.4, 0.4]. The cells' LineType is 1 for the lines in the middle, a tenth of all, and 0 for
// those in bands on the tori around them.
vtkSmartPointer<vtkPolyData> TraceRingFlow(vtkIdType segments);

#endif
