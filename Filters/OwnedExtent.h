// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// What of an image's piece is the piece's own.

#ifndef OwnedExtent_h
#define OwnedExtent_h

#include "ImageGrid.h"

class vtkImageData;

namespace volumeoptics
{
// The extent of the points of all cells that are no ghosts (vtkDataSetAttributes::DUPLICATECELL); of the
// points that are none, where only these are marked.
Extent OwnedExtent(vtkImageData* image);
}

#endif
