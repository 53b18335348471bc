// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// How the terms reach VTK's shader: a render pass in the volume's RenderPasses() key is called while
// the text is composed and in every draw, from the first frame on, and leaves the user's own
// vtkShaderProperty alone.

#ifndef vtkOpticsShaderPass_h
#define vtkOpticsShaderPass_h

#include "OpticsTerm.h"
#include "vtkOpenGLRenderPass.h"

#include <set>
#include <vector>

class vtkOpticsShaderPass : public vtkOpenGLRenderPass
{
public:
  static vtkOpticsShaderPass* New();
  vtkTypeMacro(vtkOpticsShaderPass, vtkOpenGLRenderPass);

  /** A new set of features makes the mapper compose its shader again. */
  void SetFeatures(const OpticsFeatures& features);

  /** Joins the passes of the volume, behind those that are there, until Detach(). */
  void Attach(const OpticsScene& scene, const std::vector<OpticsTerm*>& terms);
  void Detach();

  /** VTK has set everything that the terms' SetUniforms() could not see yet, and will draw next. */
  void BeforeDraw();

  /** Programs drawn with so far, each of which was linked once. */
  int GetProgramLinkCount() const { return static_cast<int>(this->Programs.size()); }

  /** The fragment shader composed last. */
  const std::string& GetFragmentShader() const { return this->FragmentShader; }

  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* vertexArray = nullptr) override;
  vtkMTimeType GetShaderStageMTime() override { return this->FeaturesTime.GetMTime(); }

protected:
  vtkOpticsShaderPass() = default;
  ~vtkOpticsShaderPass() override = default;
  void Render(const vtkRenderState*) override {}

private:
  vtkOpticsShaderPass(const vtkOpticsShaderPass&) = delete;
  void operator=(const vtkOpticsShaderPass&) = delete;

  void SayMissing(const std::string& text, const char* consequence);

  OpticsFeatures Features;
  vtkTimeStamp FeaturesTime;
  OpticsScene Scene = {};
  std::vector<OpticsTerm*> Terms;
  vtkShaderProgram* Program = nullptr; // of the frame that is being drawn
  std::set<std::string> Programs;
  std::string FragmentShader;
  bool IsInserted = true; // the terms, into the text composed last
};

#endif
