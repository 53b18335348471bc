// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// A flat face of a CT, one direction of anisotropy on all of it, 1 % noise on the normals: how far is
// the direction off after trilinear interpolation of the codes? With the components of [Ament2015] by
// tens of degrees where the face looks along z, with the map by a fraction of one.

#include "Check.h"
#include "Directions.h"
#include "Optics.h"

#include <algorithm>
#include <array>
#include <vector>

namespace
{
using glm::dvec2;
using glm::dvec3;

enum class Storage
{
  Map,
  Components,
  World
};

using Code = std::array<double, 5>;

Code Encode(Storage storage, const dvec3& normal, const dvec2& anisotropy)
{
  if (storage == Storage::World)
  {
    const optics::WorldTensor w = optics::EncodeWorld(normal, anisotropy);
    return { w.diagonal.x, w.diagonal.y, w.diagonal.z, w.mixed.x, w.mixed.y };
  }
  const dvec3 code =
    storage == Storage::Map ? optics::EncodeMap(normal, anisotropy) : optics::EncodeComponents(anisotropy);
  return { code.x, code.y, code.z, 0.0, 0.0 };
}

dvec2 Decode(Storage storage, const dvec3& normal, const Code& code)
{
  if (storage == Storage::World)
  {
    return optics::DecodeWorld(normal, { dvec3(code[0], code[1], code[2]), dvec2(code[3], code[4]) });
  }
  const dvec3 numbers(code[0], code[1], code[2]);
  return storage == Storage::Map ? optics::DecodeMap(normal, numbers) : optics::DecodeComponents(numbers);
}

// To [0, 1] in `levels` steps and back; 0 levels: as it is.
Code Quantised(const Code& code, int levels)
{
  Code result = code;
  for (double& number : result)
  {
    number = levels > 0 ? std::round((0.5 + 0.5 * number) * levels) / levels * 2.0 - 1.0 : number;
  }
  return result;
}

struct ErrorOfDirection
{
  double Mean = 0.0;
  double ShareAbove10 = 0.0;
};

constexpr double Degrees = 360.0 / TwoPi;

ErrorOfDirection Measure(Storage storage, const dvec3& face, double noise, int levels)
{
  RandomDirections random(7);
  const int points = 20000;
  const double strength = 0.8; // l2/l1 = 9
  ErrorOfDirection error;
  for (int i = 0; i < points; ++i)
  {
    const dvec3 line = random.Across(face);
    const dvec3 at(random.Uniform(), random.Uniform(), random.Uniform());
    dvec3 normal(0.0);
    Code code{};
    for (int corner = 0; corner < 8; ++corner)
    {
      const double weight = ((corner & 1) ? at.x : 1.0 - at.x) * ((corner & 2) ? at.y : 1.0 - at.y) *
        ((corner & 4) ? at.z : 1.0 - at.z);
      const dvec3 n = glm::normalize(face + noise * dvec3(random.Normal(), random.Normal(), random.Normal()));
      const optics::TangentBasis basis = optics::SphericalBasis(n);
      const double angle = std::atan2(glm::dot(line, basis.phi), glm::dot(line, basis.theta));
      const dvec2 anisotropy = strength * dvec2(std::cos(2.0 * angle), std::sin(2.0 * angle));
      const Code stored = Quantised(Encode(storage, n, anisotropy), levels);
      normal += weight * n;
      for (std::size_t k = 0; k < code.size(); ++k)
      {
        code[k] += weight * stored[k];
      }
    }
    normal = glm::normalize(normal);
    const optics::AnisotropyFrame frame = optics::EigenFrame(normal, Decode(storage, normal, code));
    const dvec3 truth = glm::normalize(line - glm::dot(line, normal) * normal);
    const double off = std::asin(std::min(glm::length(glm::cross(frame.major, truth)), 1.0)) * Degrees;
    error.Mean += off / points;
    error.ShareAbove10 += (off > 10.0 ? 1.0 : 0.0) / points;
  }
  return error;
}

ErrorOfDirection Print(const char* what, Storage storage, const dvec3& face, double noise, int levels)
{
  const ErrorOfDirection error = Measure(storage, face, noise, levels);
  std::cout << what << ": mean " << error.Mean << " degrees, " << 100.0 * error.ShareAbove10 << " % above 10"
            << std::endl;
  return error;
}
}

int TestAnisotropyInterpolation(int, char*[])
{
  Check check;
  const double noise = 0.01;
  for (double pole : { -1.0, 1.0 })
  {
    const dvec3 face(0.0, 0.0, pole);
    std::cout << "face towards z = " << pole << std::endl;
    const ErrorOfDirection components = Print("components", Storage::Components, face, noise, 0);
    const ErrorOfDirection map = Print("map", Storage::Map, face, noise, 0);
    const ErrorOfDirection map8 = Print("map, 8 bits", Storage::Map, face, noise, 255);
    const ErrorOfDirection world = Print("world", Storage::World, face, noise, 0);
    // an independent check of the paper's storage found 29 degrees and 69 %: tens of degrees
    check.AtLeast("components, mean", components.Mean, 20.0);
    check.AtLeast("components above 10", components.ShareAbove10, 0.5);
    check.AtMost("map, mean", map.Mean, 0.05);
    check.AtMost("map above 10", map.ShareAbove10, 0.0);
    // half a code of 1/255 against a strength of .8, halved by the half angle: .14 degrees a corner, less
    // the averaging of eight
    check.AtMost("map of 8 bits, mean", map8.Mean, 0.14);
    check.AtMost("world, mean", world.Mean, 0.05);
  }
  // where the paper's basis is smooth, all are alike
  const dvec3 side = glm::normalize(dvec3(0.6, 0.7, 0.3));
  check.AtMost(
    "components on a side", Print("components, side", Storage::Components, side, noise, 0).Mean, 1.0);
  check.AtMost("map on a side", Print("map, side", Storage::Map, side, noise, 0).Mean, 1.0);
  check.AtMost("map on a side, 8 bits", Print("map, side, 8 bits", Storage::Map, side, noise, 255).Mean, 1.0);
  return check.ExitCode();
}
