// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef OpticsScene_h
#define OpticsScene_h

class vtkDataArray;
class vtkOpenGLRenderWindow;
class vtkOpticsVolumeMapper;
class vtkOpticsVolumeProperty;
class vtkRenderer;
class vtkVolume;

/** What one frame is drawn with. */
struct OpticsScene
{
  vtkOpticsVolumeMapper* Mapper;
  vtkRenderer* Renderer;
  vtkVolume* Volume;
  vtkOpticsVolumeProperty* Optics;
  vtkOpenGLRenderWindow* Window;
  vtkDataArray* Scalars;
  bool CellScalars;
  int OpacityComponent; // the component of Scalars that opacity depends on
  bool FillsBlocks;     // nothing is drawn: each block of a volume in partitions is looked at, for sweeps
  int Block;            // of those that VTK draws one after the other
};

/**
 * Optics are the volume's own property, else the mapper's, else the default ones; null where there are
 * none. Scalars are null where there are none.
 */
OpticsScene MakeOpticsScene(vtkOpticsVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume);

#endif
