// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Which way a highlight is drawn out: on a cylinder whose major axis lies along its length, along its
// length ([Ament2015] figure 2): both models keep a wide lobe along U and the isotropic one along V.
// (Real scratches along U would spread light across U; the paper, and so we, draw the thread.)

#include "Check.h"
#include "Optics.h"

namespace
{
using glm::dvec3;

enum class Model
{
  Ward,
  Lafortune
};

// The cylinder's axis is x, its radius 1; viewer and light are at height 3 above its middle.
double Highlight(Model model, double x, double angle, double logRatio)
{
  const dvec3 normal(0.0, std::sin(angle), std::cos(angle));
  const dvec3 major(1.0, 0.0, 0.0);
  const dvec3 minor = glm::cross(normal, major);
  const dvec3 toEye = glm::normalize(dvec3(0.0, 0.0, 3.0) - (normal + x * major));
  if (model == Model::Ward)
  {
    const double u = optics::WardMajorRoughness(0.2, logRatio, 1.0);
    return optics::WardReflection(normal, major, minor, toEye, toEye, u, 0.2);
  }
  const double weight = optics::LafortuneMajorWeight(logRatio, 1.0);
  return optics::LafortuneReflection(normal, major, minor, toEye, toEye, weight, 30.0);
}

// Where the highlight falls to half of its middle.
template <typename Function>
double HalfLength(const Function& function)
{
  const double middle = function(0.0);
  double at = 0.0;
  while (at < 20.0 && function(at) > 0.5 * middle)
  {
    at += 1e-3;
  }
  return at;
}

void CheckModel(Check& check, Model model, const char* name)
{
  const auto along = [&](double logRatio) {
    return HalfLength([&](double x) { return Highlight(model, x, 0.0, logRatio); });
  };
  const auto around = [&](double logRatio) {
    return HalfLength([&](double angle) { return Highlight(model, 0.0, angle, logRatio); });
  };
  double last = 0.0;
  for (double ratio : { 1.0, 1.5, 2.0, 4.0, 9.0 })
  {
    const double length = along(std::log(ratio));
    const double width = around(std::log(ratio));
    std::cout << name << ", l2/l1 = " << ratio << ": half length along the axis " << length << ", around it "
              << width << std::endl;
    check.AtLeast("longer with the ratio", length, last);
    check.Near("around the axis as isotropic", width, around(0.0), 0.0);
    last = length;
  }
  // the cosine alone ends a highlight that spreads all along the axis
  check.AtLeast("drawn out along the axis", last, 4.0 * along(0.0));
}
}

int TestHighlightDirection(int, char*[])
{
  Check check;
  CheckModel(check, Model::Ward, "Ward");
  CheckModel(check, Model::Lafortune, "Lafortune");
  return check.ExitCode();
}
