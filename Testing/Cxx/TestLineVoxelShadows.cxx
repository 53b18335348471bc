// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Shadows of lines on lines, against closed forms: a slab of lines under another, lit from above and seen from the side.
// Seen and lit across, a line hides as much of either.

#include "LineTermScene.h"

#include "Directions.h"
#include "Optics.h"
#include "vtkOpticsVolumeProperty.h"

namespace
{
const int Voxels = 12; // of edge 1
const double Ambient = 0.3;

// Of a voxel that is crossed along an edge, 1.5 times its mean chord, with .2 of its face covered.
const double Depth = 1.5 * optics::MeanDepthOfShare(0.2 / 1.5) / (TwoPi / 8.0);

// Lines along x, one in each voxel from side to side: two layers above, one below.
vtkSmartPointer<vtkPolyData> Slabs()
{
  std::vector<lines::Line> all;
  for (int y = 0; y < Voxels; ++y)
  {
    for (const int z : { 3, 8, 9 })
    {
      all.push_back({ { 0.0, y + 0.5, z + 0.5 }, { 1.0 * Voxels, y + 0.5, z + 0.5 } });
    }
  }
  return lines::MakeLines(all);
}

struct SlabScene
{
  explicit SlabScene(const std::vector<vtkSmartPointer<vtkLight>>& lights)
    : Drawn(VoxelsUnder(lights), 15)
  {
    for (const auto& light : lights)
    {
      this->Drawn.Renderer->AddLight(light);
    }
    this->Drawn.Renderer->SetAutomaticLightCreation(0);
    this->Drawn.Volume->SetProperty(this->Optics);
    this->Drawn.Mapper->SetSampleDistance(0.2F);
    this->Drawn.Mapper->SetVisibilityGridSize(48);
    this->Drawn.Camera->SetFocalPoint(6.0, 6.0, 3.5);
    this->Drawn.Camera->SetPosition(6.0, -30.0, 3.5);
    this->Drawn.Camera->SetParallelProjection(1);
    this->Drawn.Camera->SetParallelScale(3.0);
    this->Drawn.Camera->SetClippingRange(1.0, 60.0);
  }

  static vtkSmartPointer<vtkImageData> VoxelsUnder(const std::vector<vtkSmartPointer<vtkLight>>& lights)
  {
    vtkNew<vtkProperty> material;
    material->SetAmbient(Ambient);
    material->SetDiffuse(0.7);
    vtkNew<vtkLightCollection> collection;
    for (const auto& light : lights)
    {
      collection->AddItem(light);
    }
    vtkNew<vtkAnisotropicLineVoxelizer> voxelizer;
    voxelizer->SetInputData(Slabs());
    voxelizer->SetMaterial(0, material);
    voxelizer->SetLights(collection);
    voxelizer->SetSampleDimensions(Voxels, Voxels, Voxels);
    voxelizer->SetModelBounds(0.0, Voxels, 0.0, Voxels, 0.0, Voxels);
    voxelizer->SetRadius(0.1);
    voxelizer->SetMaximumOrder(8);
    return VoxelsOf(voxelizer);
  }

  // In the middle of the lower slab: colour times opacity, opacity.
  glm::dvec4 Middle()
  {
    const auto pixels = this->Drawn.RenderFloat();
    const float* pixel = &pixels[4 * (15 * 7 + 7)];
    return glm::dvec4(pixel[0], pixel[1], pixel[2], pixel[3]);
  }

  vtkNew<vtkOpticsVolumeProperty> Optics;
  LineTermScene Drawn;
};

double LitPart(const glm::dvec4& pixel)
{
  return pixel.x - Ambient * pixel.w;
}

// What of the light that is not ambient arrives, by pictures with shadows and without.
double Arriving(SlabScene& scene)
{
  scene.Optics->ShadowsOff();
  const glm::dvec4 lit = scene.Middle();
  scene.Optics->ShadowsOn();
  const glm::dvec4 shadowed = scene.Middle();
  const double share = LitPart(shadowed) / LitPart(lit);
  std::cout << "arriving: " << share << std::endl;
  return share;
}

// The middle of a layer lies behind half of it. A layer is spread over two voxels, linearly: where a slice of the sweep, a
// quarter of a voxel, is taken for the other side of the middle, a quarter of the layer's depth is; of this the interpolation
// between slices leaves a fifth.
const double Bound = 0.05 * Depth;

void CheckOneLight(Check& check)
{
  SlabScene scene({ lines::SceneLight({ 0.0, 0.0, 1.0 }) });
  lines::Messages messages(scene.Drawn.Mapper);
  check.AtLeast("light is seen", LitPart(scene.Middle()), 0.05);
  check.That(scene.Drawn.Mapper->GetFragmentShader().find("opticsShadow") == std::string::npos,
    "without shadows there is text of them");
  check.Near("under two layers and a half", Arriving(scene), std::exp(-2.5 * Depth), Bound);
  check.That(scene.Drawn.Mapper->GetActiveTerms() == "Lines,Shadows",
    "active: " + scene.Drawn.Mapper->GetActiveTerms());
  scene.Drawn.Mapper->SetLineRadiusScale(0, 2.0);
  check.Near("thicker lines", Arriving(scene), std::exp(-5.0 * Depth), Bound);
  check.That(messages.Texts.empty(), messages.Texts.empty() ? "" : "said: " + messages.Texts[0]);
}

// One from above, and one, a third as bright, from below.
void CheckTwoLights(Check& check)
{
  const auto above = lines::SceneLight({ 0.0, 0.0, 1.0 });
  const auto below = lines::SceneLight({ 0.0, 0.0, -1.0 });
  below->SetIntensity(1.0 / 3.0);
  SlabScene scene({ above, below });
  const double expected = 0.75 * std::exp(-2.5 * Depth) + 0.25 * std::exp(-0.5 * Depth);
  check.Near("two lights", Arriving(scene), expected, Bound);
  below->SetShadowAttenuation(0.0);
  check.Near("one casts no shadow", Arriving(scene), 0.75 * std::exp(-2.5 * Depth) + 0.25, Bound);
}

// Ambient light is occluded, and not shadowed.
void CheckOcclusion(Check& check)
{
  SlabScene scene({ lines::SceneLight({ 0.0, 0.0, 1.0 }) });
  scene.Optics->ShadowsOn();
  const glm::dvec4 shadowed = scene.Middle();
  scene.Optics->SetAmbientColor(0.5, 0.25, 0.0);
  const glm::dvec4 tinted = scene.Middle();
  const double missing[] = { 0.5, 0.75, 1.0 };
  for (int c = 0; c < 3; ++c)
  {
    check.Near("ambient colour", shadowed[c] - tinted[c], missing[c] * Ambient * shadowed.w, 1e-3);
  }
  scene.Optics->SetAmbientColor(1.0, 1.0, 1.0);
  scene.Optics->OcclusionOn();
  const glm::dvec4 occluded = scene.Middle();
  check.AtMost("occluded", occluded.x, shadowed.x - 0.01);
  check.AtLeast("the light that is not ambient stays", occluded.x, LitPart(shadowed) - 1e-3);
}
}

int TestLineVoxelShadows(int, char*[])
{
  Check check;
  CheckOneLight(check);
  CheckTwoLights(check);
  CheckOcclusion(check);
  return check.ExitCode();
}
