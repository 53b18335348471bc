// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Lighting transfer functions as JSON: the same after writing and reading, readable numbers, errors.

#include "LightingFunctions.h"
#include "TestScene.h"

#include "vtkPointData.h"
#include "vtkTestUtilities.h"

#include <fstream>

namespace
{
void CheckJson(Check& check, const std::string& folder)
{
  vtkNew<Function> function;
  Add(function, 0.1, 1.0 / 3.0, -1e30, 1e-30, 0.7, { 0.1, 0.2, 1.0 / 7.0 });
  vtkNew<vtkPiecewiseFunction> curve;
  curve->AddPoint(1.0, 0.25, 0.3, 0.6);
  curve->AddPoint(2.0, 0.75);
  function->AddBoundary(curve, curve, 0.3, 0.2, 0.1);
  vtkNew<vtkImageData> image;
  image->SetExtent(2, 4, 1, 2, 0, 0);
  image->SetOrigin(-1.0, 3.0, 0.0);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 2);
  for (int i = 0; i < 12; ++i)
  {
    image->GetPointData()->GetScalars()->SetComponent(i / 2, i % 2, 20.0 * i);
  }
  function->SetTableFromImage(image);
  const std::string file = folder + "/lighting.json";
  check.That(function->WriteJson(file.c_str()), "a function is written");
  vtkNew<Function> read;
  check.That(read->ReadJson(file.c_str()), "and read");
  check.That(read->WriteJsonString() == function->WriteJsonString(), "the text is the same");
  check.That(Table(read, -2.0, 6.0, 32) == Table(function, -2.0, 6.0, 32), "and the table bit for bit");
  check.That(read->GetCurve(1, 0) && read->GetCurve(1, 0)->GetValue(1.3) == curve->GetValue(1.3),
    "and a curve's midpoint and sharpness");
  check.That(read->ReadJsonString("// nothing\n{}") && read->GetNumberOfBoundaries() == 0,
    "an object without keys has no boundaries");
  check.That(read->ReadJsonString(R"({"Boundaries": [{"CurveA": [[0, 0], [1, 1]], "RangeB": [2, 1]}]})") &&
      At(read, 0.5, 1.5)[0] == 0.0,
    "a curve and a range may be mixed");
}

// The shortest number that reads back the same, and no digits of its binary fraction.
void CheckJsonNumbers(Check& check)
{
  vtkNew<Function> function;
  Add(function, 0.0, 90.0, -100.25, 1.0 / 3.0, 10.0, { 0.2, 0.7, 0.4 });
  const std::string text = function->WriteJsonString();
  for (const char* part : { "\"Ambient\": 0.2,", "\"Diffuse\": 0.7,", "\"Specular\": 0.4", "[0, 90]",
         "[-100.25, 0.3333333333333333]", "\"Softness\": 10" })
  {
    check.That(text.find(part) != std::string::npos, std::string(part) + " is in " + text);
  }
}

void CheckJsonErrors(Check& check, const std::string& folder)
{
  struct Case
  {
    const char* Text;
    const char* Named;
  };
  const Case cases[] = {
    { "", "not a JSON object" },
    { "[1, 2]", "not a JSON object" },
    { "{\"Boundaries\": 3}", "Boundaries is 3" },
    { "{\"Boundary\": []}", "unknown key Boundary" },
    { "{\"Boundaries\": [4]}", "Boundaries[0] is 4" },
    { "{\"Boundaries\": [{\"RangeA\": [0, 1]}]}", "Boundaries[0] has no RangeB" },
    { "{\"Boundaries\": [{\"RangeA\": [0, \"x\"], \"RangeB\": [0, 1]}]}",
      "Boundaries[0].RangeA is [0,\"x\"]" },
    { "{\"Boundaries\": [{\"RangeA\": [0, 1], \"RangeB\": [0, 1, 2]}]}", "array of 2 finite numbers" },
    { "{\"Boundaries\": [{\"RangeA\": [0, 1], \"RangeB\": [0, 1], \"Softness\": -1}]}", "Softness is -1" },
    { "{\"Boundaries\": [{\"RangeA\": [0, 1], \"RangeB\": [0, 1], \"Diffuse\": 2}]}", "in [0, 1]" },
    { "{\"Boundaries\": [{\"CurveA\": [[0]], \"RangeB\": [0, 1]}]}", "CurveA[0] is [0]" },
    { "{\"Table\": {\"Origin\": [0, 0], \"Spacing\": [1, 1], \"Dimensions\": [0, 2], \"Values\": []}}",
      "Table.Dimensions is [0,2]" },
    { "{\"Table\": {\"Origin\": [0, 0], \"Spacing\": [1, 1], \"Dimensions\": [1, 1], \"Values\": [1]}}",
      "array of 3 finite numbers" },
  };
  vtkNew<Function> function;
  Add(function, 0.0, 1.0, 2.0, 3.0);
  const Warnings warnings(function);
  for (const Case& test : cases)
  {
    const std::size_t before = warnings.Texts.size();
    check.That(!function->ReadJsonString(test.Text), std::string(test.Text) + " is refused");
    check.That(
      warnings.Texts.size() == before + 1 && warnings.Texts.back().find(test.Named) != std::string::npos,
      std::string(test.Text) + " names '" + test.Named + "'" +
        (warnings.Texts.empty() ? "" : ": " + warnings.Texts.back()));
  }
  check.That(function->GetNumberOfBoundaries() == 1, "and nothing is changed");
  const std::string file = folder + "/broken-lighting.json";
  std::ofstream(file) << "{\"Boundaries\": {}}";
  check.That(!function->ReadJson(file.c_str()) &&
      warnings.Texts.back().find("broken-lighting.json") != std::string::npos,
    "an error names the file");
  check.That(!function->ReadJson("/nowhere/at/all.json") && !function->ReadJson(nullptr) &&
      !function->WriteJson("/nowhere/at/all.json"),
    "files that are not there");
}
}

int TestLightingJson(int argc, char* argv[])
{
  Check check;
  char* folder =
    vtkTestUtilities::GetArgOrEnvOrDefault("-T", argc, argv, "VTK_TEMP_DIR", "Testing/Temporary");
  const std::string temporary = folder;
  delete[] folder;
  CheckJson(check, temporary);
  CheckJsonNumbers(check);
  CheckJsonErrors(check, temporary);
  return check.ExitCode();
}
