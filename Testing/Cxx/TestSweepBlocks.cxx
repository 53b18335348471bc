// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Occlusion and shadows of a volume in partitions, which VTK loads one after the other: as of the whole volume, apart
// from what VTK's own picture of blocks differs by.

#include "ShadowScene.h"
#include "vtkVisibilitySweep.h"

#include "vtkPlane.h"

#include <functional>

namespace
{
using Change = std::function<void(ShadowScene&)>;

struct Setting
{
  const char* Name;
  Change Apply;
};

const Setting Settings[] = {
  { "sun", [](ShadowScene& s) { s.AddSun(1.0, 0.5, 1.5); } },
  { "lamp inside, soft",
    [](ShadowScene& s) {
      s.AddLamp(-0.6, 0.1, 0.7);
      s.Property->SetShadowAngle(10.0);
    } },
  { "occlusion",
    [](ShadowScene& s) {
      s.Property->ShadowsOff();
      s.Property->ShadeOff();
      s.Property->OcclusionOn();
      s.Optics->SetVisibilityGatherSamples(0); // a block alone does not show what is near a point
    } },
  { "cropping",
    [](ShadowScene& s) {
      s.AddSun(1.0, 0.5, 1.5);
      s.Mapper->SetCroppingRegionPlanes(-0.1, 0.6, -0.5, 0.5, -0.5, 0.1);
      s.Mapper->SetCroppingRegionFlags(0x7ffffff & ~(1 << 22));
      s.Mapper->CroppingOn();
    } },
  { "clipping plane",
    [](ShadowScene& s) {
      s.AddSun(1.0, 0.5, 1.5);
      vtkNew<vtkPlane> plane;
      plane->SetOrigin(0.1, 0.0, 0.0);
      plane->SetNormal(-1.0, 0.5, -0.25);
      s.Mapper->AddClippingPlane(plane);
    } },
  { "mask",
    [](ShadowScene& s) {
      s.AddSun(1.0, 0.5, 1.5);
      vtkNew<vtkImageData> mask;
      mask->CopyStructure(vtkImageData::SafeDownCast(s.Mapper->GetDataSetInput()));
      mask->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
      for (vtkIdType i = 0; i < mask->GetNumberOfPoints(); ++i)
      {
        const double* p = mask->GetPoint(i);
        static_cast<unsigned char*>(mask->GetScalarPointer())[i] = p[0] < 0.0 || p[2] < -0.3 ? 255 : 0;
      }
      s.Mapper->SetMaskInput(mask);
      s.Mapper->SetMaskTypeToBinary();
    } },
  { "data space",
    [](ShadowScene& s) {
      s.AddSun(1.0, 0.5, 1.5);
      s.Property->SetIntegrationSpaceToData();
      s.Property->SetScalarOpacityUnitInterval(0.2);
    } },
};

std::vector<float> Draw(const Setting& setting, bool isInBlocks, bool hidesLight)
{
  ShadowScene scene;
  scene.Optics->SetVisibilityGridSize(48);
  scene.Window->SetSize(40, 40);
  setting.Apply(scene);
  if (!hidesLight)
  {
    scene.Property->ShadowsOff();
    scene.Property->OcclusionOff();
  }
  if (isInBlocks)
  {
    scene.Optics->SetPartitions(2, 1, 2);
  }
  return scene.RenderFloat();
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

void Compare(Check& check, const Setting& setting)
{
  const std::vector<float> whole = Draw(setting, false, true);
  const std::vector<float> blocks = Draw(setting, true, true);
  const std::vector<float> litWhole = Draw(setting, false, false);
  const std::vector<float> litBlocks = Draw(setting, true, false);
  const double ofVTK = MeanDifference(litWhole, litBlocks);
  const double off = MeanDifference(whole, blocks);
  const double without = MeanDifference(litBlocks, blocks);
  std::cout << setting.Name << ": mean " << off << "/255, without sweeps " << ofVTK << ", the sweeps' effect "
            << without << "\n";
  check.That(AreFinite(blocks), std::string(setting.Name) + ": NaN");
  // at a block's face a ray begins anew, and does not know what it has met in the last half of a slice
  check.AtMost(setting.Name, off, ofVTK + 0.5);
  check.AtLeast(std::string(setting.Name) + ", the sweeps' effect", without, 8.0);
}

// One sweep a frame, whatever the number of blocks; and the whole volume's again when the partitions are gone.
void CheckCounts(Check& check)
{
  ShadowScene scene;
  scene.Optics->SetVisibilityGridSize(32);
  scene.Window->SetSize(30, 30);
  scene.AddSun(1.0, 0.0, 1.0);
  scene.Property->OcclusionOn();
  scene.Property->SetAmbient(0.5);
  scene.Optics->SetPartitions(2, 2, 1);
  const Warnings warnings(scene.Optics);
  scene.Render();
  const std::vector<unsigned char> first = scene.Render();
  const int eye = scene.Optics->GetOcclusionSweep()->GetSweepCount();
  const int lights = scene.Optics->GetShadowSweepCount();
  check.That(scene.Render() == first, "another frame differs");
  check.Near("sweeps from the eye", scene.Optics->GetOcclusionSweep()->GetSweepCount(), eye + 1, 0);
  check.Near("sweeps from the light", scene.Optics->GetShadowSweepCount(), lights + 1, 0);
  check.Near("messages", static_cast<double>(warnings.Texts.size()), 0.0, 0.0);
}
}

int TestSweepBlocks(int, char*[])
{
  Check check;
  for (const Setting& setting : Settings)
  {
    Compare(check, setting);
  }
  CheckCounts(check);
  return check.ExitCode();
}
