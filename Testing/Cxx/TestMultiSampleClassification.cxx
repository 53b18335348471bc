// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Colour and opacity by three scalars: closed cases, the numbers for the shader, branches and leaves as
// in [Lum2004] figure 11, JSON, errors.

#include "TestScene.h"
#include "vtkMultiSampleClassification.h"

#include "vtkTestUtilities.h"

#include <array>
#include <limits>
#include <sstream>

namespace
{
using Rules = vtkMultiSampleClassification;
using Color = std::array<double, 4>;

const double Infinity = std::numeric_limits<double>::infinity();
const double Any[2] = { -Infinity, Infinity };
const Color Former = { 0.2, 0.4, 0.6, 0.5 };

Color At(Rules* rules, double s, double s1, double s2, const Color& former = Former)
{
  Color color;
  rules->Evaluate(s, s1, s2, former.data(), color.data());
  return color;
}

void CheckColor(Check& check, const std::string& what, const Color& color, const Color& expected)
{
  for (int i = 0; i < 4; ++i)
  {
    check.Near(what + ", channel " + std::to_string(i), color[i], expected[i], Rounding);
  }
}

void CheckRules(Check& check)
{
  vtkNew<Rules> rules;
  CheckColor(check, "no rule", At(rules, 1.0, 2.0, 3.0), Former);
  const double s[2] = { 10.0, 20.0 };
  const double s1[2] = { 40.0, 30.0 }; // reversed
  rules->AddRule(s, s1, Any, 1.0, 0.0, 0.0, 0.25);
  CheckColor(check, "in all ranges", At(rules, 15.0, 35.0, -1e300), { 1.0, 0.0, 0.0, 0.25 });
  CheckColor(check, "S outside", At(rules, 20.1, 35.0, 0.0), Former);
  CheckColor(check, "S1 outside", At(rules, 15.0, 29.9, 0.0), Former);
  CheckColor(check, "NaN is in no range", At(rules, 15.0, std::nan(""), 0.0), Former);
  rules->SetSoftness(0, Rules::Center, 4.0);
  // half the rule: opacities (.5 + .25)/2; colours by .25 and .125
  CheckColor(check, "half of a rule", At(rules, 22.0, 35.0, 0.0),
    { (0.2 * 0.25 + 0.125) / 0.375, 0.4 * 0.25 / 0.375, 0.6 * 0.25 / 0.375, 0.375 });
  const double s2[2] = { 0.0, 5.0 };
  rules->AddRule(Any, Any, s2, 0.0, 1.0, 0.0, 0.0);
  CheckColor(check, "a later rule wins", At(rules, 15.0, 35.0, 2.0), { 0.0, 1.0, 0.0, 0.0 });
  rules->SetSoftness(1, Rules::Downhill, 2.0);
  CheckColor(check, "half of it on the earlier one", At(rules, 15.0, 35.0, 6.0), { 1.0, 0.0, 0.0, 0.125 });
  rules->RemoveRule(0);
  CheckColor(check, "the first is removed", At(rules, 15.0, 35.0, 7.0), Former);
  // what is transparent has no say in the colour
  CheckColor(check, "half transparent", At(rules, 0.0, 0.0, 6.0), { 0.2, 0.4, 0.6, 0.25 });
}

void CheckNumbers(Check& check)
{
  vtkNew<Rules> rules;
  const double s[2] = { 1.0, 2.0 };
  rules->AddRule(s, Any, s, 0.1, 0.2, 0.3, 0.4);
  rules->AddRule(Any, s, Any, 0.5, 0.6, 0.7, 0.8);
  rules->SetSoftness(1, Rules::Uphill, 9.0);
  std::vector<float> numbers;
  rules->GetRules(numbers);
  const float most = std::numeric_limits<float>::max();
  const std::vector<float> expected = { 1.0F, -most, 1.0F, 0.4F, 2.0F, most, 2.0F, 0.0F, 0.0F, 0.0F, 0.0F,
    0.0F, 0.1F, 0.2F, 0.3F, 0.0F, -most, 1.0F, -most, 0.8F, most, 2.0F, most, 0.0F, 0.0F, 9.0F, 0.0F, 0.0F,
    0.5F, 0.6F, 0.7F, 0.0F };
  check.That(numbers == expected, "the numbers for the shader");
}

// A branch of 200 and a leaf of 100 in air, both blurred over a voxel: along the radius, where the
// transition of the branch passes the scalars of the leaf.
void CheckBranchAndLeaf(Check& check)
{
  const auto profile = [](double material, double x) {
    return material * 0.5 * std::erfc((x - 10.0) / std::sqrt(2.0));
  };
  vtkNew<Rules> rules;
  const double between[2] = { 0.0, 150.0 };
  const double wood[2] = { 150.0, 255.0 };
  rules->AddRule(between, wood, Any, 0.0, 0.0, 0.0, 0.0);
  const Color leaf = { 0.1, 0.6, 0.1, 0.5 };
  const auto count = [&](double material, bool withRules) {
    int green = 0;
    for (double x = 0.0; x < 20.0; x += 0.125)
    {
      const double s = profile(material, x);
      const bool isLeaf = s >= 50.0 && s <= 150.0;
      const Color former = isLeaf ? leaf : Color{ 0.5, 0.3, 0.1, s > 150.0 ? 0.9 : 0.0 };
      const double step = 1.5; // beyond the blur
      const Color color =
        withRules ? At(rules, s, profile(material, x - step), profile(material, x + step), former) : former;
      green += color[1] > color[0] && color[3] > 0.2;
    }
    return green;
  };
  check.AtLeast("leaf around the branch by the scalar alone", count(200.0, false), 10.0);
  check.AtMost("by three scalars", count(200.0, true), 0.0);
  check.Near("samples of the leaf", count(100.0, true), count(100.0, false), 0.0);
}

void CheckJson(Check& check, const std::string& folder)
{
  vtkNew<Rules> rules;
  const double s[2] = { -1.0 / 3.0, 2e300 };
  rules->AddRule(s, Any, s, 0.1, 0.2, 1.0 / 7.0, 0.4);
  rules->SetSoftness(0, Rules::Uphill, 0.3);
  const std::string file = folder + "/rules.json";
  vtkNew<Rules> read;
  check.That(rules->WriteJson(file.c_str()) && read->ReadJson(file.c_str()), "rules are written and read");
  check.That(read->WriteJsonString() == rules->WriteJsonString(), "the text is the same");
  std::vector<float> written;
  std::vector<float> numbers;
  rules->GetRules(written);
  read->GetRules(numbers);
  check.That(numbers == written, "and the numbers");
  const Warnings warnings(read);
  const std::pair<const char*, const char*> cases[] = { { "{\"Rules\": [{\"S\": [1]}]}",
                                                          "Rules[0].S is [1]" },
    { "{\"Rules\": [{\"S3\": [1, 2]}]}", "unknown key S3" },
    { "{\"Rules\": [{\"Opacity\": 1.5}]}", "Opacity is 1.5" },
    { "{\"Rules\": [{\"Color\": [0, 0, 2]}]}", "Color is [0,0,2]" },
    { "{\"Rules\": [{\"Softness\": [0, 0, -2]}]}", "Softness is [0,0,-2]" }, { "nothing", "not a JSON" } };
  for (const auto& [text, named] : cases)
  {
    check.That(!read->ReadJsonString(text) && warnings.Texts.back().find(named) != std::string::npos,
      std::string(text) + " names " + named);
  }
  check.That(read->GetNumberOfRules() == 1, "errors change nothing");
  check.That(!read->ReadJson("/nowhere/rules.json") && !read->WriteJson("/nowhere/rules.json"), "no file");
}

void CheckSettings(Check& check)
{
  vtkNew<Rules> rules;
  const Warnings warnings(rules);
  const double bad[2] = { 0.0, std::nan("") };
  check.That(rules->AddRule(Any, bad, Any, 0.0, 0.0, 0.0, 0.0) == -1, "NaN is no range");
  rules->AddRule(Any, Any, Any, -1.0, 0.5, 2.0, 7.0);
  double color[3];
  rules->GetColor(0, color);
  check.That(color[0] == 0.0 && color[2] == 1.0 && rules->GetOpacity(0) == 1.0, "nearest values");
  check.That(warnings.Texts.size() == 4, "are said");
  const vtkMTimeType time = rules->GetMTime();
  rules->SetRange(0, Rules::Center, -Infinity, Infinity);
  check.That(rules->GetMTime() == time, "the same range is no change");
  rules->SetRange(0, Rules::Center, 0.0, 1.0);
  check.That(rules->GetMTime() > time, "another is");
  rules->SetRange(0, 3, 0.0, 1.0);
  rules->SetRange(1, 0, 0.0, 1.0);
  rules->SetSoftness(0, 0, -1.0);
  check.That(warnings.Texts.size() == 7, "bad settings are said");
  while (rules->GetNumberOfRules() < Rules::LargestNumberOfRules)
  {
    rules->AddRule(Any, Any, Any, 0.0, 0.0, 0.0, 0.0);
  }
  check.That(rules->AddRule(Any, Any, Any, 0.0, 0.0, 0.0, 0.0) == -1, "there is room for 32");
  std::ostringstream text;
  rules->Print(text);
  check.That(text.str().find("Opacity") != std::string::npos, "PrintSelf has the rules");
  rules->RemoveAllRules();
  check.That(rules->GetNumberOfRules() == 0, "all removed");
}
}

int TestMultiSampleClassification(int argc, char* argv[])
{
  Check check;
  char* folder =
    vtkTestUtilities::GetArgOrEnvOrDefault("-T", argc, argv, "VTK_TEMP_DIR", "Testing/Temporary");
  const std::string temporary = folder;
  delete[] folder;
  CheckRules(check);
  CheckNumbers(check);
  CheckBranchAndLeaf(check);
  CheckJson(check, temporary);
  CheckSettings(check);
  return check.ExitCode();
}
