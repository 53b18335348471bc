// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FrameError.h"

#include "Optics/Optics.h"
#include "vtkAnisotropyFilter.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
using optics::AnisotropyFrame;

constexpr double LeastNormal = 0.8;   // mean of neighbouring normals: shorter, they disagree
constexpr double LeastStrength = 0.2; // of the truth: weaker, it has no direction
constexpr double BadAngle = 10.0;
constexpr int LargestCode = 5;

// Interpolates the arrays of an image without a direction matrix.
class Sampler
{
public:
  Sampler(vtkImageData* image, const char* array)
    : Values(image->GetPointData()->GetArray(array))
  {
    image->GetDimensions(this->Dimensions);
    image->GetSpacing(this->Spacing);
    int extent[6];
    image->GetExtent(extent);
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Origin[axis] = image->GetOrigin()[axis] + extent[2 * axis] * this->Spacing[axis];
    }
  }

  std::array<double, LargestCode> At(const glm::dvec3& point) const
  {
    vtkIdType low[3], high[3];
    double share[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const double last = this->Dimensions[axis] - 1;
      const double at = std::clamp((point[axis] - this->Origin[axis]) / this->Spacing[axis], 0.0, last);
      low[axis] = static_cast<vtkIdType>(at);
      high[axis] = std::min<vtkIdType>(low[axis] + 1, this->Dimensions[axis] - 1);
      share[axis] = at - low[axis];
    }
    std::array<double, LargestCode> sum{};
    for (int corner = 0; corner < 8; ++corner)
    {
      double weight = 1.0;
      vtkIdType index[3];
      for (int axis = 0; axis < 3; ++axis)
      {
        const bool upper = (corner >> axis & 1) != 0;
        index[axis] = upper ? high[axis] : low[axis];
        weight *= upper ? share[axis] : 1.0 - share[axis];
      }
      const vtkIdType voxel = index[0] + this->Dimensions[0] * (index[1] + this->Dimensions[1] * index[2]);
      for (int i = 0; i < this->Values->GetNumberOfComponents(); ++i)
      {
        sum[i] += weight * this->Values->GetComponent(voxel, i);
      }
    }
    return sum;
  }

private:
  vtkDataArray* Values;
  int Dimensions[3];
  double Spacing[3], Origin[3];
};

struct Frames
{
  explicit Frames(const FrameImage& image)
    : Normals(image.Normals, "Normals")
    , Code(image.Code, "AmbientCovariance")
    , Storage(image.Storage)
  {
  }

  // Length of the interpolated normal, its direction and the anisotropy there.
  double At(const glm::dvec3& point, glm::dvec3& normal, glm::dvec2& anisotropy) const
  {
    const auto n = this->Normals.At(point);
    normal = glm::dvec3(n[0], n[1], n[2]);
    const double length = glm::length(normal);
    if (length < 1.0e-6)
    {
      return 0.0;
    }
    normal /= length;
    const auto code = this->Code.At(point);
    const glm::dvec3 three(code[0], code[1], code[2]);
    anisotropy = this->Storage == vtkAnisotropyFilter::Map ? optics::DecodeMap(normal, three)
      : this->Storage == vtkAnisotropyFilter::Components
      ? optics::DecodeComponents(three)
      : optics::DecodeWorld(normal, optics::WorldTensor{ three, glm::dvec2(code[3], code[4]) });
    return length;
  }

  Sampler Normals, Code;
  int Storage;
};

double Degrees(const glm::dvec3& a, const glm::dvec3& b)
{
  return glm::degrees(std::acos(std::min(std::abs(glm::dot(a, b)), 1.0)));
}

struct Sums
{
  double Weight = 0.0, Angle = 0.0, Points = 0.0, Bad = 0.0, SquaredStrength = 0.0;
  std::array<double, FrameError::NumberOfBins> BinWeight{}, BinAngle{};

  void Add(double angle, double strength, double strengthError, double cosinePole)
  {
    const int bin =
      std::min(static_cast<int>(cosinePole * FrameError::NumberOfBins), FrameError::NumberOfBins - 1);
    this->Weight += strength;
    this->Angle += strength * angle;
    this->Points += 1.0;
    this->Bad += angle > BadAngle ? 1.0 : 0.0;
    this->SquaredStrength += strengthError * strengthError;
    this->BinWeight[bin] += strength;
    this->BinAngle[bin] += strength * angle;
  }

  FrameError Result() const
  {
    FrameError error;
    const double points = std::max(this->Points, 1.0);
    error.MeanAngle = this->Weight > 0.0 ? this->Angle / this->Weight : 0.0;
    error.BadFraction = this->Bad / points;
    error.StrengthRms = std::sqrt(this->SquaredStrength / points);
    for (int i = 0; i < FrameError::NumberOfBins; ++i)
    {
      error.AngleByPole[i] = this->BinWeight[i] > 0.0 ? this->BinAngle[i] / this->BinWeight[i] : 0.0;
    }
    return error;
  }
};

void CompareAt(const glm::dvec3& point, const Frames& estimate, const Frames& truth, Sums& sums)
{
  glm::dvec3 trueNormal, normal;
  glm::dvec2 trueAnisotropy, anisotropy;
  if (truth.At(point, trueNormal, trueAnisotropy) < LeastNormal ||
    glm::length(trueAnisotropy) < LeastStrength || estimate.At(point, normal, anisotropy) < 1.0e-6)
  {
    return;
  }
  const AnisotropyFrame trueFrame = optics::EigenFrame(trueNormal, trueAnisotropy);
  const AnisotropyFrame frame = optics::EigenFrame(normal, anisotropy);
  const double strength = glm::length(trueAnisotropy);
  sums.Add(Degrees(trueFrame.major, frame.major), strength, glm::length(anisotropy) - strength,
    std::abs(trueNormal.z));
}
}

FrameError CompareFrames(const FrameImage& estimate, const FrameImage& truth)
{
  const Frames estimated(estimate), exact(truth);
  int dimensions[3];
  truth.Normals->GetDimensions(dimensions);
  const double* spacing = truth.Normals->GetSpacing();
  const double* origin = truth.Normals->GetOrigin();
  Sums sums;
  for (int k = 1; k < dimensions[2] - 2; ++k)
  {
    for (int j = 1; j < dimensions[1] - 2; ++j)
    {
      for (int i = 1; i < dimensions[0] - 2; ++i)
      {
        const glm::dvec3 between(i + 0.5, j + 0.5, k + 0.5);
        CompareAt(glm::dvec3(origin[0], origin[1], origin[2]) +
            between * glm::dvec3(spacing[0], spacing[1], spacing[2]),
          estimated, exact, sums);
      }
    }
  }
  return sums.Result();
}
