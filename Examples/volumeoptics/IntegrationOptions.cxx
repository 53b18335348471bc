// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "IntegrationOptions.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace
{
// Empty if the text is not 2 or 5 numbers, or opacity and colour are not in [0, 1].
std::vector<double> ReadIsosurface(const std::string& text)
{
  std::istringstream stream(text);
  std::vector<double> numbers;
  for (std::string item; std::getline(stream, item, ',');)
  {
    double number = 0.0;
    if (!CLI::detail::lexical_cast(item, number) || !std::isfinite(number))
    {
      return {};
    }
    numbers.push_back(number);
  }
  const bool isComplete = numbers.size() == 2 || numbers.size() == 5;
  return isComplete &&
      std::all_of(numbers.begin() + 1, numbers.end(), [](double x) { return x >= 0.0 && x <= 1.0; })
    ? numbers
    : std::vector<double>();
}

const CLI::Validator IsIsosurface(
  [](const std::string& text) {
    return !ReadIsosurface(text).empty() ? std::string()
                                         : "'" + text +
        "' is neither VALUE,OPACITY nor VALUE,R,G,B,OPACITY with opacity and colour in [0, 1], e.g. "
        "300,0.9,0.8,0.7,0.5";
  },
  "VALUE[,R,G,B],OPACITY");

void ReplaceName(std::string& setting, const std::string& option)
{
  setting = option.empty() ? setting : option;
}
}

void IntegrationOptions::AddTo(CLI::App& command)
{
  const auto group = "Integral along the ray (default: as the transfer function says)";
  const auto choice = [&](const char* name, std::string& value, const std::vector<std::string>& names,
                        const char* text) {
    command.add_option(name, value, text)->check(CLI::IsMember(names))->group(group);
  };
  choice("--integration", this->Space, IntegrationSpaces(),
    "Space that opacity adds up in: physical, per length (VTK's); data, per interval of the scalar, the same "
    "for any spacing, scale, step and gradient");
  choice("--classification", this->Classification, Classifications(),
    "Of samples, or pre-integrated over all values between two samples: for thin peaks of the function");
  command
    .add_option("--unit-interval", this->UnitInterval,
      "Data space: interval of the scalar that the function's opacity belongs to; 0: one hundredth of its "
      "range")
    ->check(CLI::NonNegativeNumber)
    ->group(group);
  command
    .add_option("--isosurface", this->Isosurfaces,
      "Data space: a surface of this value and opacity, and colour (default the function's); repeat it for "
      "more")
    ->check(IsIsosurface)
    ->allow_extra_args(false)
    ->group(group);
  choice("--silhouette", this->Silhouette, Silhouettes(),
    "Data space: more opacity where the ray grazes a surface, as a thin layer has it (exact), bounded "
    "(clamped), or by the gradient (post-classified)");
  choice("--transmitted-light", this->TransmittedLight, TransmittedLights(),
    "Data space: light from behind (--light=180,0) shines through");
}

void IntegrationOptions::Replace(IntegrationSettings& settings) const
{
  ReplaceName(settings.Space, this->Space);
  ReplaceName(settings.Classification, this->Classification);
  ReplaceName(settings.Silhouette, this->Silhouette);
  ReplaceName(settings.TransmittedLight, this->TransmittedLight);
  settings.UnitInterval = this->UnitInterval < 0.0 ? settings.UnitInterval : this->UnitInterval;
  if (!this->Isosurfaces.empty())
  {
    settings.Isosurfaces.clear();
    std::transform(this->Isosurfaces.begin(), this->Isosurfaces.end(),
      std::back_inserter(settings.Isosurfaces), ReadIsosurface);
  }
}
