// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// One optical model as a part of the ray caster's shader: which features it asks for in a scene,
// the textures it owns, and its uniforms. A parameter that changes the source changes the features;
// every other one is a uniform.

#ifndef OpticsTerm_h
#define OpticsTerm_h

#include "OpticsScene.h"
#include "OpticsShaderTable.h"

#include <string>

class vtkShaderProgram;
class vtkWindow;

class OpticsTerm
{
public:
  virtual ~OpticsTerm() = default;

  virtual const char* GetName() const = 0;

  /**
   * Whether the scene asks for the term and the term can serve it. What it cannot serve it says
   * through OpticsScene::Mapper, once.
   */
  virtual bool IsActive(const OpticsScene& scene) = 0;

  /** Brings preprocessing up to date. False: the term has nothing to draw with, as it has said. */
  virtual bool Prepare(const OpticsScene& scene) = 0;

  /** Adds the features that the prepared scene needs. */
  virtual void AddFeatures(const OpticsScene& scene, OpticsFeatures& features) = 0;

  /** Binds textures and sets every uniform: programs are shared between mappers. */
  virtual void SetUniforms(const OpticsScene& scene, vtkShaderProgram* program) = 0;

  /**
   * After VTK has set every uniform and bound every texture of the volume, or of a block of it, and before
   * it draws it. What is drawn here must leave OpenGL as it was found.
   */
  virtual void BeforeDraw(const OpticsScene&, vtkShaderProgram*) {}

  /** Gives back the texture units that SetUniforms() and BeforeDraw() took. */
  virtual void UnbindTextures() = 0;

  virtual void ReleaseGraphicsResources(vtkWindow* window) = 0;

  /** Bytes of textures. */
  virtual std::size_t GetMemorySize() const = 0;
};

#endif
