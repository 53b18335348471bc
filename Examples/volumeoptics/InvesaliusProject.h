// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The matrix of an InVesalius project (.inv3): a gzip tar with main.plist and matrix.dat.

#ifndef InvesaliusProject_h
#define InvesaliusProject_h

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <string>

vtkSmartPointer<vtkImageData> ReadInvesaliusProject(const std::string& path);

#endif
