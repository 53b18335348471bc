// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// What makes the picture of a process's piece the part of the whole volume's picture that it is.

#ifndef PieceOfVolume_h
#define PieceOfVolume_h

#include "vtkBoundingBox.h"
#include "vtkSmartPointer.h"

class vtkImageData;
class vtkOpticsVolumeMapper;
class vtkPartitionedDataSet;

/** Whether each process draws a piece of its own. */
bool DrawsPieces();

/** A piece with its ghost layers, which nothing marks as such, and the extent of its own as field data. */
vtkSmartPointer<vtkImageData> KeepGhostLayers(vtkImageData* image);

/** The same of each image among blocks, and the bounds of all without ghost layers. */
vtkBoundingBox KeepGhostLayersOfBlocks(vtkPartitionedDataSet* blocks);

/** Draws what is the piece's own, with the samples of the whole extent; where that is empty, with VTK's. */
void DrawAsPiece(vtkImageData* piece, const int wholeExtent[6], vtkOpticsVolumeMapper* mapper);

#endif
