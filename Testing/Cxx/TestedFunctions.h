// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The cases on which each formula is compared between precisions: over its stated domain and at the
// edges of it; and how far the results may be apart.

#ifndef TestedFunctions_h
#define TestedFunctions_h

#include "Check.h"
#include "Directions.h"
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

// Arguments are floats, so that every precision is given the same ones. (A unit vector is then off by
// 6e-8, for all alike.)
struct FunctionCase
{
  int Function = 0;
  glm::vec3 Normal{ 0.0f, 0.0f, 1.0f };
  glm::vec3 ToLight{ 0.0f, 0.0f, 1.0f };
  glm::vec3 ToViewer{ 0.0f, 0.0f, 1.0f };
  glm::vec3 Major{ 1.0f, 0.0f, 0.0f };
  glm::vec3 P{ 0.0f, 0.0f, 0.0f };
};

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
    { "LightSide", one, 8.0, 16.0 },
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
  };
  return functions;
}

class CasesOfFunctions
{
public:
  CasesOfFunctions()
  {
    this->AddScalars();
    this->AddReflectance();
    this->AddFrames();
    this->AddOpacitiesInDataSpace();
    this->AddSurfacesInDataSpace();
    this->AddTransmission();
    this->AddMultiSample();
    this->AddHybridSides();
    this->AddLines();
  }

  std::vector<FunctionCase> Cases;

private:
  void Add(int function, double x, double y = 0.0, double z = 0.0)
  {
    FunctionCase c;
    c.Function = function;
    c.P = glm::vec3(x, y, z);
    this->Cases.push_back(c);
  }

  static std::vector<double> Powers(double from, double to, int count)
  {
    std::vector<double> values;
    values.reserve(count);
    for (int i = 0; i < count; ++i)
    {
      values.push_back(from * std::pow(to / from, i / (count - 1.0)));
    }
    return values;
  }

  void AddScalars()
  {
    for (double g : { -1.0, -0.999, -0.9, -0.5, -1e-4, 0.0, 1e-30, 0.3, 0.76, 0.99, 0.9989, 1.0 })
    {
      for (double cosine : { -1.0, -0.9999999, -0.7, -1e-8, 0.0, 0.2, 0.99, 0.999999, 1.0, 1.0000001 })
      {
        this->Add(0, g, cosine);
      }
    }
    this->Add(1, 0.0);
    for (double x : Powers(1e-37, 1e4, 200))
    {
      this->Add(1, x);
    }
    std::vector<double> opacities = Powers(1e-30, 0.99, 100);
    opacities.insert(opacities.end(), { 0.0, 0.0099999, 0.01, 0.01000001, 0.99, 0.9989, 0.999, 0.99999994 });
    for (double a : opacities)
    {
      this->Add(2, a);
      this->Add(3, a);
      for (double length : { 0.0, 1e-6, 0.01, 0.5, 1.0, 7.0, 1e3, 1e6 })
      {
        this->Add(4, a, length);
      }
    }
    this->Add(3, 1.0);
    this->Add(3, -0.5);
    for (double length : { 0.0, 1e-6, 1.0, 1e30 })
    {
      this->Add(4, 1.0, length);
    }
    for (double unit : { 1e-12, 1e-3, 0.7, 1.0, 1e3, 1e12, 1e30 })
    {
      for (double ahead : { 0.0, 1e-12, 0.1, 6.9 })
      {
        this->Add(5, ahead, 0.1, unit);
        this->Add(5, 6.9, ahead, unit);
      }
    }
    std::vector<double> strengths = Powers(1e-20, 0.9, 40);
    strengths.insert(strengths.end(), { 0.0, 0.99, 0.998, 0.999, 0.9999, 1.0, 1.0000001 });
    for (double strength : strengths)
    {
      this->Add(9, strength);
      const double logRatio = optics::LogRatio(strength);
      for (double scale : { 0.0, 1e-3, 0.5, 1.0, 10.0, 60.0, 1e4 })
      {
        for (double roughness : { 1e-4, 0.01, 0.2, 1.0 })
        {
          this->Add(6, roughness, logRatio, scale);
        }
        this->Add(7, logRatio, scale);
      }
      for (double count : { 0.0, 3.0, 20.0, 1e6 })
      {
        this->Add(8, strength * 0.6, strength * -0.8, count);
      }
    }
  }

  // Half vectors near the normal, at distances that matter for the lobe, and light and viewer anywhere.
  void AddReflectance()
  {
    const std::vector<double> exponents = { 0.01, 0.5, 1.0, 10.0, 30.0, 1e3, 1e5 };
    const std::vector<double> roughnesses = { 1e-4, 0.01, 0.2, 1.0 };
    for (int i = 0; i < 400; ++i)
    {
      FunctionCase c;
      const glm::dvec3 normal = this->NormalFor(i);
      c.Normal = glm::vec3(normal);
      const glm::dvec3 major = this->Random.Across(normal);
      c.Major = glm::vec3(major);
      // |cosine| above 1e-5: nearer, the side of the plane is a matter of rounding
      const glm::dvec3 light = this->Random.Above(normal, 1e-5) * (i % 16 == 15 ? -1.0 : 1.0);
      const double off = std::pow(10.0, this->Random.Uniform(-5.0, 0.5));
      const glm::dvec3 mirror = 2.0 * glm::dot(normal, light) * normal - light;
      glm::dvec3 viewer = glm::normalize(mirror + off * this->Random.OnSphere());
      if (i % 4 == 0 || std::abs(glm::dot(viewer, normal)) < 1e-5)
      {
        viewer = this->Random.Above(normal, 1e-5);
      }
      this->AddLobes(c, light, viewer, exponents, roughnesses);
    }
    this->AddEdges(exponents, roughnesses);
  }

  // Along the normal, at grazing, exactly in the plane, behind, and light opposite to the viewer.
  void AddEdges(const std::vector<double>& exponents, const std::vector<double>& roughnesses)
  {
    for (double z : { 1.0, 1e-3, 1e-4, 0.0, -1e-4, -1.0 })
    {
      for (double zViewer : { 1.0, 0.5, 1e-3, 1e-4, 0.0, -1e-4, -1.0 })
      {
        for (double azimuth : { 0.0, 0.5, 3.0, TwoPi / 2.0 })
        {
          const glm::dvec3 light(std::sqrt(1.0 - z * z), 0.0, z);
          const double rho = std::sqrt(1.0 - zViewer * zViewer);
          this->AddLobes(FunctionCase(), light,
            glm::dvec3(rho * std::cos(azimuth), rho * std::sin(azimuth), zViewer), exponents, roughnesses);
        }
      }
    }
  }

  void AddLobes(FunctionCase c, const glm::dvec3& light, const glm::dvec3& viewer,
    const std::vector<double>& exponents, const std::vector<double>& roughnesses)
  {
    c.ToLight = glm::vec3(light);
    c.ToViewer = glm::vec3(viewer);
    for (double exponent : exponents)
    {
      c.Function = 10;
      c.P = glm::vec3(exponent, 0.0, 0.0);
      this->Cases.push_back(c);
      c.Function = 12;
      for (double weight : { -1.0, 0.0, 0.3, 1.0 })
      {
        c.P = glm::vec3(weight, exponent, 0.0);
        this->Cases.push_back(c);
      }
    }
    c.Function = 11;
    for (double minor : roughnesses)
    {
      for (double major : { minor, std::min(4.0, 10.0 * minor), 4.0 })
      {
        c.P = glm::vec3(major, minor, 0.0);
        this->Cases.push_back(c);
      }
    }
  }

  // Every fourth one a pole or near one.
  glm::dvec3 NormalFor(int i)
  {
    if (i % 4 != 1)
    {
      return this->Random.OnSphere();
    }
    const double rho = i % 8 == 1 ? 0.0 : std::pow(10.0, this->Random.Uniform(-30.0, -1.0));
    const double azimuth = this->Random.Uniform(0.0, TwoPi);
    return glm::dvec3(
      rho * std::cos(azimuth), rho * std::sin(azimuth), (i % 3 ? 1.0 : -1.0) * std::sqrt(1.0 - rho * rho));
  }

  void AddFrames()
  {
    for (int i = 0; i < 600; ++i)
    {
      const glm::dvec3 normal = this->NormalFor(i);
      double strength = i % 5 == 0 ? 1.0 : this->Random.Uniform();
      if (i % 5 == 1)
      {
        strength = std::pow(10.0, this->Random.Uniform(-30.0, 0.0));
      }
      const double angle = i % 7 == 0 ? (i % 4) * TwoPi / 4.0 : this->Random.Uniform(0.0, TwoPi);
      glm::dvec3 p(strength * std::cos(angle), strength * std::sin(angle), 0.0);
      if (i % 50 == 49)
      {
        p = glm::dvec3(0.0);
      }
      for (int function = 13; function <= 22; ++function)
      {
        FunctionCase c;
        c.Function = function;
        c.Normal = glm::vec3(normal);
        c.P = glm::vec3(p);
        if (function == 16)
        {
          c.P = glm::vec3(optics::EncodeMap(normal, glm::dvec2(p.x, p.y)));
        }
        this->Cases.push_back(c);
      }
    }
  }

  void AddOpacitiesInDataSpace()
  {
    std::vector<double> depths = Powers(1e-30, 1e30, 100);
    depths.insert(depths.end(), { 0.0, 0.0099999, 0.01, 0.0100001, 16.0, 36.0, 103.0, 745.0 });
    for (double depth : depths)
    {
      this->Add(23, depth);
      for (double step : { 0.0, 1e-6, 1e-3, 1.0, 1e6 })
      {
        this->Add(24, depth, step);
        for (double gradient : { 0.0, 1e-7, 0.5, 1e3 })
        {
          this->Add(26, depth, step, gradient);
          this->Add(27, depth, step, gradient);
        }
      }
    }
    std::vector<double> opacities = Powers(1e-20, 0.99, 40);
    opacities.insert(opacities.end(), { 0.0, 0.0099999, 0.01, 0.999, 0.99999994, 1.0 });
    for (double opacity : opacities)
    {
      for (double cosine : { 0.0, 1e-30, 1e-6, -1e-3, 0.1, -0.5, 1.0 })
      {
        this->Add(25, opacity, std::abs(cosine) * 1e3);
        this->Add(28, opacity, cosine);
        this->Add(29, opacity, cosine);
      }
    }
  }

  void AddSurfacesInDataSpace()
  {
    for (double from : { -1e30, -1.0, 0.0, 1e-30, 0.3, 0.5, 1.0, 1e30 })
    {
      for (double to : { -1e30, -1.0, 0.0, 1e-30, 0.3, 0.5, 1.0, 1e30 })
      {
        for (double isovalue : { -1.0, 0.0, 5e-31, 0.3, 0.4, 1.0 })
        {
          this->Add(34, from, to, isovalue);
        }
      }
      for (double entries : { 2.0, 256.0, 4096.0 })
      {
        this->Add(35, from, entries);
      }
    }
    for (int i = 0; i < 100; ++i)
    {
      FunctionCase c;
      c.Function = 30;
      c.Normal = glm::vec3(this->Random.OnSphere() * std::pow(10.0, this->Random.Uniform(-12.0, 12.0)));
      c.P = glm::vec3(this->Random.OnSphere() * std::pow(10.0, this->Random.Uniform(-12.0, 12.0)));
      this->Cases.push_back(c);
    }
  }

  // Cosines above 1e-4: the product of two smaller ones has a side by rounding.
  // At the ends of a range, in its soft edges, far away; rules of all opacities.
  void AddMultiSample()
  {
    for (double softness : { 0.0, 1e-3, 0.3, 40.0, 1e30 })
    {
      for (double low : { -1e30, -200.0, 0.0, 0.1 })
      {
        for (double value : { -3e38, -200.25, -1e-3, 0.0, 0.1, 0.4, 7.0, 7.0001, 8.0, 30.0, 3e38 })
        {
          FunctionCase c;
          c.Function = 36;
          c.P = glm::vec3(value, low, 7.0);
          c.Major = glm::vec3(softness, 0.0, 0.0);
          this->Cases.push_back(c);
          c.Function = 37;
          c.P = glm::vec3(value, 0.5, 0.9);
          c.Normal = glm::vec3(low, 0.0, 1.0);
          c.ToLight = glm::vec3(7.0, 1.0, 3.0);
          c.ToViewer = glm::vec3(softness, 0.0, 0.3);
          this->Cases.push_back(c);
        }
      }
    }
    for (double former : { 0.0, 1e-30, 0.2, 1.0 })
    {
      for (double rule : { 0.0, 1e-30, 0.7, 1.0 })
      {
        for (double weight : { 0.0, 1e-6, 0.5, 0.999, 1.0 })
        {
          FunctionCase c;
          c.Function = 38;
          c.P = glm::vec3(former, rule, weight);
          c.Normal = glm::vec3(0.2, 1.0, 0.0);
          c.ToLight = glm::vec3(0.9, 0.0, 0.4);
          this->Cases.push_back(c);
        }
      }
    }
  }

  // On both sides of the change and within it, by fades from the smallest that is set to one beyond use.
  void AddHybridSides()
  {
    for (double fade : { 1e-6, 1e-3, 0.0625, 1.0, 1e30 })
    {
      for (double share :
        { -1e6, -1.000001, -1.0, -0.999999, -0.7, -0.5, -0.1, -1e-6, -1e-30, 0.0, 1e-30, 0.3, 1e6 })
      {
        this->Add(39, share * fade, fade);
      }
    }
  }

  void AddTransmission()
  {
    for (int i = 0; i < 300; ++i)
    {
      FunctionCase c;
      const glm::dvec3 normal = i % 10 == 0 ? glm::dvec3(0.0) : this->Random.OnSphere();
      const glm::dvec3 around = i % 10 == 0 ? this->Random.OnSphere() : normal;
      c.Normal = glm::vec3(normal);
      c.ToLight = glm::vec3(this->Random.Above(around, 1e-4));
      c.ToViewer = glm::vec3(this->Random.Above(around, 1e-4) * (i % 3 == 0 ? 1.0 : -1.0));
      c.ToViewer = i % 3 == 1 ? -c.ToLight : c.ToViewer;
      c.Function = 31;
      this->Cases.push_back(c);
      c.Function = 32;
      for (double exponent : { 0.01, 1.0, 30.0, 1e5 })
      {
        c.P = glm::vec3(exponent, 0.0, 0.0);
        this->Cases.push_back(c);
      }
    }
    for (double segment : { 0.0, 1e-30, 1e-3, 0.01, 0.7, 20.0, 100.0, 1e30 })
    {
      for (double behind : { 0.0, 1e-3, 1.0, 50.0, 1e30 })
      {
        for (double peak : { 0.0, 1e-20, 0.5, 3.0, 1e30 })
        {
          this->Add(33, segment, behind, peak);
        }
      }

      void AddLines()
      {
        for (int l = 0; l <= 12; ++l)
        {
          for (int m = -l; m <= l; ++m)
          {
            for (int i = 0; i < 6; ++i)
            {
              FunctionCase c;
              c.Function = 40;
              c.Normal = glm::vec3(this->NormalFor(i));
              c.P = glm::vec3(l, m, 0.0);
              this->Cases.push_back(c);
            }
          }
          for (double power : { 1.0, 2.0, 2.5, 11.0, 33.0, 1001.0 })
          {
            this->Add(41, l, power);
          }
        }
        for (double exponent : { 1.0, 2.0, 11.0, 101.0, 1001.0 })
        {
          for (double angle : { -1.5707963, -0.3, 0.0, 1e-4, 0.05, 0.3, 1.5, 1.5707963 })
          {
            this->Add(42, exponent, angle);
          }
        }
        for (double ratio : { -1.0, -0.625, -0.6, 0.0, 0.3, 0.3125, 1.0 })
        {
          for (double whole : { -1.0, 0.0, 1e-12, 0.5, 1e6 })
          {
            this->Add(45, whole, whole * ratio);
          }
        }
        this->AddCylinders();
      }

      // Light and viewer anywhere, at the same place, opposite, along the cylinder.
      void AddCylinders()
      {
        for (int i = 0; i < 400; ++i)
        {
          FunctionCase c;
          const glm::dvec3 tangent = this->NormalFor(i);
          const double sine = i % 5 == 0 ? 1e-3 : this->Random.Uniform(0.05, 1.0);
          const glm::dvec3 viewer = sine * this->Random.Across(tangent) +
            std::sqrt(1.0 - sine * sine) * tangent * (i % 2 ? 1.0 : -1.0);
          const glm::dvec3 lights[] = { this->Random.OnSphere(), viewer, -viewer, tangent,
            glm::normalize(tangent + 0.01 * this->Random.OnSphere()) };
          c.Normal = glm::vec3(tangent);
          c.ToViewer = glm::vec3(viewer);
          c.ToLight = glm::vec3(lights[i % 10 < 5 ? 0 : i % 5]);
          for (double exponent : { 1.0, 10.0, 32.0, 1000.0 })
          {
            c.P = glm::vec3(exponent, 0.0, 0.0);
            c.Function = 44;
            this->Cases.push_back(c);
          }
          c.Function = 43;
          this->Cases.push_back(c);
        }
      }

      RandomDirections Random{ 10 };
    };

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

      void Print(Check& check) const
      {
        for (std::size_t i = 0; i < TestedFunctions().size(); ++i)
        {
          std::cout << TestedFunctions()[i].Name << ": " << this->Count[i] << " cases, worst "
                    << this->Worst[i] << " units" << std::endl;
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

      std::array<double, 29> Worst{};
      std::array<int, 29> Count{};
    };
  }

#endif
