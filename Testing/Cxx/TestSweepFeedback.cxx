// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// No texture is read while it is drawn on, which OpenGL leaves undefined: a look at what is bound, each time that the
// last sampler of a sweep has been set, which is the last thing before a slice is drawn.

#include "ShadowScene.h"

#include "vtk_glew.h"

#include <set>

namespace
{
PFNGLUNIFORM1IPROC SetInteger = nullptr;
int Looks = 0;
int Loops = 0;

// Of the framebuffer that is drawn on.
std::set<int> WrittenTextures()
{
  std::set<int> textures;
  int framebuffer = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
  for (unsigned int i = 0; framebuffer != 0 && i < 5; ++i)
  {
    int type = GL_NONE;
    int name = 0;
    glGetFramebufferAttachmentParameteriv(
      GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0 + i, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &type);
    if (type == GL_TEXTURE)
    {
      glGetFramebufferAttachmentParameteriv(
        GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0 + i, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME, &name);
      textures.insert(name);
    }
  }
  return textures;
}

// That a sampler of the program would read; 0 for what is no sampler.
int ReadTexture(int program, int uniform)
{
  char text[256] = {};
  int size = 0;
  unsigned int type = 0;
  glGetActiveUniform(program, uniform, sizeof(text), nullptr, &size, &type, text);
  if (type != GL_SAMPLER_2D && type != GL_SAMPLER_3D)
  {
    return 0;
  }
  int unit = 0;
  int before = 0;
  int texture = 0;
  glGetUniformiv(program, glGetUniformLocation(program, text), &unit);
  glGetIntegerv(GL_ACTIVE_TEXTURE, &before);
  glActiveTexture(GL_TEXTURE0 + unit);
  glGetIntegerv(type == GL_SAMPLER_2D ? GL_TEXTURE_BINDING_2D : GL_TEXTURE_BINDING_3D, &texture);
  glActiveTexture(before);
  return texture;
}

void Look(int program)
{
  const std::set<int> written = WrittenTextures();
  int uniforms = 0;
  glGetProgramiv(program, GL_ACTIVE_UNIFORMS, &uniforms);
  for (int i = 0; i < uniforms; ++i)
  {
    const int texture = ReadTexture(program, i);
    Loops += texture != 0 && written.count(texture) > 0 ? 1 : 0;
  }
  ++Looks;
}

// -1 of a program that is no sweep's.
int LastSampler(int program)
{
  int last = -1;
  for (const char* name : { "in_sweepPassed0", "in_sweepPassed1", "in_sweepPassed2", "in_sweepPassed3" })
  {
    const int location = glGetUniformLocation(program, name);
    last = location >= 0 ? location : last;
  }
  return last;
}

void GLAPIENTRY SetIntegerAndLook(int location, int value)
{
  SetInteger(location, value);
  int program = 0;
  glGetIntegerv(GL_CURRENT_PROGRAM, &program);
  if (program != 0 && location >= 0 && location == LastSampler(program))
  {
    Look(program);
  }
}
}

int TestSweepFeedback(int, char*[])
{
  Check check;
  ShadowScene scene;
  scene.Optics->SetVisibilityGridSize(24);
  scene.Property->OcclusionOn();
  scene.Property->SetAmbient(0.5);
  scene.AddSun(1.0, 0.0, 1.0);
  scene.AddLamp(0.0, 0.0, 0.8);
  scene.Window->Render(); // loads OpenGL's functions
  SetInteger = glUniform1i;
  glUniform1i = SetIntegerAndLook;
  for (const int samples : { 4, 8, 16 })
  {
    scene.Optics->SetVisibilitySamples(samples);
    scene.Property->SetShadowAngle(samples == 4 ? 0.0 : 10.0);
    scene.Window->Render();
  }
  glUniform1i = SetInteger;
  check.AtLeast("looks at slices", Looks, 250);
  check.Near("textures that are read and drawn on", Loops, 0, 0);
  return check.ExitCode();
}
