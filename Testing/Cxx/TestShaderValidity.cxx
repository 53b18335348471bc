// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The composed text of every combination of model, storage, gradient, lights and opacity, and of integral,
// silhouette, isosurfaces, components and model, passes the reference compiler of GLSL, which is stricter than
// a driver.

#include "ShaderText.h"
#include "SupportedSettings.h"
#include "TetrahedraScene.h"

#include "vtkAmbientCovarianceFilter.h"
#include "vtkLight.h"

#include <fstream>
#include <functional>
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

void Validate(Check& check, const std::string& name, const std::string& text)
{
  const std::string path = std::string(VOLUMEOPTICS_TEMPORARY) + "/Optics-" + name + ".frag";
  std::ofstream(path) << text;
  const std::string command = std::string(VOLUMEOPTICS_GLSLANG) + " " + path;
  check.That(!text.empty() && std::system(command.c_str()) == 0, name + ": " + path + " is not valid GLSL");
}

void ValidateScene(Check& check, const Choices& chosen)
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
  Validate(check, name, shader.Text);
}

// One of each list, in every combination.
void ValidateAll(Check& check, const std::vector<Choices>& lists, const Choices& chosen = {})
{
  if (chosen.size() == lists.size())
  {
    ValidateScene(check, chosen);
    return;
  }
  for (const Choice& choice : lists[chosen.size()])
  {
    Choices more = chosen;
    more.push_back(choice);
    ValidateAll(check, lists, more);
  }
}

// Every model under a lighting transfer function, by every way to its pair of scalars.
void ValidateLighting(Check& check)
{
  for (int model = vtkOpticsVolumeProperty::VTK; model <= vtkOpticsVolumeProperty::Lafortune; ++model)
  {
    for (int way = 0; way < 8; ++way)
    {
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
      Validate(check, name + std::to_string(way), shader.Text);
      check.That(shader.Text.find("in_opticsLightingTable") != std::string::npos, name + ": has no table");
    }
  }
}

// Projected tetrahedra: every silhouette, with and without isosurfaces.
void ValidateTetrahedra(Check& check)
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
      Validate(check, name + (surfaces ? "-Isosurfaces" : ""), shader.Text);
    }
  }
}
}

int TestShaderValidity(int, char*[])
{
  Check check;
  ValidateLighting(check);
  ValidateTetrahedra(check);
  ValidateAll(check, { Models, Storages, Gradients, Lights });
  ValidateAll(check, { Integrals, Silhouettes, Surfaces, ModelsOfIntegrals });
  ValidateAll(check, { Integrals, Surfaces, Components });
  return check.ExitCode();
}
