// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The OpenGL part of vtkDataSpaceProjectedTetrahedraMapper: buffers, textures and the program.

#ifndef ProjectedTetrahedraPainter_h
#define ProjectedTetrahedraPainter_h

#include "ProjectedTetrahedraTarget.h"

#include "vtkNew.h"
#include "vtkOpenGLHelper.h"
#include "vtkType.h"

#include <functional>
#include <string>
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
  virtual ~ProjectedTetrahedraPainter();

  // What is drawn from now on; uploaded with the next frame.
  void SetVertices(const TetrahedraVertices* vertices);
  void SetClassification(const DataSpaceClassification* classification);

  // indices: triangles, back to front. beforeDrawing: the program is bound, its uniforms are set.
  using ProgramCallback = std::function<void(vtkShaderProgram*)>;
  void Draw(vtkRenderer* renderer, vtkVolume* volume, const std::vector<unsigned int>& indices,
    const ProgramCallback& beforeDrawing);

  virtual void Release(vtkWindow* window);

protected:
  // How the colour of a fragment is found; the benchmark has other ways.
  virtual std::string GetFragmentShader() const;
  virtual void BindTextures(vtkShaderProgram* program);
  virtual void UnbindTextures();

  vtkOpenGLRenderWindow* Window = nullptr;

private:
  void Upload();
  void UploadTable();
  void UploadIsosurfaces();
  void MakeProgramReady();
  void BindVertices();
  void SetView(vtkRenderer* renderer, vtkVolume* volume);
  void SetModelToView(vtkMatrix4x4* worldToView, vtkMatrix4x4* volumeToWorld);
  void DrawTriangles(const std::vector<unsigned int>& indices);

  const TetrahedraVertices* Vertices = nullptr;
  const DataSpaceClassification* Classification = nullptr;
  bool AreVerticesUploaded = false;
  bool IsClassificationUploaded = false;
  bool IsMirrored = false;
  std::string FragmentShader; // of the program
  vtkOpenGLHelper Triangles;
  vtkNew<vtkOpenGLVertexBufferObject> Buffer;
  vtkNew<vtkTextureObject> Table;
  vtkNew<vtkTextureObject> Isosurfaces;
  ProjectedTetrahedraTarget Target;
};

#endif
