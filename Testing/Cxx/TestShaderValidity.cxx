// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The composed text of combinations of model, storage, gradient, lights and opacity, and of integral,
// silhouette, isosurfaces, components and model, and of lines, passes the reference compiler of GLSL, which is stricter than
// a driver.

#include "LineTermScene.h"
#include "ShaderText.h"
#include "SupportedSettings.h"
#include "TetrahedraScene.h"

#include "vtkAmbientCovarianceFilter.h"
#include "vtkVisibilitySweep.h"
#include "vtkLight.h"

#include <fstream>
#include <functional>
#include <set>
#include <vector>

namespace
{
struct Choice
{
  const char* Name;
  std::function<void(TestScene&)> Apply;
};

using Choices = std::vector<Choice>;

const Choices Models = {
  { "None", [](TestScene& scene) { scene.Property->SetReflectanceModelToNone(); } },
  { "BlinnPhong", [](TestScene& scene) { scene.Property->SetReflectanceModelToBlinnPhong(); } },
  { "Ward", [](TestScene& scene) { scene.Property->SetReflectanceModelToWard(); } },
  { "Lafortune", [](TestScene& scene) { scene.Property->SetReflectanceModelToLafortune(); } },
};

const Choices Storages = {
  { "Map", [](TestScene& scene) { scene.Optics->GetAmbientCovarianceFilter()->SetStorageToMap(); } },
  { "Components",
    [](TestScene& scene) { scene.Optics->GetAmbientCovarianceFilter()->SetStorageToComponents(); } },
  { "World", [](TestScene& scene) { scene.Optics->GetAmbientCovarianceFilter()->SetStorageToWorld(); } },
};

const Choices Gradients = {
  { "Stored", [](TestScene& scene) { scene.Optics->SetExtinctionGradientToStored(); } },
  { "Central", [](TestScene& scene) { scene.Optics->SetExtinctionGradientToCentralDifferences(); } },
  { "GradientOpacity",
    [](TestScene& scene) {
      vtkNew<vtkPiecewiseFunction> function;
      function->AddPoint(0.0, 0.5);
      function->AddPoint(0.3, 1.0);
      scene.Property->SetGradientOpacity(function);
    } },
};

const Choices Lights = {
  { "headlight", [](TestScene&) {} },
  { "positional",
    [](TestScene& scene) {
      vtkNew<vtkLight> light;
      light->SetPositional(true);
      scene.Renderer->AddLight(light);
    } },
  { "none", [](TestScene& scene) { scene.Renderer->SetAutomaticLightCreation(false); } },
};

const Choices Integrals = {
  { "DataPost", [](TestScene& scene) { scene.Property->SetIntegrationSpaceToData(); } },
  { "DataPre",
    [](TestScene& scene) {
      scene.Property->SetIntegrationSpaceToData();
      scene.Property->SetClassificationToPreIntegrated();
    } },
  { "PhysicalPre", [](TestScene& scene) { scene.Property->SetClassificationToPreIntegrated(); } },
};

const Choices Silhouettes = {
  { "Off", [](TestScene&) {} },
  { "Exact", [](TestScene& scene) { scene.Property->SetSilhouetteToExact(); } },
  { "Clamped",
    [](TestScene& scene) {
      scene.Property->SetSilhouetteToClamped();
      scene.Optics->SetScalarGradientToStored();
    } },
};

const Choices Surfaces = {
  { "Smooth", [](TestScene&) {} },
  { "Transmitted", [](TestScene& scene) { scene.Property->SetTransmittedLightToDiffuse(); } },
  { "Isosurfaces",
    [](TestScene& scene) {
      scene.Property->AddIsosurface(0.5, 0.5);
      scene.Mapper->SetCropping(1);
    } },
};

const Choices Components = {
  { "1", [](TestScene&) {} },
  { "2", [](TestScene& scene) { UseDependentComponents(scene, 2); } },
  { "4", [](TestScene& scene) { UseDependentComponents(scene, 4); } },
};

const Choices ModelsOfIntegrals = {
  { "Stock", [](TestScene&) {} },
  { "Ward", [](TestScene& scene) { scene.Property->SetReflectanceModelToWard(); } },
  { "BlinnPhongCentral",
    [](TestScene& scene) {
      scene.Property->SetReflectanceModelToBlinnPhong();
      scene.Optics->SetExtinctionGradientToCentralDifferences();
    } },
};

// Texts of shaders in files, which one run of the compiler checks.
class Validation
{
public:
  void Add(Check& check, const std::string& name, const std::string& text)
  {
    const std::string path = std::string(VOLUMEOPTICS_TEMPORARY) + "/Optics-" + name + ".frag";
    std::ofstream(path) << text;
    check.That(!text.empty(), name + ": has no text");
    check.That(this->Paths.insert(path).second, name + ": is checked twice");
  }

  void Run(Check& check) const
  {
    std::string command = VOLUMEOPTICS_GLSLANG;
    for (const std::string& path : this->Paths)
    {
      command += " " + path;
    }
    check.That(std::system(command.c_str()) == 0, "a shader named above is not valid GLSL");
  }

private:
  std::set<std::string> Paths;
};

void ValidateScene(Check& check, Validation& validation, const Choices& chosen)
{
  TestScene scene;
  scene.Window->SetSize(8, 8);
  scene.Source->SetDimensions(8, 8, 8);
  const ShaderText shader(scene.Mapper);
  std::string name;
  for (const Choice& choice : chosen)
  {
    choice.Apply(scene);
    name += (name.empty() ? "" : "-") + std::string(choice.Name);
  }
  scene.Render();
  scene.Render();
  validation.Add(check, name, shader.Text);
}

// One of each list, in every combination of all lists but the last, whose place follows from theirs: so that
// each combination of all lists but any one is there, too.
void ValidateAll(Check& check, Validation& validation, const std::vector<Choices>& lists,
  const Choices& chosen = {}, std::size_t places = 0)
{
  const Choices& list = lists[chosen.size()];
  const bool isLast = chosen.size() + 1 == lists.size();
  for (std::size_t i = 0; i < list.size(); ++i)
  {
    Choices more = chosen;
    more.push_back(list[i]);
    if (!isLast)
    {
      ValidateAll(check, validation, lists, more, places + i);
    }
    else if (i == places % list.size())
    {
      ValidateScene(check, validation, more);
    }
  }
}

// Every model under a lighting transfer function, by every way to its pair of scalars; half of them each.
void ValidateLighting(Check& check, Validation& validation)
{
  for (int model = vtkOpticsVolumeProperty::VTK; model <= vtkOpticsVolumeProperty::Lafortune; ++model)
  {
    for (int half = 0; half < 4; ++half)
    {
      const int way = 2 * half + (half + half / 2 + model) % 2; // any two of its bits in every combination
      TestScene scene;
      scene.Window->SetSize(8, 8);
      scene.Source->SetDimensions(8, 8, 8);
      const ShaderText shader(scene.Mapper);
      LightEverywhere(scene, 1.0, 1.0, 1.0);
      scene.Property->SetReflectanceModel(model);
      scene.Optics->SetScalarGradient(way % 2);
      scene.Optics->SetLightingSamples(way / 2 % 2);
      scene.Property->SetHybridNormals(way / 4 == 1);
      scene.Render();
      scene.Render();
      const std::string name = std::string("Lighting-") + scene.Property->GetReflectanceModelAsString();
      validation.Add(check, name + std::to_string(way), shader.Text);
      check.That(shader.Text.find("in_opticsLightingTable") != std::string::npos, name + ": has no table");
    }
  }
}

// Occlusion on each kind of opacity, with and without Shade: the ray's text and the sweep's own.
void ValidateOcclusion(Check& check, Validation& validation)
{
  Choices kinds = Gradients;
  kinds.insert(kinds.end(), Integrals.begin(), Integrals.end());
  for (const Row& row : Rows)
  {
    for (const char* name :
      { "cropping", "clipping planes", "2D transfer function", "binary mask", "label map" })
    {
      if (row.Name == std::string(name))
      {
        kinds.push_back({ row.Name, row.Apply });
      }
    }
  }
  for (std::size_t i = 0; i < kinds.size(); ++i)
  {
    TestScene scene;
    scene.Window->SetSize(8, 8);
    scene.Source->SetDimensions(8, 8, 8);
    const ShaderText shader(scene.Mapper);
    kinds[i].Apply(scene);
    scene.Property->OcclusionOn();
    scene.Property->SetShade(i % 2 == 0);
    scene.Optics->SetVisibilitySamples(4 << (i % 3));
    scene.Optics->SetVisibilityAlgorithm(i % 4 == 3 ? 1 : 0);
    if (scene.Property->GetIntegrationSpace() == vtkOpticsVolumeProperty::Data)
    {
      scene.Property->AddIsosurface(0.5, 0.5);
    }
    scene.Render();
    scene.Render();
    const std::string name = "Occlusion-" + std::to_string(i);
    validation.Add(check, name, shader.Text);
    validation.Add(check, name + "-sweep", scene.Optics->GetOcclusionSweep()->GetFragmentShader());
  }
}

// Lines, with and without a block, cropped and not.
void ValidateLines(Check& check, Validation& validation)
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
void ValidateTetrahedra(Check& check, Validation& validation)
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
  Validation validation;
  ValidateLighting(check, validation);
  ValidateOcclusion(check, validation);
  ValidateLines(check, validation);
  ValidateTetrahedra(check, validation);
  ValidateAll(check, validation, { Models, Storages, Gradients, Lights });
  ValidateAll(check, validation, { Integrals, Silhouettes, Surfaces, ModelsOfIntegrals });
  ValidateAll(check, validation, { Integrals, Surfaces, Components });
  validation.Run(check);
  return check.ExitCode();
}
