// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// What holds of the pixels of any scene, however strange, and of OpenGL after it.

#ifndef ScenePixels_h
#define ScenePixels_h

#include "vtk_glew.h"

#include <string>
#include <vector>

namespace
{
// What is wrong with RGBA of a float target; empty: nothing. A sample's radiance is at most a half float's
// largest, the shader's own bound; the sum of a ray's opacities is 1 but for its rounding.
inline std::string FaultOfPixels(const std::vector<float>& pixels, bool mayBeNegative = false)
{
  const float largest = 1.0001F * 65504.0F;
  const float least = mayBeNegative ? -largest : 0.0F;
  for (std::size_t i = 0; i < pixels.size(); ++i)
  {
    const bool isOpacity = i % 4 == 3;
    if (!(pixels[i] >= (isOpacity ? 0.0F : least) && pixels[i] <= (isOpacity ? 1.0001F : largest)))
    {
      return "pixel " + std::to_string(i / 4) + ": " + std::to_string(pixels[i]);
    }
  }
  return std::string();
}

// The first error that OpenGL remembers, which it forgets with all others.
inline std::string FaultOfOpenGL()
{
  const unsigned int first = glGetError();
  while (glGetError() != GL_NO_ERROR)
  {
  }
  return first == GL_NO_ERROR ? std::string() : "OpenGL error " + std::to_string(first);
}
}

#endif
