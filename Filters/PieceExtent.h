// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Pieces of an image: a request by number, with the extent that a source answers it with as it likes, as
// distributed programs make it, in place of a request by extent.

#ifndef PieceExtent_h
#define PieceExtent_h

#include "ImageGrid.h"

class vtkImageData;
class vtkInformation;

namespace volumeoptics
{
/** Whether the request is for one of several pieces. */
bool IsPiece(vtkInformation* output);

/** The image's extent without its layers of ghost cells; empty if it has no others. */
Extent OwnExtent(vtkImageData* image);

/** The part of the output's grid for a part of the input, such that parts that touch go on touching. */
Extent OutputExtent(const ImageGrid& grid, const Extent& input);

/** Layers of ghost cells of the input for so many of the output and a reach around them, both in its voxels. */
int GhostLayersOfInput(const ImageGrid& grid, int layers, int reach);

/** The grid of what lies within a part of the input, as if this were the whole. */
ImageGrid Restricted(const ImageGrid& grid, const Extent& input);
}

#endif
