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
