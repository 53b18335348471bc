// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "MultiSampleRules.h"

#include "Optics.h"

#include <algorithm>
#include <limits>

namespace volumeoptics
{
namespace
{
const char* const RangeKeys[] = { "S", "S1", "S2" };
const double Unlimited = std::numeric_limits<double>::max();

glm::dvec3 Vector(const std::array<double, 3>& numbers)
{
  return glm::dvec3(numbers[0], numbers[1], numbers[2]);
}

void SetArray(std::array<double, 3>& array, const std::vector<double>& numbers)
{
  std::copy(numbers.begin(), numbers.end(), array.begin());
}

MultiSampleRule RuleFromJson(const JsonPart& object)
{
  object.AllowKeys({ "S", "S1", "S2", "Softness", "Color", "Opacity" });
  MultiSampleRule rule;
  for (int i = 0; i < 3; ++i)
  {
    const bool isLimited = object.Has(RangeKeys[i]);
    const std::vector<double> ends =
      isLimited ? object.Numbers(RangeKeys[i], 2) : std::vector<double>{ -Unlimited, Unlimited };
    rule.Low[i] = std::min(ends[0], ends[1]);
    rule.High[i] = std::max(ends[0], ends[1]);
  }
  if (object.Has("Softness"))
  {
    object.At("Softness").RequireEach(0.0, 1.0e30);
    SetArray(rule.Softness, object.Numbers("Softness", 3));
  }
  if (object.Has("Color"))
  {
    object.At("Color").RequireEach(0.0, 1.0);
    SetArray(rule.Color, object.Numbers("Color", 3));
  }
  rule.Opacity = object.Number("Opacity", 0.0, 1.0, 0.0);
  return rule;
}
}

std::array<double, 4> Classify(const std::vector<MultiSampleRule>& rules,
  const std::array<double, 3>& scalars, const std::array<double, 4>& former)
{
  optics::ClassifiedSample result = { glm::dvec3(former[0], former[1], former[2]), former[3] };
  for (const MultiSampleRule& rule : rules)
  {
    const double weight =
      optics::RuleWeight(Vector(scalars), Vector(rule.Low), Vector(rule.High), Vector(rule.Softness));
    result = optics::ApplyRule(result, { Vector(rule.Color), rule.Opacity }, weight);
  }
  return { result.color.x, result.color.y, result.color.z, result.opacity };
}

Json::Value RulesToJson(const std::vector<MultiSampleRule>& rules)
{
  Json::Value document(Json::objectValue);
  document["Rules"] = Json::Value(Json::arrayValue);
  for (const MultiSampleRule& rule : rules)
  {
    Json::Value object;
    for (int i = 0; i < 3; ++i)
    {
      const double ends[] = { rule.Low[i], rule.High[i] };
      if (ends[0] > -Unlimited || ends[1] < Unlimited)
      {
        object[RangeKeys[i]] = JsonNumbers(ends, 2);
      }
    }
    object["Softness"] = JsonNumbers(rule.Softness.data(), 3);
    object["Color"] = JsonNumbers(rule.Color.data(), 3);
    object["Opacity"] = rule.Opacity;
    document["Rules"].append(object);
  }
  return document;
}

std::vector<MultiSampleRule> RulesFromJson(const Json::Value& document, int largest)
{
  const JsonPart object(document, "");
  object.AllowKeys({ "Rules" });
  std::vector<MultiSampleRule> rules;
  const int count = object.Has("Rules") ? object.At("Rules").Size() : 0;
  if (count > largest)
  {
    throw JsonError("Rules has " + std::to_string(count) + " rules; there may be " + std::to_string(largest) +
      ". Leave some out.");
  }
  rules.reserve(count);
  for (int i = 0; i < count; ++i)
  {
    rules.push_back(RuleFromJson(object.At("Rules").At(i)));
  }
  return rules;
}
}
