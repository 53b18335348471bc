// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The cases of lines and of visibility.

#ifndef LineFunctionCases_h
#define LineFunctionCases_h

#include "FunctionCaseList.h"

namespace
{
class LineFunctionCases : public FunctionCaseList
{
protected:
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
      const glm::dvec3 viewer =
        sine * this->Random.Across(tangent) + std::sqrt(1.0 - sine * sine) * tangent * (i % 2 ? 1.0 : -1.0);
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

  // From no cone at all to one of 80 degrees and, at the edge of the domain, a half space but for rounding.
  void AddVisibility()
  {
    for (double angle : { 0.0, 1e-3, 0.02, 0.5, 1.0471975511965976, 1.3962634015954636, 1.57 })
    {
      for (int count : { 1, 2, 4, 8, 16, 64 })
      {
        for (int index = 0; index < count; index += 1 + count / 16)
        {
          this->Add(46, index, count, std::cos(angle));
        }
      }
      for (int size : { 1, 2, 5, 13 })
      {
        for (int index = 0; index < size * size; ++index)
        {
          this->Add(47, index, size);
          this->Add(48, index, size, std::tan(angle));
        }
      }
      this->Add(49, std::cos(angle));
      this->Add(55, std::cos(angle));
    }
    this->AddSlices();
    this->AddGathering();
  }

  // Axes up to 85 degrees off that of the slices, and ways along and against both.
  void AddGathering()
  {
    for (double tilt : { 0.0, 1e-4, 0.3, 1.0, 1.48 })
    {
      for (int i = 0; i < 40; ++i)
      {
        const double turn = this->Random.Uniform(0.0, 6.28);
        FunctionCase c;
        c.Normal = glm::vec3((i % 4 == 0 ? 1e-4 : 1.0) * this->Random.OnSphere());
        c.ToViewer =
          glm::vec3(std::sin(tilt) * std::cos(turn), std::sin(tilt) * std::sin(turn), -std::cos(tilt));
        for (int function : { 57, 58 })
        {
          c.Function = function;
          this->Cases.push_back(c);
        }
      }
    }
    for (int count = 1; count <= 16; ++count)
    {
      this->Add(59, count);
    }
  }

  void AddSlices()
  {
    std::vector<double> opacities = Powers(1e-20, 0.99, 40);
    opacities.insert(opacities.end(), { 0.0, 0.0099999, 0.01, 0.999, 0.99999994, 1.0 });
    for (double opacity : opacities)
    {
      for (double length : { 0.0, 1e-6, 0.5, 1.0, 5.76, 1e6 })
      {
        this->Add(50, opacity, length);
        this->Add(54, opacity, length);
      }
    }
    for (double scale : { 1e-6, 1.0, 1e6 })
    {
      for (double nearness : { 0.01, 0.5, 0.999, 1.0 })
      {
        FunctionCase c;
        c.Function = 51;
        c.Normal = glm::vec3(this->Random.OnSphere());
        c.Major = glm::vec3(5.0 * this->Random.OnSphere());
        c.P = glm::vec3(scale * (1.0 - nearness), scale, scale * nearness);
        this->Cases.push_back(c);
      }
    }
  }

  void AddLineVoxels()
  {
    this->AddShares();
    FunctionCase c;
    for (double degree0 : { -1.0, 0.0, 1e-12, 0.5, 100.0 })
    {
      for (double share : { -0.2, 0.0, 0.01, 0.7, 1.3 })
      {
        for (double degree2 : { -0.6, 0.0, 0.3 })
        {
          for (double opacityScale : { 0.0, 0.25, 0.9, 1.0 })
          {
            c.Function = 52;
            c.Major = glm::vec3(share < 0.5 ? 1.0 : 3.0, opacityScale, 0.0);
            c.P = glm::vec3(share * degree0, degree0, degree2 * degree0);
            this->Cases.push_back(c);
          }
        }
        c.Function = 53;
        c.Normal = glm::vec3(0.3, 0.5, 3.0) * float(share * degree0);
        c.ToLight = glm::vec3(0.4, 0.6, 0.2) * float(degree0);
        c.ToViewer = glm::vec3(0.1, 0.1, 0.1);
        c.Major = glm::vec3(1.0, 0.45, 1.0);
        c.P = glm::vec3(share * degree0, degree0, 0.0);
        if (degree0 > 0.0)
        {
          this->Cases.push_back(c);
        }
      }
    }
  }

  // The series ends and the closed form begins at 0.1.
  void AddShares()
  {
    std::vector<double> shares = Powers(1e-20, 1.0, 40);
    shares.insert(shares.end(), { 0.0, 0.0999, 0.1, 0.1001, 0.5, 0.9, 0.999, 0.9999999, 1.0 });
    for (double share : shares)
    {
      this->Add(56, share);
    }
  }
};
}

#endif
