// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The composed text of lines and of tetrahedra passes the reference compiler of GLSL; TestCombinations has that of the
// other terms.

#include "LineTermScene.h"
#include "ShaderText.h"
#include "ShaderValidation.h"
#include "TetrahedraScene.h"

namespace
{
// Lines, with and without a block, cropped and not.
void ValidateLines(Check& check, ShaderValidation& validation)
{
  const auto voxels = Spirals(8, 8, 8, 0, false, 100);
  for (int settings = 0; settings < 4; ++settings)
  {
    LineTermScene scene(voxels, 8);
    const ShaderText shader(scene.Mapper);
    scene.Mapper->SetLineBlockInputData(settings % 2 == 1 ? voxels.GetPointer() : nullptr);
    scene.Mapper->SetCropping(settings / 2);
    scene.Render();
    scene.Render();
    validation.Add(check, "Lines-" + std::to_string(settings), shader.Text);
  }
}

// Projected tetrahedra: every silhouette, with and without isosurfaces.
void ValidateTetrahedra(Check& check, ShaderValidation& validation)
{
  Grid grid = MakeBox(1, [](double, double, double z) { return z; });
  for (int silhouette = 0; silhouette < 4; ++silhouette)
  {
    for (int surfaces = 0; surfaces < 2; ++surfaces)
    {
      TetrahedraScene scene(TetrahedraScene::Projected, grid, 8);
      const ShaderText shader(scene.Tetrahedra);
      scene.Property->SetSilhouette(silhouette);
      for (int i = 0; i < surfaces; ++i)
      {
        scene.Property->AddIsosurface(0.5, 1.0, 1.0, 1.0, 0.5);
      }
      scene.Render();
      const std::string name = std::string("Tetrahedra-") + scene.Property->GetSilhouetteAsString();
      validation.Add(check, name + (surfaces ? "-Isosurfaces" : ""), shader.Text);
    }
  }
}
}

int TestShaderValidity(int, char*[])
{
  Check check;
  ShaderValidation validation;
  ValidateLines(check, validation);
  ValidateTetrahedra(check, validation);
  validation.Run(check);
  return check.ExitCode();
}
