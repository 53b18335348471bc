// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Each row of docs/support.md that the integral supports: with short steps the pre-integrated picture in
// physical space is VTK's, whatever clips, crops, masks or moves the volume; in data space, with isosurfaces,
// silhouettes and highlights it must differ from that, and be finite.

#include "SupportedSettings.h"

namespace
{
bool IsRefused(const std::string& name)
{
  return name == "2D transfer function" || name == "label map";
}

// Root mean square in codes.
double Difference(const std::vector<unsigned char>& a, const std::vector<unsigned char>& b)
{
  double sum = a.size() == b.size() ? 0.0 : 1.0e9;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
  {
    sum += (double(a[i]) - b[i]) * (double(a[i]) - b[i]);
  }
  return std::sqrt(sum / std::max<std::size_t>(a.size(), 1));
}

// Smooth functions and short steps, so that VTK's sum is near the integral.
void MakeSmooth(TestScene& scene)
{
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(0.0, 0.0);
  scene.Opacity->AddPoint(1.0, 0.3);
  scene.Property->ShadeOff();
  scene.Mapper->SetSampleDistance(0.01F);
  scene.Window->SetSize(36, 36);
}

std::vector<unsigned char> DrawStock(const Row& row)
{
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> stock;
  TestScene scene(stock);
  MakeSmooth(scene);
  row.Apply(scene);
  return scene.Render();
}

void UseEverything(TestScene& scene)
{
  scene.Mapper->SetSampleDistance(0.03F);
  scene.Property->ShadeOn();
  scene.Property->SetIntegrationSpaceToData();
  scene.Property->AddIsosurface(0.6, 0.9, 0.2, 0.1, 0.8);
  scene.Property->AddIsosurface(0.3, 0.3);
  scene.Property->SetSilhouetteToExact();
  scene.Property->SetReflectanceModelToBlinnPhong();
}

void CheckRow(Check& check, const Row& row)
{
  const std::string name = row.Name;
  TestScene scene;
  MakeSmooth(scene);
  row.Apply(scene);
  Warnings warnings(scene.Optics);
  scene.Property->SetClassificationToPreIntegrated();
  const std::vector<unsigned char> stock = DrawStock(row);
  const double difference = Difference(stock, scene.Render());
  std::cout << name << ": " << difference << " codes from VTK's sum\n";
  // VTK's first sample counts for a step in front of it, its last one for what is behind the volume: a step of
  // 0.01 is a fifth of the unit distance, in which up to 0.3 is absorbed
  check.AtMost(name + ": codes from VTK's picture", difference, 2.0);
  check.That(scene.Optics->GetActiveTerms() == "Integration", name + ": the term is not active");

  UseEverything(scene);
  check.AtLeast(name + ": codes from VTK's picture in data space", Difference(stock, scene.Render()), 5.0);
  check.That(scene.Optics->GetActiveTerms() == "Reflectance,Integration", name + ": a term is not active");
  check.That(AreFinite(scene.RenderFloat()), name + ": a pixel is not finite");
  for (const std::string& text : warnings.Texts)
  {
    check.That(false, name + ": " + text);
  }
}
}

int TestIntegrationSettings(int, char*[])
{
  Check check;
  for (const Row& row : Rows)
  {
    if (!IsRefused(row.Name))
    {
      CheckRow(check, row);
    }
  }
  return check.ExitCode();
}
