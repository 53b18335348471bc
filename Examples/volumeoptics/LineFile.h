// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Lines and anisotropic voxels of files. Errors are thrown as UserError.

#ifndef LineFile_h
#define LineFile_h

#include <vtkImageData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>

// Lines of .vtp or .vtk, whose cells name points that are there.
vtkSmartPointer<vtkPolyData> ReadLines(const std::string& path);

// Whether the file's ending is that of voxels, .vti.
bool IsVoxelFile(const std::string& path);
vtkSmartPointer<vtkImageData> ReadVoxels(const std::string& path);
void WriteVoxels(vtkImageData* voxels, const std::string& path);

#endif
