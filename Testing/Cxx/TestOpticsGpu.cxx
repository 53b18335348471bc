// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Every formula in a fragment shader, on a float target, against the C++ double: the GPU computes what
// the CPU tests have shown right, with no NaN or Inf on the way.

#include "TestedFunctions.h"

#include "vtkNew.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPixelBufferObject.h"
#include "vtkRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"

#include <fstream>
#include <memory>
#include <sstream>

namespace
{
// A case a pixel, five texels an input.
constexpr unsigned Width = 256;
constexpr unsigned TexelsOfInput = 5;

// GL_BLEND, GL_DEPTH_TEST, GL_SCISSOR_TEST: the header that has them is another one in each VTK.
constexpr unsigned Blend = 0x0BE2;
constexpr unsigned DepthTest = 0x0B71;
constexpr unsigned ScissorTest = 0x0C11;

std::string ReadText(const std::string& path)
{
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string FragmentShader()
{
  const std::string optics = VOLUMEOPTICS_OPTICS_FOLDER "/";
  std::string text = "//VTK::System::Dec\n//VTK::Output::Dec\n";
  for (const char* file : { "PhaseFunction", "Opacity", "DataSpace", "AnisotropyFrame", "Reflectance",
         "SoftRange", "MultiSampleRule", "HybridNormal", "SphericalHarmonics", "CylinderLighting",
         "Visibility", "LineVoxel" })
  {
    text += ReadText(optics + file + ".glsl");
  }
  text += ReadText(VOLUMEOPTICS_TESTS_FOLDER "/OpticsTable.glsl");
  return text + R"(
in vec2 texCoord; // VTK's vertex shader for a quad
uniform sampler2D inputs;

vec4 Texel(int i)
{
  ivec2 pixel = ivec2(texCoord * vec2(textureSize(inputs, 0) / ivec2(1, 5)));
  return texelFetch(inputs, ivec2(pixel.x, 5 * pixel.y + i), 0);
}

void main()
{
  vec4 first = Texel(0);
  FunctionInput i;
  i.normal = first.xyz;
  i.toLight = Texel(1).xyz;
  i.toViewer = Texel(2).xyz;
  i.major = Texel(3).xyz;
  i.p = Texel(4).xyz;
  gl_FragData[0] = Evaluate(int(first.w), i);
}
)";
}

std::vector<glm::vec4> Pack(const std::vector<FunctionCase>& cases, unsigned height)
{
  std::vector<glm::vec4> texels(Width * height * TexelsOfInput, glm::vec4(0.0f, 0.0f, 1.0f, 0.0f));
  for (std::size_t i = 0; i < cases.size(); ++i)
  {
    const FunctionCase& c = cases[i];
    glm::vec4* texel = &texels[i / Width * TexelsOfInput * Width + i % Width];
    texel[0] = glm::vec4(c.Normal, float(c.Function));
    texel[Width] = glm::vec4(c.ToLight, 0.0f);
    texel[2 * Width] = glm::vec4(c.ToViewer, 0.0f);
    texel[3 * Width] = glm::vec4(c.Major, 0.0f);
    texel[4 * Width] = glm::vec4(c.P, 0.0f);
  }
  return texels;
}

vtkSmartPointer<vtkTextureObject> NewTexture(vtkOpenGLRenderWindow* window)
{
  auto texture = vtkSmartPointer<vtkTextureObject>::New();
  texture->SetContext(window);
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  return texture;
}

std::vector<glm::vec4> Download(vtkTextureObject* texture, unsigned height)
{
  std::vector<glm::vec4> values(Width * height);
  auto pixels = vtkSmartPointer<vtkPixelBufferObject>::Take(texture->Download());
  unsigned dims[2] = { Width, height };
  vtkIdType increments[2] = { 0, 0 };
  pixels->Download2D(VTK_FLOAT, values.data(), dims, 4, increments);
  return values;
}

std::vector<glm::vec4> Evaluate(vtkOpenGLRenderWindow* window, const std::vector<FunctionCase>& cases)
{
  const unsigned height = unsigned(cases.size() + Width - 1) / Width;
  std::vector<glm::vec4> texels = Pack(cases, height);
  auto inputs = NewTexture(window);
  inputs->Create2DFromRaw(Width, height * TexelsOfInput, 4, VTK_FLOAT, texels.data());
  auto results = NewTexture(window);
  results->Allocate2D(Width, height, 4, VTK_FLOAT);

  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  vtkNew<vtkOpenGLFramebufferObject> target;
  target->SetContext(window);
  target->Bind();
  target->AddColorAttachment(0, results);
  target->ActivateDrawBuffer(0);
  target->StartNonOrtho(Width, int(height));
  state->vtkglViewport(0, 0, Width, int(height));
  for (unsigned capability : { Blend, DepthTest, ScissorTest })
  {
    state->SetEnumState(capability, false);
  }

  const std::string fragment = FragmentShader();
  auto quad = std::make_unique<vtkOpenGLQuadHelper>(window, nullptr, fragment.c_str(), nullptr);
  inputs->Activate();
  quad->Program->SetUniformi("inputs", inputs->GetTextureUnit());
  quad->Render();
  inputs->Deactivate();
  quad.reset();
  state->PopFramebufferBindings();
  return Download(results, height);
}
}

int TestOpticsGpu(int, char*[])
{
  vtkNew<vtkRenderWindow> window;
  window->SetShowWindow(false);
  window->SetSize(64, 64);
  window->Render();
  auto* context = vtkOpenGLRenderWindow::SafeDownCast(window);
  Check check;
  if (!context)
  {
    check.AtLeast("OpenGL window", 0.0, 1.0);
    return check.ExitCode();
  }
  const std::vector<FunctionCase> cases = CasesOfFunctions().Cases;
  const std::vector<glm::vec4> values = Evaluate(context, cases);
  Comparison comparison;
  for (std::size_t i = 0; i < cases.size(); ++i)
  {
    comparison.Add(check, cases[i], glm::dvec4(values[i]), &TestedFunction::GpuUnits);
  }
  comparison.Print(check, &TestedFunction::GpuUnits);
  return check.ExitCode();
}
