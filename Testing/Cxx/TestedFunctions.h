// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The formulas that are compared between precisions, and how far the results may be apart.

#ifndef TestedFunctions_h
#define TestedFunctions_h

#include "Check.h"
#include "FunctionCases.h"
#include "Optics.h"
#include "OpticsFloat.h"

#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <vector>

namespace
{
namespace optics
{
using vec4 = glm::dvec4;
#define float double
#include "OpticsTable.glsl"
#undef float
}

struct TestedFunction
{
  const char* Name;
  // The scale of an error of one rounding unit: its condition at these arguments times the size of
  // the value, or of the largest value where the condition can't be told for each.
  std::function<double(const FunctionCase&, const glm::dvec4&)> Scale;
  // Bounds in units of 2^-24 times the scale: of C++ float, and of a GPU (whose exp2 and log2 may be off by 3
  // units and more, GLSL 4.60 section 4.7.1; a division by 2.5).
  double FloatUnits;
  double GpuUnits;
};

constexpr double RoundingUnit = 1.0 / 16777216.0;

double LargestOf(const glm::dvec4& v)
{
  return std::max(std::max(std::abs(v.x), std::abs(v.y)), std::max(std::abs(v.z), std::abs(v.w)));
}

const std::vector<TestedFunction>& TestedFunctions()
{
  const auto relative = [](const FunctionCase&, const glm::dvec4& value) { return LargestOf(value); };
  const auto one = [](const FunctionCase&, const glm::dvec4&) { return 1.0; };
  static const std::vector<TestedFunction> functions = {
    // the clamp to .999 and 1 - g lose 1/(1 - |g|) digits, the peak takes it three times less one
    { "HenyeyGreenstein",
      [](const FunctionCase& c, const glm::dvec4& value) {
        return value.x / (1.0 - std::min(std::abs(double(c.P.x)), 0.999));
      },
      8.0, 16.0 },
    // 1 - exp(-.01) has lost two digits; below, the series has not
    { "OneMinusExp", relative, 100.0, 400.0 },
    // log(1 - .01), likewise
    { "OpticalDepth", relative, 100.0, 400.0 },
    // log(1 - a): the rounding of 1 - a is 1/(1 - a) units, absolute in the depth; below .01 the series
    { "BoundedOpticalDepth",
      [](const FunctionCase& c, const glm::dvec4& value) {
        const double opacity = std::min(double(c.P.x), 0.999);
        return value.x + (opacity > 0.0099 ? 1.0 / (1.0 - opacity) : 0.0);
      },
      4.0, 8.0 },
    // both of the above
    { "OpacityForLength", relative, 200.0, 800.0 },
    // the difference of the depths: relative to these
    { "SpecularCoefficient",
      [](const FunctionCase& c, const glm::dvec4& value) {
        return std::min(std::max(double(c.P.x), double(c.P.y)) * c.P.z, 16.0) + value.x;
      },
      2.0, 8.0 },
    // the exponent of exp is up to ln(4/1e-4) = 11
    { "WardMajorRoughness", relative, 16.0, 64.0 },
    // 2 exp(1 - exp(x)): relative to 1, the exponent's error is at most that of x e^(x - e^x) < 1
    { "LafortuneMajorWeight", one, 4.0, 16.0 },
    { "WithoutSamplingNoise", one, 4.0, 8.0 },
    // 1 - s has lost 1/(1 - s) digits
    { "LogRatio",
      [](const FunctionCase& c, const glm::dvec4& value) {
        return value.x + 1.0 / (1.0 - std::min(double(c.P.x), 0.999));
      },
      2.0, 8.0 },
    // the exponent multiplies the cosine's error and, on a GPU, that of log2 (2^-21 near 1)
    { "BlinnPhongReflection", [](const FunctionCase& c, const glm::dvec4&) { return 1.0 + c.P.x; }, 4.0,
      16.0 },
    // relative to the peak, 1/(4 pi u v); d exp(-x^2)/dx < 1 and x = cos / roughness
    { "WardReflection",
      [](const FunctionCase& c, const glm::dvec4&) {
        const double peak = 1.0 / (4.0 * optics::Pi * c.P.x * c.P.y);
        return peak * (1.0 + 1.0 / std::min(c.P.x, c.P.y));
      },
      16.0, 32.0 },
    { "LafortuneReflection", [](const FunctionCase& c, const glm::dvec4&) { return 1.0 + c.P.y; }, 8.0,
      32.0 },
    // what follows has terms of order 1 and no amplification
    { "SphericalBasis.theta", one, 4.0, 16.0 },
    { "SphericalBasis.phi", one, 4.0, 16.0 },
    { "EncodeMap", one, 12.0, 48.0 },
    { "DecodeMap", one, 12.0, 48.0 },
    { "EncodeComponents", one, 2.0, 4.0 },
    { "DecodeComponents", one, 4.0, 16.0 },
    { "EncodeWorld", one, 16.0, 64.0 },
    { "DecodeWorld", one, 24.0, 96.0 },
    // the direction of a short (a1, a2) is as good as that of a long one; the logarithm as LogRatio's
    { "EigenFrame.major, logRatio",
      [](const FunctionCase& c, const glm::dvec4&) {
        const double strength = std::hypot(double(c.P.x), double(c.P.y));
        return 1.0 / (1.0 - std::min(strength, 0.999));
      },
      8.0, 32.0 },
    { "EigenFrame.minor", one, 8.0, 32.0 },
    // 1 - exp(-x) and -ln(1 - a), as above; a depth's own rounding is x exp(-x), less than one
    { "OpacityOverDepth", relative, 100.0, 400.0 },
    { "SegmentOpacity", relative, 100.0, 400.0 },
    { "OpacityForScalarStep", relative, 200.0, 800.0 },
    { "SilhouetteOpacity", relative, 100.0, 400.0 },
    { "ClampedSilhouetteOpacity", relative, 100.0, 400.0 },
    { "SurfaceSilhouetteOpacity", relative, 200.0, 800.0 },
    { "ClampedSurfaceOpacity", relative, 2.0, 4.0 },
    // a sum of three: relative to the lengths
    { "ScalarStep",
      [](const FunctionCase& c, const glm::dvec4&) {
        return double(glm::length(c.Normal) * glm::length(c.P));
      },
      4.0, 8.0 },
    // a cosine over LightFade
    { "ShareBehind", [](const FunctionCase&, const glm::dvec4&) { return 1.0 / optics::LightFade; }, 8.0,
      16.0 },
    { "TransmittedLight", [](const FunctionCase& c, const glm::dvec4&) { return 1.0 + c.P.x; }, 4.0, 16.0 },
    // the exponential takes the rounding of what is left of the peak
    { "TransmittedShare",
      [](const FunctionCase& c, const glm::dvec4& value) { return value.x * (1.0 + c.P.x + c.P.y); }, 100.0,
      400.0 },
    { "CrossesIsovalue, CrossingFraction", one, 4.0, 8.0 },
    { "TableCoordinate", one, 4.0, 8.0 },
    // a difference, a quotient of at most 1 and a difference from 1, one rounding each; a product of three
    { "SoftRange", one, 3.0, 8.0 },
    { "RuleWeight", one, 9.0, 24.0 },
    // shares of sums without cancellation
    { "ApplyRule", one, 8.0, 16.0 },
    // where it is not clamped, the quotient is at most 2, and 1 is added
    { "HybridSide", one, 3.0, 10.0 },
    // |Y_lm| is below 2 up to l = 12; the recurrence is stable in l
    { "SphericalHarmonic", one, 24.0, 96.0 },
    { "SineMoment", relative, 40.0, 160.0 },
    // the error of cos^n is that of n times the logarithm
    { "CosinePowerIntegral",
      [](const FunctionCase& c, const glm::dvec4&) {
        return std::min(1.0, 2.0 / std::sqrt(double(c.P.x))) * (4.0 + c.P.x);
      },
      2.0, 8.0 },
    // end-on the normal's error grows as 1/sine
    { "DiffuseOfCylinder",
      [](const FunctionCase& c, const glm::dvec4&) {
        return 1.0 / glm::length(glm::cross(glm::dvec3(c.Normal), glm::dvec3(c.ToViewer)));
      },
      4.0, 16.0 },
    // both of the two before, and the terminator's angle, whose error grows as the light nears T
    { "SpecularOfCylinder",
      [](const FunctionCase& c, const glm::dvec4&) {
        const double sine = glm::length(glm::cross(glm::dvec3(c.Normal), glm::dvec3(c.ToViewer)));
        const double sineOfLight = glm::length(glm::cross(glm::dvec3(c.Normal), glm::dvec3(c.ToLight)));
        return (1.0 + c.P.x) / sine + 1.0 / std::max(sineOfLight, 1e-3);
      },
      4.0, 16.0 },
    // the root of 1 - m: relative to the depth, and half of the digits where 1 - m is near 0
    { "DepthBounds",
      [](const FunctionCase& c, const glm::dvec4& value) {
        const double across = value.y > 0.0 ? value.x / value.y : 1.0;
        return std::max(double(c.P.x), 0.0) * std::max(1.0, 1.0 / std::max(across, 1e-3));
      },
      4.0, 16.0 },
    // the azimuth takes two roundings, of the angle and of the product; 1 - coneCosine is exact
    { "ConeDirection",
      [](const FunctionCase& c, const glm::dvec4& value) {
        return LargestOf(value) * (4.0 + optics::GoldenAngle * c.P.x);
      },
      2.0, 4.0 },
    { "IsOnDisk", one, 0.0, 0.0 },
    { "DiskDirection", relative, 4.0, 12.0 },
    { "SolidAngleOfDisk", relative, 2.0, 4.0 },
    // a depth's own rounding is x exp(-x) < 1; with -ln(1 - a) as above, whose two digits are lost near a = 0.01
    { "StretchTransmittance", one, 40.0, 160.0 },
    { "PlaceOnSlice",
      [](const FunctionCase& c, const glm::dvec4&) {
        return (std::abs(c.Normal.x * c.P.y) + std::abs(c.Normal.y * c.P.y) + std::abs(c.Major.x * c.P.x) +
                 std::abs(c.Major.y * c.P.x)) /
          c.P.z;
      },
      3.0, 8.0 },
    // bounds as above, times the radius; -ln(1 - s (1 - exp(-x))) takes the rounding of what is left of 1
    { "DepthOfLines",
      [](const FunctionCase& c, const glm::dvec4& value) {
        const double bounds = 10.0 * std::max(double(c.P.y), 0.0);
        const double left = c.Major.y < 1.0f ? std::max(1.0 - double(c.Major.y), std::exp(-value.x)) : 1.0;
        return bounds * c.Major.x + 1.0 / left * (value.x > 0.0 ? 1.0 : 0.0);
      },
      4.0, 16.0 },
    { "ColorOfLines", relative, 4.0, 8.0 },
    // at an opacity of 0.01 the rounding of 1 - 0.01 is 50 units of the depth
    { "StretchVisibility", one, 60.0, 160.0 },
    // the logarithm of a number next to 1, at least 0.05 away
    { "MeanWayOut", one, 40.0, 80.0 },
    // the closed form cancels to pi/4 q of terms of 1 + pi/2, over q >= 0.1; the root takes 1/sqrt(1 - q) of a rounding
    { "MeanDepthOfShare",
      [](const FunctionCase& c, const glm::dvec4& value) {
        return c.P.x < 0.1f ? value.x : 1.0 / c.P.x / std::sqrt(std::max(1.0 - double(c.P.x), 1e-7));
      },
      8.0, 32.0 },
    // products of the way's and the axis' components, divided by 1 - z >= 1
    { "TurnToAxis", [](const FunctionCase& c, const glm::dvec4&) { return double(glm::length(c.Normal)); },
      6.0, 12.0 },
    { "SlopeOfWay", [](const FunctionCase&, const glm::dvec4& value) { return LargestOf(value) + 1.0; }, 6.0,
      16.0 },
    { "FirstPartOfRay", relative, 4.0, 16.0 },
  };
  return functions;
}

glm::dvec4 InDouble(const FunctionCase& c)
{
  return optics::Evaluate(c.Function,
    { glm::dvec3(c.Normal), glm::dvec3(c.ToLight), glm::dvec3(c.ToViewer), glm::dvec3(c.Major),
      glm::dvec3(c.P) });
}

// Compares results of another precision with the double ones and prints the worst of each function.
class Comparison
{
public:
  void Add(Check& check, const FunctionCase& c, const glm::dvec4& value, double TestedFunction::*bound)
  {
    const TestedFunction& function = TestedFunctions()[c.Function];
    const glm::dvec4 expected = InDouble(c);
    const double scale = function.Scale(c, expected);
    for (int i = 0; i < 4; ++i)
    {
      // a float's smallest normal number, where it may become 0
      const double tolerance = function.*bound * RoundingUnit * scale + 1.2e-38;
      const std::string what = function.Name + Arguments(c);
      check.Finite(what, value[i]);
      check.Near(what, value[i], expected[i], tolerance);
      const double off = std::abs(value[i] - expected[i]) - 1.2e-38;
      this->Worst[c.Function] = std::max(this->Worst[c.Function], off / (RoundingUnit * scale + 1e-300));
    }
    ++this->Count[c.Function];
  }

  // A row of docs/accuracy.md for each.
  void Print(Check& check, double TestedFunction::*bound) const
  {
    for (std::size_t i = 0; i < TestedFunctions().size(); ++i)
    {
      std::cout << "| " << TestedFunctions()[i].Name << " | " << this->Count[i] << " | " << this->Worst[i]
                << " | " << TestedFunctions()[i].*bound << " |" << std::endl;
      check.AtLeast(std::string(TestedFunctions()[i].Name) + ", cases", this->Count[i], 1.0);
    }
  }

private:
  static std::string Arguments(const FunctionCase& c)
  {
    std::string text = "(";
    for (const glm::vec3& v : { c.Normal, c.ToLight, c.ToViewer, c.Major, c.P })
    {
      text += '(' + std::to_string(v.x) + ' ' + std::to_string(v.y) + ' ' + std::to_string(v.z) + ')';
    }
    return text + ')';
  }

  std::vector<double> Worst = std::vector<double>(TestedFunctions().size());
  std::vector<int> Count = std::vector<int>(TestedFunctions().size());
};
}

#endif
