// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The OpenGL part of vtkDataSpaceProjectedTetrahedraMapper: buffers, textures and the program.

#ifndef ProjectedTetrahedraPainter_h
#define ProjectedTetrahedraPainter_h

#include "ProjectedTetrahedraTarget.h"

#include "vtkNew.h"
#include "vtkOpenGLHelper.h"
#include "vtkType.h"

#include <vector>

class DataSpaceClassification;
class TetrahedraVertices;
class vtkMatrix4x4;
class vtkOpenGLRenderWindow;
class vtkOpenGLVertexBufferObject;
class vtkRenderer;
class vtkShaderProgram;
class vtkTextureObject;
class vtkVolume;
class vtkWindow;

class ProjectedTetrahedraPainter
{
public:
  ProjectedTetrahedraPainter();
  ~ProjectedTetrahedraPainter();

  // What is drawn from now on; uploaded with the next frame.
  void SetVertices(const TetrahedraVertices* vertices);
  void SetClassification(const DataSpaceClassification* classification);

  // indices: triangles, back to front. Returns false where OpenGL has no room for it.
  bool Draw(vtkRenderer* renderer, vtkVolume* volume, const std::vector<unsigned int>& indices);

  vtkShaderProgram* GetProgram() const { return this->Triangles.Program; }
  void Release(vtkWindow* window);

private:
  void Upload();
  void UploadTable();
  void UploadIsosurfaces();
  void MakeProgramReady();
  void BindVertices();
  void SetView(vtkRenderer* renderer, vtkVolume* volume);
  void SetModelToView(vtkMatrix4x4* worldToView, vtkMatrix4x4* volumeToWorld);
  void SetTextures();

  const TetrahedraVertices* Vertices = nullptr;
  const DataSpaceClassification* Classification = nullptr;
  bool AreVerticesUploaded = false;
  bool IsClassificationUploaded = false;
  bool IsMirrored = false;
  vtkOpenGLRenderWindow* Window = nullptr;
  vtkOpenGLHelper Triangles;
  vtkNew<vtkOpenGLVertexBufferObject> Buffer;
  vtkNew<vtkTextureObject> Table;
  vtkNew<vtkTextureObject> Isosurfaces;
  ProjectedTetrahedraTarget Target;
};

#endif
