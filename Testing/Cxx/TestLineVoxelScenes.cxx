// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// What lines in the mapper cost and say: nothing is linked or uploaded when the view or a scale changes, empty voxels take
// no memory, lights and settings that they do not have are said once. Extremes.

#include "LineTermScene.h"

#include "vtkActor.h"
#include "vtkLightCollection.h"
#include "vtkOpticsVolumeProperty.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPolyDataMapper.h"
#include "vtkSphereSource.h"

#include <limits>

namespace
{
double BrightnessOf(const std::vector<unsigned char>& pixels)
{
  double sum = 0.0;
  for (const unsigned char value : pixels)
  {
    sum += value;
  }
  return sum / std::max<std::size_t>(pixels.size(), 1);
}

// The voxels' arrays are emptied behind the mapper's back: what is drawn then was uploaded before.
void CheckChanges(Check& check)
{
  const auto voxels = Spirals(24, 24, 24);
  LineTermScene scene(voxels);
  auto last = scene.Render();
  check.AtLeast("the lines are bright", BrightnessOf(last), 1.0);
  check.That(scene.Mapper->GetActiveTerms() == "Lines", "active: " + scene.Mapper->GetActiveTerms());
  const int links = scene.Mapper->GetProgramLinkCount();
  auto* values = vtkFloatArray::SafeDownCast(voxels->GetFieldData()->GetArray("LineType0_Coefficients"));
  std::fill_n(values->GetPointer(0), values->GetNumberOfValues(), 0.0F);
  vtkNew<vtkPiecewiseFunction> function;
  function->AddPoint(0.0, 0.0);
  function->AddPoint(1.0, 0.5);
  const std::pair<const char*, std::function<void()>> changes[] = {
    { "camera", [&] { scene.Camera->Azimuth(30.0); } },
    { "radius scale", [&] { scene.Mapper->SetLineRadiusScale(0, 2.0); } },
    { "opacity scale", [&] { scene.Mapper->SetLineOpacityScale(0, 0.5); } },
    { "opacity function", [&] { scene.Mapper->SetLineOpacityFunction(function); } },
    { "a point of the opacity function", [&] { function->AddPoint(0.1, 0.4); } },
    { "volume", [&] { scene.Volume->RotateZ(30.0); } },
    { "sample distance", [&] { scene.Mapper->SetSampleDistance(0.1F); } },
  };
  for (const auto& [name, change] : changes)
  {
    change();
    const auto picture = scene.Render();
    check.That(picture != last, std::string(name) + " changes nothing");
    check.AtLeast(std::string(name) + ", brightness", BrightnessOf(picture), 0.5);
    last = picture;
  }
  check.Near("programs linked", scene.Mapper->GetProgramLinkCount(), links, 0.0);
  values->Modified();
  check.Near("new voxels are uploaded", BrightnessOf(scene.Render()), 0.0, 0.0);
}

void CheckMemory(Check& check)
{
  const auto small = Spirals(48, 48, 48, 4, false, 1000);
  const auto large = Spirals(48, 48, 48, 4, false, 20000);
  LineTermScene scene(small, 50);
  scene.Render();
  const auto memory = [&](vtkImageData* voxels) {
    scene.Mapper->SetInputData(voxels);
    scene.Render();
    return 1024.0 * static_cast<double>(scene.Mapper->GetTermMemorySize());
  };
  const double ofSmall = memory(small), ofLarge = memory(large);
  const double dense = 48.0 * 48.0 * 48.0 * 25.0 * 8.0;
  std::cout << "bytes: " << ofSmall << " and " << ofLarge << " of " << dense << std::endl;
  check.AtMost("of the dense coefficients", ofSmall, 0.1 * dense);
  // 8 bytes and the harmonic's number
  const double coefficients = static_cast<double>(lines::CountOf(small, "LineType0_Harmonics"));
  check.AtLeast("coefficients", ofSmall, 9.0 * coefficients);
  check.AtMost("grows with the occupied voxels", ofSmall, ofLarge);
  scene.Mapper->SetInputData(small);
  scene.Mapper->SetLinePrecision(32);
  scene.Render();
  check.AtLeast("32 bits", 1024.0 * static_cast<double>(scene.Mapper->GetTermMemorySize()), 1.4 * ofSmall);
  scene.Mapper->SetLinePrecision(8);
  scene.Render();
  // 4 bytes a coefficient less, 16 a voxel more
  const double saved =
    4.0 * coefficients - 16.0 * static_cast<double>(lines::CountOf(small, "LineType0_Places"));
  const double ofBytes = 1024.0 * static_cast<double>(scene.Mapper->GetTermMemorySize());
  check.Near("8 bits", ofSmall - ofBytes, saved, 0.1 * saved + 4096.0);
}

void CheckMessages(Check& check)
{
  const auto voxels = Spirals(16, 16, 16);
  LineTermScene scene(voxels, 50);
  lines::Messages messages(scene.Mapper);
  const auto plain = scene.Render();
  vtkNew<vtkOpticsVolumeProperty> optics;
  scene.Volume->SetProperty(optics);
  check.That(scene.Render() == plain, "the default property draws another picture");
  check.That(messages.Texts.empty(), "something is said of a plain scene");
  optics->ShadeOn();
  optics->SetReflectanceModelToWard();
  for (int i = 0; i < 3; ++i)
  {
    check.That(scene.Render() == plain, "a reflectance model changes the lines");
  }
  check.That(messages.Has("opacity and light of their own"), "a reflectance model is not refused once");
  messages.Texts.clear();
  optics->SetReflectanceModelToVTK();
  scene.Mapper->SetBlendModeToMaximumIntensity();
  scene.Render();
  check.Near("an unknown blend mode draws", BrightnessOf(scene.Render()), 0.0, 0.0);
  check.That(messages.Has("blend mode"), "a blend mode is not refused once");
  messages.Texts.clear();
  scene.Mapper->SetBlendModeToComposite();
  vtkNew<vtkLight> light;
  light->SetPosition(1.0, 0.0, 0.0);
  scene.Renderer->AddLight(light);
  scene.Render();
  check.That(scene.Render() == plain, "lights are not those baked in");
  check.That(messages.Has("SetLights()"), "other lights are not said once");
  messages.Texts.clear();
  vtkNew<vtkImageData> broken;
  broken->ShallowCopy(voxels);
  vtkNew<vtkFieldData> fields;
  fields->ShallowCopy(voxels->GetFieldData());
  fields->RemoveArray("LineType0_Places");
  broken->SetFieldData(fields);
  scene.Mapper->SetInputData(broken);
  scene.Render();
  check.Near("broken voxels", BrightnessOf(scene.Render()), 0.0, 0.0);
  check.That(messages.Has("do not fit each other"), "broken voxels are not said once");
  messages.Texts.clear();
  vtkNew<vtkFloatArray> wide;
  wide->SetName("LineType0_Coefficients");
  wide->SetNumberOfComponents(5);
  wide->SetNumberOfTuples(lines::CountOf(voxels, "LineType0_Coefficients"));
  wide->Fill(0.0);
  fields->ShallowCopy(voxels->GetFieldData());
  fields->AddArray(wide);
  broken->Modified();
  scene.Render();
  check.Near("voxels of another version", BrightnessOf(scene.Render()), 0.0, 0.0);
  check.That(messages.Has("5 components"), "coefficients of five components are not said once");
}

// Opaque things hide what is behind them, and stand out of what is before.
void CheckOpaque(Check& check)
{
  const auto voxels = Spirals(16, 16, 16);
  LineTermScene scene(voxels);
  scene.Camera->SetPosition(0.0, -4.0, 0.0);
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkActor> actor;
  mapper->SetInputConnection(sphere->GetOutputPort());
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(0.0, 0.0, 1.0);
  scene.Renderer->AddActor(actor);
  const auto redOf = [&](double y) {
    actor->SetPosition(0.0, y, 0.0);
    return scene.RenderFloat()[4 * (50 * 100 + 50)];
  };
  const double before = redOf(-2.0), amid = redOf(0.0), behind = redOf(2.0);
  check.Near("before the lines", before, 0.0, 0.0);
  check.AtLeast("amid", amid, 0.01);
  check.AtLeast("behind", behind, 1.5 * amid);
}

// Depth peeling casts the ray in parts: a sphere that is hardly there changes the picture by as much.
void CheckDepthPeeling(Check& check)
{
  const auto voxels = Spirals(16, 16, 16);
  LineTermScene scene(voxels);
  const auto plain = scene.Render();
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkActor> actor;
  mapper->SetInputConnection(sphere->GetOutputPort());
  actor->SetMapper(mapper);
  actor->GetProperty()->SetOpacity(0.004);
  scene.Renderer->AddActor(actor);
  scene.Renderer->UseDepthPeelingOn();
  scene.Renderer->UseDepthPeelingForVolumesOn();
  const auto peeled = scene.Render();
  double largest = 0.0, sum = 0.0;
  for (std::size_t i = 0; i < plain.size(); ++i)
  {
    largest = std::max(largest, std::abs(double(plain[i]) - peeled[i]));
    sum += std::abs(double(plain[i]) - peeled[i]);
  }
  // a part of the ray begins at its own first sample: a step more or less at each of the sphere's two sides
  check.AtMost("peeled, largest", largest, 20.0);
  check.AtMost("peeled, mean", sum / static_cast<double>(plain.size()), 0.2);
}

// Grids of one voxel and of many on one axis, orders, coefficients that are not numbers, no lines at all.
void CheckExtremes(Check& check)
{
  vtkNew<vtkAnisotropicLineVoxelizer> voxelizer;
  voxelizer->SetInputData(lines::MakeLines({ { { 0.5, 0.5, 0.1 }, { 0.5, 0.5, 0.9 } } }));
  lines::SetUnitVoxel(voxelizer);
  voxelizer->SetRadius(0.2);
  const auto one = VoxelsOf(voxelizer);
  LineTermScene scene(one, 50);
  scene.Camera->ParallelProjectionOn();
  scene.Camera->SetParallelScale(0.4);
  scene.Camera->SetPosition(0.5, -5.0, 0.5);
  scene.Camera->SetFocalPoint(0.5, 0.5, 0.5);
  scene.Mapper->SetSampleDistance(0.01F);
  const auto middle = scene.RenderFloat();
  // through a voxel of depth tau per 2/3 of its edge
  const double depth = lines::Look(one, glm::dvec3(0.0, -1.0, 0.0)).Depth * 1.5;
  check.Near("one voxel", middle[4 * (25 * 50 + 25) + 3], 1.0 - std::exp(-depth), 0.01);

  const auto bar = Spirals(1024, 64, 64, 0, false, 4000, 0.0009);
  scene.Mapper->SetInputData(bar);
  check.AtLeast("1024 x 64 x 64", BrightnessOf(scene.Render()), 1.0);

  const auto broken = Spirals(16, 16, 16);
  auto* values = vtkFloatArray::SafeDownCast(broken->GetFieldData()->GetArray("LineType0_Coefficients"));
  for (vtkIdType i = 0; i < values->GetNumberOfValues(); i += 37)
  {
    const float odd[] = { std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
      3e38F };
    values->SetValue(i, odd[i % 3]);
  }
  scene.Mapper->SetInputData(broken);
  for (int bits : { 16, 32 })
  {
    scene.Mapper->SetLinePrecision(bits);
    for (const float value : scene.RenderFloat())
    {
      check.Finite("a picture of coefficients that are no numbers", value);
    }
  }

  voxelizer->SetInputData(lines::MakeLines({}));
  const auto none = VoxelsOf(voxelizer);
  scene.Mapper->SetInputData(none);
  check.Near("no lines", BrightnessOf(scene.Render()), 0.0, 0.0);
}

// Ambient colour tints all of the light; lines in front of others darken them, the more the wider the cone; and more opaque
// ones darken more.
void CheckOcclusion(Check& check)
{
  const auto voxels = Spirals(24, 24, 24);
  LineTermScene scene(voxels);
  lines::Messages messages(scene.Mapper);
  vtkNew<vtkOpticsVolumeProperty> optics;
  scene.Volume->SetProperty(optics);
  const auto plain = scene.RenderFloat();
  optics->SetAmbientColor(0.5, 0.25, 1.0);
  const auto tinted = scene.RenderFloat();
  const double tints[] = { 0.5, 0.25, 1.0, 1.0 };
  for (std::size_t i = 0; i < plain.size(); ++i)
  {
    check.Near("tinted", tinted[i], tints[i % 4] * plain[i], 1e-6);
  }
  optics->SetAmbientColor(1.0, 1.0, 1.0);
  optics->OcclusionOn();
  optics->SetOcclusionAngle(0.0);
  const auto narrow = scene.RenderFloat();
  for (std::size_t i = 0; i < plain.size(); ++i)
  {
    check.AtMost("occluded", narrow[i], plain[i] + 1e-6);
  }
  check.That(scene.Mapper->GetActiveTerms().find("Occlusion") != std::string::npos, "no occlusion");
  const auto sumOf = [](const std::vector<float>& pixels) {
    double sum = 0.0;
    for (std::size_t i = 0; i < pixels.size(); ++i)
    {
      sum += i % 4 == 3 ? 0.0 : pixels[i];
    }
    return sum;
  };
  // along the ray alone, of optical depth t, the mean of what arrives is (1 - e^-2t)/2 of (1 - e^-t)
  double expected = 0.0;
  for (std::size_t i = 0; i < plain.size(); i += 4)
  {
    const double through = 1.0 - plain[i + 3];
    const double share = plain[i + 3] > 0.0F ? 0.5 * (1.0 - through * through) / plain[i + 3] : 1.0;
    expected += share * (plain[i] + plain[i + 1] + plain[i + 2]);
  }
  check.Near("a narrow cone", sumOf(narrow) / expected, 1.0, 0.05);
  scene.Mapper->SetLineOpacityScale(0, 0.3);
  const auto thin = scene.RenderFloat();
  optics->OcclusionOff();
  const double thinShare = sumOf(thin) / sumOf(scene.RenderFloat());
  check.AtLeast("thin lines occlude less", thinShare, sumOf(narrow) / sumOf(plain) + 0.05);
  check.That(messages.Texts.empty(), messages.Texts.empty() ? "" : "said: " + messages.Texts[0]);
}

double MeanDifference(const std::vector<float>& a, const std::vector<float>& b)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    sum += std::abs(a[i] - b[i]);
  }
  return 255.0 * sum / static_cast<double>(a.size());
}

// Lines whose bricks VTK loads in blocks: the same picture, also where they hide light from each other. The step is a
// voxel's, as that of the rays.
void CheckPartitions(Check& check)
{
  const auto voxels = Spirals(16, 16, 16);
  const auto draw = [&](bool isInBlocks, bool isOccluded, bool isShadowed) {
    LineTermScene scene(voxels, 60);
    vtkNew<vtkOpticsVolumeProperty> optics;
    optics->SetOcclusion(isOccluded);
    optics->SetShadows(isShadowed);
    scene.Volume->SetProperty(optics);
    scene.Mapper->LockSampleDistanceToInputSpacingOn();
    scene.Mapper->SetPartitions(isInBlocks ? 2 : 1, 1, isInBlocks ? 2 : 1);
    return scene.RenderFloat();
  };
  const auto plain = draw(true, false, false);
  const double ofVTK = MeanDifference(plain, draw(false, false, false));
  check.AtMost("blocks", ofVTK, 0.5); // bounds as in TestSweepBlocks
  for (const bool isOccluded : { true, false })
  {
    const std::string name = isOccluded ? "occlusion" : "shadows";
    const auto hidden = draw(true, isOccluded, !isOccluded);
    const double off = MeanDifference(hidden, draw(false, isOccluded, !isOccluded));
    check.AtMost(name + " in blocks", off, ofVTK + 0.5);
    check.AtLeast(name + ", effect", MeanDifference(hidden, plain), 1.0); // 1.6 and 1.5
  }
}

// The step of an automatic or locked sample distance is a voxel's, not a brick's.
void CheckSampleDistance(Check& check)
{
  const auto voxels = Spirals(32, 32, 32);
  LineTermScene scene(voxels);
  scene.Mapper->SetSampleDistance(2.0F / 32.0F);
  const auto byVoxel = scene.Render();
  scene.Mapper->SetAutoAdjustSampleDistances(1);
  scene.Volume->SetAllocatedRenderTime(1.0e6, scene.Renderer);
  const auto automatic = scene.Render();
  check.That(automatic == byVoxel, "the automatic step is another one than a voxel");
  check.That(scene.Mapper->GetAutoAdjustSampleDistances() == 1, "the mapper's setting is lost");
  scene.Mapper->SetQualityToBalanced();
  const auto preset = scene.Render();
  scene.Mapper->SetQualityToCustom();
  scene.Mapper->SetAutoAdjustSampleDistances(0);
  scene.Mapper->SetSampleDistance(1.0F / 32.0F);
  check.That(scene.Render() == preset, "Balanced is another step than half a voxel");
}
}

int TestLineVoxelScenes(int, char*[])
{
  Check check;
  CheckChanges(check);
  CheckMemory(check);
  CheckMessages(check);
  CheckOpaque(check);
  CheckDepthPeeling(check);
  CheckExtremes(check);
  CheckOcclusion(check);
  CheckPartitions(check);
  CheckSampleDistance(check);
  return check.ExitCode();
}
