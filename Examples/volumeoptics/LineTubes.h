// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Lines as tubes, drawn at ten times the resolution and averaged: what anisotropic voxels are compared with,
// as in figure 4 of [Schussman2004].

#ifndef LineTubes_h
#define LineTubes_h

#include "FramePicture.h"
#include "LineScene.h"

class vtkPolyData;

// Prisms as wide as the cylinders in the mean over all directions across them.
vtkSmartPointer<vtkPolyData> MakeTubes(vtkPolyData* lines, double radius, int sides);

struct TubeFrame
{
  FramePicture Frame;
  double Seconds = 0.0; // of the large frame, the tubes being there
};

// Tubes in place of what the scene shows, with its camera and lights, for its window's size; their material
// is that of the lines. The scene is empty then.
TubeFrame DrawTubes(vtkPolyData* lines, const LineSettings& settings, VolumeScene& scene, int sides = 16);

#endif
