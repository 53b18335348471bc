// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Pieces of a volume that is cropped, masked or clipped, and gathered occlusion on pieces that know all that hides.

#include "PieceScenes.h"

#include "vtkPlane.h"

namespace
{
using Change = std::function<void(TestScene&)>;

const Choice Models[] = {
  { "no light", [](TestScene& scene) { scene.Property->ShadeOff(); } },
  { "Blinn-Phong", [](TestScene& scene) { scene.Property->SetReflectanceModelToBlinnPhong(); } },
  { "data space",
    [](TestScene& scene) {
      scene.Property->SetIntegrationSpaceToData();
      scene.Property->SetReflectanceModelToBlinnPhong();
      scene.Property->SetScalarOpacityUnitInterval(0.3);
    } },
};

// Planes that no face of a piece, and no point, is on.
void Crop(TestScene& scene)
{
  scene.Optics->CroppingOn();
  scene.Optics->SetCroppingRegionPlanes(-0.51, 0.3, -0.4, 0.52, -0.3, 0.6);
}

void Clip(TestScene& scene, double side)
{
  vtkNew<vtkPlane> plane;
  plane->SetNormal(0.3 * side, side, -0.4 * side);
  plane->SetOrigin(0.0, 0.2, 0.0);
  scene.Optics->AddClippingPlane(plane);
}

struct Row
{
  const char* Name;
  Change Apply;
};

// Of a model with something that cuts the volume.
Choice Join(const Choice& model, const Row& row)
{
  return { row.Name, [model, row](TestScene& scene) {
            model.Apply(scene);
            row.Apply(scene);
          } };
}

void TestWhereTheWholeIsCut(Check& check)
{
  const Row rows[] = {
    { "cropped",
      [](TestScene& scene) {
        Crop(scene);
        scene.Optics->SetCroppingRegionFlagsToSubVolume();
      } },
    { "cropped, fence",
      [](TestScene& scene) {
        Crop(scene);
        scene.Optics->SetCroppingRegionFlagsToFence();
      } },
  };
  for (const Row& row : rows)
  {
    for (const Choice& model : Models)
    {
      check.AtMost(std::string(row.Name) + ", " + model.Name, Compare(Join(model, row), Cut()), Rare);
    }
  }
}

// VTK counts samples from a plane, and places it by the piece's size: no more than its own pieces differ.
void TestClipped(Check& check)
{
  for (double side : { -1.0, 1.0 })
  {
    const Choice clipped = Join(Models[0], { "clipped", [side](TestScene& scene) { Clip(scene, side); } });
    const double stock = MeanDifference(clipped, Cut{ 0, true, false });
    check.AtMost("clipped, beside VTK's pieces", MeanDifference(clipped, Cut()), stock);
  }
}

// With all that hides in the ghost layers a piece's occlusion is the whole's.
void TestOcclusion(Check& check)
{
  const Choice occlusion = { "occlusion", [](TestScene& scene) {
                              scene.Source->SetFieldToVortexTubes(); // with gaps that rays go on behind
                              scene.Property->SetReflectanceModelToNone();
                              scene.Property->OcclusionOn();
                            } };
  check.AtMost("gathered occlusion", Compare(occlusion, Cut{ -32 }), Rare);
}

// Samples fall on the faces between pieces, to the rounding: each is in one piece, and all of them are drawn.
void TestSamplesOnFaces(Check& check)
{
  const Row halfVoxels = { "half voxels",
    [](TestScene& scene) { scene.Mapper->SetSampleDistance(1.0F / 31.0F); } };
  const auto lookAlongAxis = [](TestScene& scene) {
    scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
    scene.Renderer->GetActiveCamera()->SetPosition(0.0, -4.0, 0.0);
    scene.Renderer->ResetCameraClippingRange();
  };
  for (const Choice& model : Models)
  {
    const double share = Compare(Join(model, halfVoxels), Cut(), lookAlongAxis);
    check.AtMost(std::string("samples on faces, ") + model.Name, share, Rare);
  }
}
}

int TestPiecesCut(int, char*[])
{
  Check check;
  TestWhereTheWholeIsCut(check);
  TestClipped(check);
  TestOcclusion(check);
  TestSamplesOnFaces(check);
  return check.ExitCode();
}
