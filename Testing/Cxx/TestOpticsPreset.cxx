// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Presets: every setting is read, in any order; what is wrong is named once, with the valid choice.

#include "Check.h"

#include "vtkNew.h"
#include "vtkOpticsPreset.h"
#include "vtkOpticsVolumeProperty.h"
#include "vtkOutputWindow.h"
#include "vtkSmartPointer.h"
#include "vtkStringOutputWindow.h"
#include "vtkTestUtilities.h"

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <memory>
#include <string>

namespace
{
Check check;

struct Result
{
  bool IsRead = false;
  vtkSmartPointer<vtkOpticsVolumeProperty> Property = vtkSmartPointer<vtkOpticsVolumeProperty>::New();
  std::string Warnings;
};

// modelBefore: of the property that is read into
Result ReadFile(const std::string& fileName, int modelBefore = vtkOpticsVolumeProperty::VTK)
{
  vtkSmartPointer<vtkOutputWindow> usual = vtkOutputWindow::GetInstance();
  vtkNew<vtkStringOutputWindow> captured;
  vtkOutputWindow::SetInstance(captured);
  Result result;
  result.Property->SetReflectanceModel(modelBefore);
  result.IsRead = vtkOpticsPreset::Read(fileName.c_str(), result.Property);
  vtkOutputWindow::SetInstance(usual);
  result.Warnings = captured->GetOutput();
  return result;
}

Result ReadText(const std::string& fileName, const std::string& text)
{
  std::ofstream(fileName) << text;
  return ReadFile(fileName);
}

void CheckWarning(const Result& result, const std::string& about, const std::string& valid)
{
  const std::size_t first = result.Warnings.find("Warning");
  check.That(first != std::string::npos && result.Warnings.find("Warning", first + 1) == std::string::npos,
    "one warning about " + about);
  check.That(result.Warnings.find(about) != std::string::npos, "the warning names " + about);
  check.That(
    result.Warnings.find(valid) != std::string::npos, "the warning about " + about + " says " + valid);
}

void CheckIntegration(const std::string& file)
{
  Result all = ReadText(file,
    R"({ "IntegrationSpace": "Data", "Classification": "PreIntegrated", "ScalarOpacityUnitInterval": 2.5,
         "Isosurfaces": [ { "Value": 300, "Opacity": 0.5, "Color": [0.25, 0.5, 1] },
                          { "Opacity": 0.125, "Value": -10 } ],
         "Silhouette": "Clamped", "TransmittedLight": "DiffuseAndSpecular" })");
  vtkOpticsVolumeProperty* property = all.Property;
  check.That(all.Warnings.empty() && all.IsRead, "every setting of the integral is read: " + all.Warnings);
  check.That(property->GetIntegrationSpace() == vtkOpticsVolumeProperty::Data, "space");
  check.That(property->GetClassification() == vtkOpticsVolumeProperty::PreIntegrated, "classification");
  check.That(property->GetScalarOpacityUnitInterval() == 2.5, "unit interval");
  check.That(property->GetSilhouette() == vtkOpticsVolumeProperty::Clamped, "silhouette");
  check.That(
    property->GetTransmittedLight() == vtkOpticsVolumeProperty::DiffuseAndSpecular, "transmitted light");
  check.That(property->GetNumberOfIsosurfaces() == 2, "number of isosurfaces");
  double color[3] = { 0.0, 0.0, 0.0 };
  property->GetIsosurfaceColor(0, color);
  check.That(property->GetIsosurfaceValue(0) == 300.0 && property->GetIsosurfaceOpacity(0) == 0.5 &&
      property->GetIsosurfaceHasColor(0) && color[0] == 0.25 && color[1] == 0.5 && color[2] == 1.0,
    "isosurface with a colour");
  check.That(property->GetIsosurfaceValue(1) == -10.0 && property->GetIsosurfaceOpacity(1) == 0.125 &&
      !property->GetIsosurfaceHasColor(1),
    "isosurface without a colour");

  CheckWarning(ReadText(file, R"({ "IntegrationSpace": "data" })"), "IntegrationSpace", "\"Data\"");
  CheckWarning(ReadText(file, R"({ "Classification": true })"), "Classification", "PreIntegrated");
  CheckWarning(ReadText(file, R"({ "Silhouette": "On" })"), "Silhouette", "Clamped");
  CheckWarning(ReadText(file, R"({ "TransmittedLight": "Specular" })"), "TransmittedLight", "Diffuse");
  CheckWarning(
    ReadText(file, R"({ "ScalarOpacityUnitInterval": "10" })"), "ScalarOpacityUnitInterval", "at least 0");
}

void CheckVisibility(const std::string& file)
{
  Result all = ReadText(file,
    R"({ "Occlusion": true, "OcclusionAngle": 45, "AmbientColor": [0.25, 0.5, 1],
         "Shadows": true, "ShadowAngle": 2.5 })");
  vtkOpticsVolumeProperty* property = all.Property;
  check.That(all.Warnings.empty() && all.IsRead, "every setting of visibility is read: " + all.Warnings);
  check.That(property->GetOcclusion() && property->GetOcclusionAngle() == 45.0, "occlusion");
  check.That(property->GetShadows() && property->GetShadowAngle() == 2.5, "shadows");
  const double* color = property->GetAmbientColor();
  check.That(color[0] == 0.25 && color[1] == 0.5 && color[2] == 1.0, "ambient colour");

  CheckWarning(ReadText(file, R"({ "Occlusion": 60 })"), "Occlusion", "true or false");
  CheckWarning(ReadText(file, R"({ "OcclusionAngle": 90 })"), "OcclusionAngle", "[0, 80]");
  CheckWarning(ReadText(file, R"({ "OcclusionAngle": true })"), "OcclusionAngle", "[0, 80]");
  CheckWarning(ReadText(file, R"({ "AmbientColor": [1, 1] })"), "AmbientColor", "[red, green, blue]");
  CheckWarning(ReadText(file, R"({ "Shadows": "on" })"), "Shadows", "true or false");
  CheckWarning(ReadText(file, R"({ "ShadowAngle": "5" })"), "ShadowAngle", "[0, 80]");
}

// One isosurface that is not understood leaves all of the list out.
void CheckBrokenIsosurfaces(const std::string& file)
{
  for (const char* broken : { R"(7)", R"([7])", R"([{ "Value": 1 }])",
         R"([{ "Value": 1, "Opacity": "0.5" }])", R"([{ "Value": 1, "Opacity": 0.5, "Colour": [1, 1, 1] }])",
         R"([{ "Value": 1, "Opacity": 0.5, "Color": [1, 1] }])",
         R"([{ "Value": 1, "Opacity": 0.5 }, { "Value": 2, "Opacity": 0.5, "Color": 1 }])" })
  {
    const Result result = ReadText(file, std::string(R"({ "Isosurfaces": )") + broken + " }");
    CheckWarning(result, "Isosurfaces", "\"Color\": [red, green, blue]");
    check.That(result.Property->GetNumberOfIsosurfaces() == 0, std::string("none of ") + broken);
  }
}
}

int TestOpticsPreset(int argc, char* argv[])
{
  std::unique_ptr<char[]> directory(
    vtkTestUtilities::GetArgOrEnvOrDefault("-T", argc, argv, "VTK_TEMP_DIR", "."));
  const std::string file = std::string(directory.get()) + "/TestOpticsPreset.json";

  Result all = ReadText(file,
    R"({ "Glossiness": 0.05, "AnisotropyScale": 20, "ReflectanceModel": "Ward", // a comment
         "ScatteringAnisotropy": -0.5, "SpecularFromExtinction": false, "FrameSource": "Curvature" })");
  check.That(all.Warnings.empty() && all.IsRead, "every setting is read: " + all.Warnings);
  check.That(all.Property->GetReflectanceModel() == vtkOpticsVolumeProperty::Ward, "model");
  check.That(all.Property->GetGlossiness() == 0.05, "glossiness");
  check.That(all.Property->GetAnisotropyScale() == 20.0, "anisotropy scale");
  check.That(all.Property->GetScatteringAnisotropy() == -0.5F, "scattering anisotropy");
  check.That(!all.Property->GetSpecularFromExtinction(), "specular from extinction");
  check.That(all.Property->GetFrameSource() == vtkOpticsVolumeProperty::Curvature, "frame source");

  CheckWarning(ReadText(file, R"({ "Glosiness": 1 })"), "Glosiness", "ReflectanceModel, Glossiness");
  CheckWarning(ReadText(file, R"({ "ReflectanceModel": "Phong" })"), "ReflectanceModel", "Lafortune");
  CheckWarning(ReadText(file, R"({ "ReflectanceModel": 3 })"), "ReflectanceModel", "Lafortune");
  CheckWarning(ReadText(file, R"({ "Glossiness": 1 })"), "Glossiness", "with ReflectanceModel");
  CheckWarning(ReadText(file, R"({ "FrameSource": "Both" })"), "FrameSource", "Curvature");
  CheckWarning(ReadText(file, R"({ "SpecularFromExtinction": 1 })"), "SpecularFromExtinction", "true");
  CheckWarning(ReadText(file, R"({ "ScatteringAnisotropy": "g" })"), "ScatteringAnisotropy", "[-1, 1]");

  CheckIntegration(file);
  CheckVisibility(file);
  CheckBrokenIsosurfaces(file);

  std::ofstream(file) << R"({ "ReflectanceModel": "Phong" })";
  const Result kept = ReadFile(file, vtkOpticsVolumeProperty::Ward);
  check.That(
    kept.Property->GetReflectanceModel() == vtkOpticsVolumeProperty::Ward, "an unknown model is left out");

  for (const Result& broken :
    { ReadText(file, "[1, 2]"), ReadText(file, "{ \"Glossiness\": "), ReadFile(file + ".missing") })
  {
    CheckWarning(broken, "preset", file);
    check.That(!broken.IsRead, "a broken preset is not read");
  }
  return check.ExitCode();
}
