// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The renderer's lights as uniforms, in eye space.

#ifndef LightUniforms_h
#define LightUniforms_h

#include <vector>

class vtkLight;
class vtkRenderer;
class vtkShaderProgram;

/**
 * VTK 9.1's volume mapper copies the lights that are switched on into arrays of six, on its stack,
 * without counting. While this lives, those beyond are switched off.
 */
class LightLimit
{
public:
  static constexpr int Largest = 6;

  explicit LightLimit(vtkRenderer* renderer);
  ~LightLimit();
  int GetNumberOfLightsLeftOut() const { return static_cast<int>(this->LeftOut.size()); }

private:
  LightLimit(const LightLimit&) = delete;
  void operator=(const LightLimit&) = delete;

  std::vector<vtkLight*> LeftOut;
};

/** In the order of the uniforms. */
std::vector<vtkLight*> LightsThatAreOn(vtkRenderer* renderer);

int CountLights(vtkRenderer* renderer);

/** Of each light its share of the luminous intensity of all; even where that is 0. */
std::vector<float> SharesOfLights(vtkRenderer* renderer);

bool HasPositionalLight(vtkRenderer* renderer);

void SetLightUniforms(vtkRenderer* renderer, vtkShaderProgram* program);

#endif
