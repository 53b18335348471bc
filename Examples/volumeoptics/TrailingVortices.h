// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Streamlines of a flow in closed form: vortices that trail behind a wing, as in figure 5 of
// [Schussman2004].

#ifndef TrailingVortices_h
#define TrailingVortices_h

#include <vtkSmartPointer.h>
#include <vtkType.h>

class vtkPolyData;

// About so many segments, in lines of 200, traced by Runge and Kutta's rule of fourth order in
// [-1, 1] x [-0.6, 0.6]^2. The cells' LineType is 1 for lines along the cores, a tenth of all, and 0 for
// streamlines.
vtkSmartPointer<vtkPolyData> TraceTrailingVortices(vtkIdType segments);

#endif
