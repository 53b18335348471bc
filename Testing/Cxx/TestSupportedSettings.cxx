// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Each row of docs/support.md that the reflectance term, or, with the argument --lighting, a lighting
// transfer function supports. With the ambient coefficient 1 and
// the others 0 a sample's radiance is its colour: the picture must be VTK's without shading, whatever
// clips, crops, masks or moves the volume. With highlights it must differ from that, and be finite.

#include "SupportedSettings.h"

namespace
{
// The same picture without light and with all of the colour.
std::vector<unsigned char> DrawUnshaded(const Row& row, int size)
{
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> stock;
  TestScene scene(stock);
  scene.Window->SetSize(size, size);
  row.Apply(scene);
  scene.Property->ShadeOff();
  return scene.Render();
}

using Light = void (*)(TestScene&, double specular);

void LightByModel(TestScene& scene, double specular)
{
  scene.Property->SetReflectanceModelToWard();
  scene.Property->SetAmbient(1.0);
  scene.Property->SetDiffuse(0.0);
  scene.Property->SetSpecular(specular);
}

void LightByFunction(TestScene& scene, double specular)
{
  LightEverywhere(scene, 1.0, 0.0, specular);
}

void CheckRow(Check& check, const Row& row, Light light, int size)
{
  const std::string name = row.Name;
  TestScene scene;
  scene.Window->SetSize(size, size);
  row.Apply(scene);
  Warnings warnings(scene.Optics);
  light(scene, 0.0);
  const std::vector<unsigned char> unshaded = DrawUnshaded(row, size);
  const int difference = LargestDifference(unshaded, scene.Render());
  // one code for the order of float operations
  check.That(difference <= 1, name + ": differs from the unshaded picture by " + std::to_string(difference));
  const char* terms = light == LightByModel ? "Reflectance" : "Reflectance,LightingTransferFunction";
  check.That(scene.Optics->GetActiveTerms() == terms, name + ": a term is not active");

  light(scene, 1.0);
  const int highlight = LargestDifference(unshaded, scene.Render());
  check.That(highlight > 10, name + ": the highlight is of " + std::to_string(highlight) + " codes only");
  check.That(AreFinite(scene.RenderFloat()), name + ": a pixel is not finite");
  const int replacements = scene.Volume->GetShaderProperty()->GetNumberOfShaderReplacements();
  check.That(replacements == (name == "shader property" ? 1 : 0), name + ": replacements are added");
  for (const std::string& text : warnings.Texts)
  {
    check.That(false, name + ": " + text);
  }
}

// A turn by the image's direction matrix is a turn by the volume's user matrix, highlights included.
void CheckDirectionMatrix(Check& check)
{
  TestScene byImage, byVolume;
  UseDirectionMatrix(byImage);
  UseRotation(byVolume);
  for (TestScene* scene : { &byImage, &byVolume })
  {
    scene->Property->SetReflectanceModelToWard();
    scene->Property->SetSpecular(1.0);
    scene->Optics->SetFramePrecision(32); // 8 bits along other axes round otherwise
  }
  const int difference = LargestDifference(byImage.Render(), byVolume.Render());
  check.That(
    difference <= 1, "direction matrix: differs from a user matrix by " + std::to_string(difference));
}

struct Images
{
  vtkNew<vtkImageData> Colour, Depth;

  explicit Images(TestScene& scene)
  {
    scene.Mapper->SetRenderToImage(1);
    scene.Window->Render();
    scene.Mapper->GetColorImage(this->Colour);
    scene.Mapper->GetDepthImage(this->Depth);
  }
  static std::vector<unsigned char> Bytes(vtkImageData* image)
  {
    const auto* first = static_cast<const unsigned char*>(image->GetScalarPointer());
    return { first,
      first + image->GetNumberOfPoints() * image->GetNumberOfScalarComponents() * image->GetScalarSize() };
  }
};

// RenderToImage: without a model VTK's images; with one VTK's depth, and highlights in the colour.
void CheckRenderToImage(Check& check)
{
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> mapper;
  TestScene reference(mapper), plain, unlit, shiny;
  unlit.Property->SetReflectanceModelToNone();
  shiny.Property->SetReflectanceModelToWard();
  shiny.Property->SetSpecular(1.0);
  const Images stock(reference), off(plain), none(unlit), ward(shiny);
  check.That(!Images::Bytes(stock.Colour).empty(), "render to image: VTK gives none");
  check.That(Images::Bytes(stock.Colour) == Images::Bytes(off.Colour), "render to image: colour off");
  check.That(Images::Bytes(stock.Depth) == Images::Bytes(off.Depth), "render to image: depth off");
  check.That(Images::Bytes(stock.Depth) == Images::Bytes(ward.Depth), "render to image: depth");
  const int highlight = LargestDifference(Images::Bytes(none.Colour), Images::Bytes(ward.Colour));
  check.That(highlight > 10, "render to image: the highlight is of " + std::to_string(highlight) + " codes");
}
}

int TestSupportedSettings(int argc, char* argv[])
{
  Check check;
  const bool isLighting =
    std::any_of(argv, argv + argc, [](char* word) { return std::string(word) == "--lighting"; });
  const int size = isLighting ? 48 : 150; // Ward's highlights are small
  for (const Row& row : Rows)
  {
    CheckRow(check, row, isLighting ? LightByFunction : LightByModel, size);
  }
  if (isLighting)
  {
    return check.ExitCode();
  }
  CheckDirectionMatrix(check);
  CheckRenderToImage(check);
  return check.ExitCode();
}
