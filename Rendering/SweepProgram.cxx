// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SweepProgram.h"

#include "SweepDirections.h"
#include "SweepDisk.h"
#include "SweepFill.h"
#include "SweepMain.h"
#include "SweepVertex.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShader.h"
#include "vtkShaderProgram.h"
#include "vtk_glew.h"

#include <algorithm>

namespace
{
// How the values of a type are read, and set again.
struct UniformType
{
  unsigned int Type;
  int Numbers;
  bool IsFloat;
  void (*Set)(int location, const void* numbers);
};

const float* Floats(const void* numbers)
{
  return static_cast<const float*>(numbers);
}

const int* Integers(const void* numbers)
{
  return static_cast<const int*>(numbers);
}

const UniformType UniformTypes[] = {
  { GL_FLOAT, 1, true, [](int at, const void* n) { glUniform1fv(at, 1, Floats(n)); } },
  { GL_FLOAT_VEC2, 2, true, [](int at, const void* n) { glUniform2fv(at, 1, Floats(n)); } },
  { GL_FLOAT_VEC3, 3, true, [](int at, const void* n) { glUniform3fv(at, 1, Floats(n)); } },
  { GL_FLOAT_VEC4, 4, true, [](int at, const void* n) { glUniform4fv(at, 1, Floats(n)); } },
  { GL_FLOAT_MAT3, 9, true, [](int at, const void* n) { glUniformMatrix3fv(at, 1, GL_FALSE, Floats(n)); } },
  { GL_FLOAT_MAT4, 16, true, [](int at, const void* n) { glUniformMatrix4fv(at, 1, GL_FALSE, Floats(n)); } },
  { GL_INT_VEC2, 2, false, [](int at, const void* n) { glUniform2iv(at, 1, Integers(n)); } },
  { GL_INT_VEC3, 3, false, [](int at, const void* n) { glUniform3iv(at, 1, Integers(n)); } },
  { GL_INT_VEC4, 4, false, [](int at, const void* n) { glUniform4iv(at, 1, Integers(n)); } },
};

// Samplers, integers and booleans are an int each.
const UniformType IntegerType = { GL_INT, 1, false,
  [](int at, const void* n) { glUniform1iv(at, 1, Integers(n)); } };

const UniformType& TypeOf(unsigned int type)
{
  const UniformType* end = std::end(UniformTypes);
  const UniformType* found = std::find_if(
    std::begin(UniformTypes), end, [type](const UniformType& known) { return known.Type == type; });
  return found == end ? IntegerType : *found;
}

// One number or vector of an array, or all there is.
void CopyUniform(
  const UniformType& type, const std::string& name, int from, int to, std::vector<char>& values)
{
  const int source = glGetUniformLocation(from, name.c_str());
  const int target = glGetUniformLocation(to, name.c_str());
  if (source < 0 || target < 0)
  {
    return;
  }
  float floats[16] = {};
  int integers[16] = {};
  type.IsFloat ? glGetUniformfv(from, source, floats) : glGetUniformiv(from, source, integers);
  const void* numbers = type.IsFloat ? static_cast<const void*>(floats) : integers;
  type.Set(target, numbers);
  const char* bytes = static_cast<const char*>(numbers);
  values.insert(values.end(), bytes, bytes + 4 * type.Numbers);
}

// An array is listed by its first element.
void CopyUniformArray(int index, int from, int to, std::vector<char>& values)
{
  char text[256] = {};
  int count = 0;
  unsigned int glType = 0;
  glGetActiveUniform(to, index, sizeof(text), nullptr, &count, &glType, text);
  std::string name = text;
  name = name.substr(0, name.find('['));
  const UniformType& type = TypeOf(glType);
  for (int i = 0; i < count; ++i)
  {
    CopyUniform(type, count > 1 ? name + "[" + std::to_string(i) + "]" : text, from, to, values);
  }
}

// The ray's own outputs become variables that nobody looks at.
void ReplaceOutputs(std::string& text)
{
  vtkShaderProgram::Substitute(text, "out vec4 fragOutput", "vec4 g_sweepUnusedOutput");
  vtkShaderProgram::Substitute(text, "fragOutput", "g_sweepUnusedOutput");
}
}

//------------------------------------------------------------------------------
std::string SweepFragmentShader(const std::string& ray, const SweepProgram::Kind& kind)
{
  std::string text = ray.substr(0, ray.rfind("void main("));
  ReplaceOutputs(text);
  const std::size_t behindVersion = text.find('\n', text.find("#version")) + 1;
  text.insert(behindVersion,
    "#define OPTICS_SWEEP\n#define OPTICS_SWEEP_DIRECTIONS " + std::to_string(kind.Directions) + "\n" +
      (kind.IsToViewer ? "#define OPTICS_SWEEP_TO_VIEWER\n" : "") +
      (kind.HasGeometry ? "#define OPTICS_SWEEP_GEOMETRY\n" : "") +
      (kind.IsAboutEye ? "#define OPTICS_SWEEP_ABOUT_EYE\n" : "") +
      (kind.IsByDirection ? "#define OPTICS_SWEEP_BY_DIRECTION\n" : "") +
      (kind.IsOfBlocks ? "#define OPTICS_SWEEP_OF_BLOCKS\n" : ""));
  const char* sweep = kind.IsDisk ? SweepDisk : SweepDirections;
  return text + (kind.FillsBlock ? SweepFill : sweep) + SweepMain;
}

//------------------------------------------------------------------------------
vtkShaderProgram* SweepProgram::Use(vtkOpenGLRenderWindow* window, vtkShaderProgram* ray, const Kind& kind)
{
  vtkOpenGLShaderCache* cache = window->GetShaderCache();
  if (this->Program && this->RayHash == ray->GetMD5Hash() && this->CurrentKind == kind)
  {
    cache->ReadyShaderProgram(this->Program);
  }
  else
  {
    const std::string fragment = SweepFragmentShader(ray->GetFragmentShader()->GetSource(), kind);
    this->Program = cache->ReadyShaderProgram(SweepVertex, fragment.c_str(), "");
    this->RayHash = ray->GetMD5Hash();
    this->CurrentKind = kind;
    ++this->LinkCount;
  }
  if (this->Program)
  {
    this->CopyUniforms(ray);
  }
  return this->Program;
}

//------------------------------------------------------------------------------
void SweepProgram::CopyUniforms(vtkShaderProgram* ray)
{
  const int to = this->Program->GetHandle();
  int uniforms = 0;
  glGetProgramiv(to, GL_ACTIVE_UNIFORMS, &uniforms);
  this->Values.clear();
  for (int i = 0; i < uniforms; ++i)
  {
    CopyUniformArray(i, ray->GetHandle(), to, this->Values);
  }
}

//------------------------------------------------------------------------------
std::string SweepProgram::GetFragmentShader() const
{
  return this->Program ? this->Program->GetFragmentShader()->GetSource() : std::string();
}

//------------------------------------------------------------------------------
void SweepProgram::Release()
{
  this->Program = nullptr;
  this->RayHash.clear();
}
