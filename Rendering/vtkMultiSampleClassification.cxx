// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkMultiSampleClassification.h"

#include "JsonErrors.h"
#include "MultiSampleRules.h"
#include "ParameterRange.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>
#include <limits>

using volumeoptics::MultiSampleRule;

vtkStandardNewMacro(vtkMultiSampleClassification);

namespace
{
const char* const Subject = "The classification";
const char* const ScalarNames[] = { "S", "S1", "S2" };
const char* const ColorNames[] = { "Red", "Green", "Blue" };

double Limited(double value)
{
  const double largest = std::numeric_limits<double>::max();
  return std::clamp(value, -largest, largest);
}

float AsFloat(double value)
{
  const double largest = std::numeric_limits<float>::max();
  return static_cast<float>(std::clamp(value, -largest, largest));
}
}

class vtkMultiSampleClassification::Internals
{
public:
  std::vector<MultiSampleRule> Rules;
};

//------------------------------------------------------------------------------
vtkMultiSampleClassification::vtkMultiSampleClassification()
  : Internal(std::make_unique<Internals>())
{
}

//------------------------------------------------------------------------------
vtkMultiSampleClassification::~vtkMultiSampleClassification() = default;

//------------------------------------------------------------------------------
bool vtkMultiSampleClassification::HasRule(int rule, int scalar, const char* method)
{
  const int count = this->GetNumberOfRules();
  const bool hasRule = rule >= 0 && rule < count && scalar >= Center && scalar <= Downhill;
  if (!hasRule)
  {
    vtkErrorMacro(<< method << ": there is no rule " << rule << " or scalar " << scalar
                  << ". Rules are numbered from 0, there are " << count
                  << "; scalars are Center (0), Uphill (1), Downhill (2).");
  }
  return hasRule;
}

//------------------------------------------------------------------------------
int vtkMultiSampleClassification::AddRule(const double s[2], const double s1[2], const double s2[2],
  double red, double green, double blue, double opacity)
{
  const double* const ranges[] = { s, s1, s2 };
  const bool isNumber = std::none_of(std::begin(ranges), std::end(ranges),
    [](const double* range) { return std::isnan(range[0]) || std::isnan(range[1]); });
  const int index = this->GetNumberOfRules();
  if (!isNumber || index >= LargestNumberOfRules)
  {
    vtkErrorMacro(<< "The rule is not added: "
                  << (isNumber ? "there is no room. Remove one of the "
                               : "an end of a range is not a number. ")
                  << (isNumber ? std::to_string(index) + " rules first."
                               : "Take infinite ends for any scalar."));
    return -1;
  }
  this->Internal->Rules.emplace_back();
  for (int scalar = Center; scalar <= Downhill; ++scalar)
  {
    this->SetRange(index, scalar, ranges[scalar][0], ranges[scalar][1]);
  }
  this->SetColor(index, red, green, blue);
  this->SetOpacity(index, opacity);
  this->Modified();
  return index;
}

//------------------------------------------------------------------------------
int vtkMultiSampleClassification::GetNumberOfRules()
{
  return static_cast<int>(this->Internal->Rules.size());
}

//------------------------------------------------------------------------------
void vtkMultiSampleClassification::RemoveRule(int rule)
{
  if (this->HasRule(rule, Center, "RemoveRule"))
  {
    this->Internal->Rules.erase(this->Internal->Rules.begin() + rule);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkMultiSampleClassification::RemoveAllRules()
{
  if (!this->Internal->Rules.empty())
  {
    this->Internal->Rules.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkMultiSampleClassification::SetRange(int rule, int scalar, double low, double high)
{
  if (!this->HasRule(rule, scalar, "SetRange"))
  {
    return;
  }
  if (std::isnan(low) || std::isnan(high))
  {
    vtkWarningMacro(<< "The range of " << ScalarNames[scalar] << " [" << low << ", " << high
                    << "] is not a number; it stays.");
    return;
  }
  MultiSampleRule& former = this->Internal->Rules[rule];
  const double ends[] = { Limited(std::min(low, high)), Limited(std::max(low, high)) };
  if (former.Low[scalar] != ends[0] || former.High[scalar] != ends[1])
  {
    former.Low[scalar] = ends[0];
    former.High[scalar] = ends[1];
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkMultiSampleClassification::GetRange(int rule, int scalar, double range[2])
{
  range[0] = range[1] = 0.0;
  if (this->HasRule(rule, scalar, "GetRange"))
  {
    range[0] = this->Internal->Rules[rule].Low[scalar];
    range[1] = this->Internal->Rules[rule].High[scalar];
  }
}

//------------------------------------------------------------------------------
void vtkMultiSampleClassification::SetSoftness(int rule, int scalar, double softness)
{
  if (this->HasRule(rule, scalar, "SetSoftness"))
  {
    volumeoptics::SetWithinRange(
      this, "Softness", softness, 0.0, 1.0e30, this->Internal->Rules[rule].Softness[scalar]);
  }
}

//------------------------------------------------------------------------------
double vtkMultiSampleClassification::GetSoftness(int rule, int scalar)
{
  return this->HasRule(rule, scalar, "GetSoftness") ? this->Internal->Rules[rule].Softness[scalar] : 0.0;
}

//------------------------------------------------------------------------------
void vtkMultiSampleClassification::SetColor(int rule, double red, double green, double blue)
{
  const double color[] = { red, green, blue };
  for (int i = 0; i < 3 && this->HasRule(rule, Center, "SetColor"); ++i)
  {
    volumeoptics::SetWithinRange(
      this, ColorNames[i], color[i], 0.0, 1.0, this->Internal->Rules[rule].Color[i]);
  }
}

//------------------------------------------------------------------------------
void vtkMultiSampleClassification::GetColor(int rule, double color[3])
{
  std::fill(color, color + 3, 0.0);
  if (this->HasRule(rule, Center, "GetColor"))
  {
    const auto& rgb = this->Internal->Rules[rule].Color;
    std::copy(rgb.begin(), rgb.end(), color);
  }
}

//------------------------------------------------------------------------------
void vtkMultiSampleClassification::SetOpacity(int rule, double opacity)
{
  if (this->HasRule(rule, Center, "SetOpacity"))
  {
    volumeoptics::SetWithinRange(this, "Opacity", opacity, 0.0, 1.0, this->Internal->Rules[rule].Opacity);
  }
}

//------------------------------------------------------------------------------
double vtkMultiSampleClassification::GetOpacity(int rule)
{
  return this->HasRule(rule, Center, "GetOpacity") ? this->Internal->Rules[rule].Opacity : 0.0;
}

//------------------------------------------------------------------------------
void vtkMultiSampleClassification::Evaluate(
  double s, double s1, double s2, const double former[4], double rgba[4])
{
  const auto result = volumeoptics::Classify(
    this->Internal->Rules, { s, s1, s2 }, { former[0], former[1], former[2], former[3] });
  std::copy(result.begin(), result.end(), rgba);
}

//------------------------------------------------------------------------------
void vtkMultiSampleClassification::GetRules(std::vector<float>& numbers)
{
  numbers.clear();
  for (const MultiSampleRule& rule : this->Internal->Rules)
  {
    const std::pair<const std::array<double, 3>&, double> vectors[] = { { rule.Low, rule.Opacity },
      { rule.High, 0.0 }, { rule.Softness, 0.0 }, { rule.Color, 0.0 } };
    for (const auto& [three, fourth] : vectors)
    {
      std::for_each(three.begin(), three.end(), [&](double value) { numbers.push_back(AsFloat(value)); });
      numbers.push_back(AsFloat(fourth));
    }
  }
}

//------------------------------------------------------------------------------
bool vtkMultiSampleClassification::WriteJson(const char* fileName)
{
  return volumeoptics::TellJsonErrors(this, Subject, fileName,
    [&] { volumeoptics::WriteJsonFile(fileName, volumeoptics::RulesToJson(this->Internal->Rules)); });
}

//------------------------------------------------------------------------------
bool vtkMultiSampleClassification::ReadJson(const char* fileName)
{
  return volumeoptics::TellJsonErrors(this, Subject, fileName, [&] {
    this->Internal->Rules =
      volumeoptics::RulesFromJson(volumeoptics::ReadJsonObject(fileName), LargestNumberOfRules);
    this->Modified();
  });
}

//------------------------------------------------------------------------------
std::string vtkMultiSampleClassification::WriteJsonString()
{
  return volumeoptics::FormatJson(volumeoptics::RulesToJson(this->Internal->Rules));
}

//------------------------------------------------------------------------------
bool vtkMultiSampleClassification::ReadJsonString(const std::string& text)
{
  return volumeoptics::TellJsonErrors(this, Subject, "of a text", [&] {
    this->Internal->Rules =
      volumeoptics::RulesFromJson(volumeoptics::ParseJsonObject(text), LargestNumberOfRules);
    this->Modified();
  });
}

//------------------------------------------------------------------------------
void vtkMultiSampleClassification::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Rules: " << this->Internal->Rules.size() << "\n";
  for (const MultiSampleRule& rule : this->Internal->Rules)
  {
    const vtkIndent next = indent.GetNextIndent();
    for (int i = 0; i < 3; ++i)
    {
      os << next << ScalarNames[i] << ": " << rule.Low[i] << ", " << rule.High[i]
         << ", Softness: " << rule.Softness[i] << "\n";
    }
    os << next << "Color: " << rule.Color[0] << ", " << rule.Color[1] << ", " << rule.Color[2] << "\n";
    os << next << "Opacity: " << rule.Opacity << "\n";
  }
}
