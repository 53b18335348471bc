// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The shader program of a visibility sweep, made of the ray caster's own: its text with OPTICS_SWEEP defined
// and another main(), its uniforms, its textures. So the sweep meets what the rays meet, whatever VTK, the
// other terms and the user's own replacements have written into the text.

#ifndef SweepProgram_h
#define SweepProgram_h

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;

class SweepProgram
{
public:
  static constexpr int LargestNumberOfDirections = 16;

  struct Kind
  {
    int Directions;
    bool IsDisk;        // [Schott2009]'s recursion
    bool IsToViewer;    // directions meet at the viewer
    bool HasGeometry;   // opaque, beside the volume
    bool IsAboutEye;    // the cone's axis is the direction to the viewer
    bool IsByDirection; // what is left of each direction is kept, not of their mean
    bool FillsBlock;    // finds the opacity of froxels in one block of the volume
    bool IsOfBlocks;    // takes what was found in all blocks

    bool operator==(const Kind& other) const
    {
      return this->Directions == other.Directions && this->IsDisk == other.IsDisk &&
        this->IsToViewer == other.IsToViewer && this->HasGeometry == other.HasGeometry &&
        this->IsAboutEye == other.IsAboutEye && this->IsByDirection == other.IsByDirection &&
        this->FillsBlock == other.FillsBlock && this->IsOfBlocks == other.IsOfBlocks;
    }
  };

  /**
   * Links the program, if it is another one than before, and makes it the current one, with the ray's values
   * of all uniforms that both have. Null where it does not link.
   */
  vtkShaderProgram* Use(vtkOpenGLRenderWindow* window, vtkShaderProgram* ray, const Kind& kind);

  /** The values that were copied last, one after the other. */
  const std::vector<char>& GetValues() const { return this->Values; }

  /** As OpenGL gets it; empty before the first one. */
  std::string GetFragmentShader() const;

  int GetLinkCount() const { return this->LinkCount; }
  void Release();

private:
  void CopyUniforms(vtkShaderProgram* ray);

  vtkSmartPointer<vtkShaderProgram> Program;
  std::string RayHash;
  Kind CurrentKind = {};
  std::vector<char> Values;
  int LinkCount = 0;
};

/** The sweep's fragment shader, from the ray's as OpenGL gets it. */
std::string SweepFragmentShader(const std::string& ray, const SweepProgram::Kind& kind);

#endif
