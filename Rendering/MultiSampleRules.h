// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The rules of a classification by (S, S1, S2), and their JSON, which vtkMultiSampleClassification.h
// describes.

#ifndef MultiSampleRules_h
#define MultiSampleRules_h

#include "JsonDocument.h"

#include <array>
#include <vector>

namespace volumeoptics
{
struct MultiSampleRule
{
  std::array<double, 3> Low;  // of S, S1, S2
  std::array<double, 3> High; // ordered
  std::array<double, 3> Softness = { 0.0, 0.0, 0.0 };
  std::array<double, 3> Color = { 1.0, 1.0, 1.0 };
  double Opacity = 0.0;
};

// Red, green, blue, opacity after the rules.
std::array<double, 4> Classify(const std::vector<MultiSampleRule>& rules,
  const std::array<double, 3>& scalars, const std::array<double, 4>& former);

Json::Value RulesToJson(const std::vector<MultiSampleRule>& rules);
// Throws JsonError; largest: number of rules.
std::vector<MultiSampleRule> RulesFromJson(const Json::Value& document, int largest);
}

#endif
