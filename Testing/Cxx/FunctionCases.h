// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The cases on which each formula is compared between precisions: over its stated domain and at the
// edges of it.

#ifndef FunctionCases_h
#define FunctionCases_h

#include "LineFunctionCases.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
class CasesOfFunctions : public LineFunctionCases
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
    this->AddVisibility();
    this->AddLineVoxels();
  }

private:
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
    }
  }
};
}

#endif
