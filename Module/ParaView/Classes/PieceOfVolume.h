// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// What makes the picture of a process's piece the part of the whole volume's picture that it is.

#ifndef PieceOfVolume_h
#define PieceOfVolume_h

class vtkImageData;
class vtkOpticsVolumeMapper;
class vtkVolume;

/** Whether each process draws a piece of its own. */
bool DrawsPieces();

/** The pictures of several processes are composited in bytes, without saturation: where one is brighter than it is
 * opaque, which light on volumes may be, sums would pass 255 and begin at 0 again. */
void LimitLightToOpacity(vtkVolume* volume);

/** The distance of samples that VTK takes for the whole extent; its own follows the piece's. */
void TakeSampleDistanceOf(const int wholeExtent[6], vtkImageData* piece, vtkOpticsVolumeMapper* mapper);

/** Rays have their samples where those through the whole extent have them. A piece of null, or an empty extent:
 * as VTK, counted from where the ray enters what is drawn. */
void AlignSamples(const int wholeExtent[6], vtkImageData* piece, vtkVolume* volume);

#endif
