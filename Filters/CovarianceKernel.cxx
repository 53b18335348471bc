// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CovarianceKernel.h"

#include <vector>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "CovarianceKernel.cxx"
#include <hwy/foreach_target.h> // compiles this file once for each instruction set

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace volumeoptics
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;
using Lanes = hn::CappedTag<float, KernelPadding>;
using Vector = hn::Vec<Lanes>;

// Number and sum of the accepted offsets.
struct Centroid
{
  Vector Count;
  Vector X;
  Vector Y;
  Vector Z;

  // Written out: an implicit constructor would be compiled for the baseline instruction set.
  HWY_INLINE Centroid()
    : Count(hn::Zero(Lanes()))
    , X(Count)
    , Y(Count)
    , Z(Count)
  {
  }

  // accepted: 1, or 0 for a sample that does not count
  HWY_INLINE void Add(Vector accepted, const float* world)
  {
    const Lanes lanes;
    Count = hn::Add(Count, accepted);
    X = hn::MulAdd(accepted, hn::Set(lanes, world[0]), X);
    Y = hn::MulAdd(accepted, hn::Set(lanes, world[1]), Y);
    Z = hn::MulAdd(accepted, hn::Set(lanes, world[2]), Z);
  }
};

// C of the accepted samples, about a known centroid.
struct Moments
{
  Vector Theta[3];
  Vector Phi[2];
  Vector MeanTheta;
  Vector MeanPhi;
  Vector ThetaTheta = hn::Zero(Lanes());
  Vector ThetaPhi = hn::Zero(Lanes());
  Vector PhiPhi = hn::Zero(Lanes());

  HWY_INLINE Moments(const CovarianceRow& row, std::size_t x, const Centroid& centroid)
  {
    const Lanes lanes;
    for (int axis = 0; axis < 3; ++axis)
    {
      Theta[axis] = hn::LoadU(lanes, row.Theta[axis] + x);
    }
    Phi[0] = hn::LoadU(lanes, row.Phi[0] + x);
    Phi[1] = hn::LoadU(lanes, row.Phi[1] + x);
    const Vector one = hn::Set(lanes, 1.0f);
    const Vector share = hn::Div(one, hn::Max(centroid.Count, one));
    const Vector theta =
      hn::MulAdd(Theta[0], centroid.X, hn::MulAdd(Theta[1], centroid.Y, hn::Mul(Theta[2], centroid.Z)));
    const Vector phi = hn::MulAdd(Phi[0], centroid.X, hn::Mul(Phi[1], centroid.Y));
    MeanTheta = hn::Mul(theta, share);
    MeanPhi = hn::Mul(phi, share);
  }

  HWY_INLINE void Add(Vector accepted, const float* world)
  {
    const Lanes lanes;
    const Vector x = hn::Set(lanes, world[0]);
    const Vector y = hn::Set(lanes, world[1]);
    const Vector z = hn::Set(lanes, world[2]);
    const Vector theta = hn::MulAdd(Theta[0], x, hn::MulAdd(Theta[1], y, hn::MulSub(Theta[2], z, MeanTheta)));
    const Vector phi = hn::MulAdd(Phi[0], x, hn::MulSub(Phi[1], y, MeanPhi));
    // 1 - d^2, and not positive for a sample that does not count
    const Vector rest = hn::NegMulAdd(phi, phi, hn::NegMulAdd(theta, theta, accepted));
    const Vector weight = hn::Max(rest, hn::Zero(lanes));
    const Vector weightedTheta = hn::Mul(weight, theta);
    ThetaTheta = hn::MulAdd(weightedTheta, theta, ThetaTheta);
    ThetaPhi = hn::MulAdd(weightedTheta, phi, ThetaPhi);
    PhiPhi = hn::MulAdd(hn::Mul(weight, phi), phi, PhiPhi);
  }
};

HWY_INLINE void Store(
  const CovarianceRow& row, std::size_t x, const Centroid& centroid, const Moments& moments)
{
  const Lanes lanes;
  hn::StoreU(centroid.Count, lanes, row.Accepted + x);
  hn::StoreU(moments.ThetaTheta, lanes, row.ThetaTheta + x);
  hn::StoreU(moments.ThetaPhi, lanes, row.ThetaPhi + x);
  hn::StoreU(moments.PhiPhi, lanes, row.PhiPhi + x);
}

// False if none of the block's voxels has a normal: their results are 0 then.
HWY_INLINE bool HasWork(const CovarianceRow& row, std::size_t x)
{
  const Lanes lanes;
  const Vector zero = hn::Zero(lanes);
  const Vector inPlane =
    hn::Add(hn::Abs(hn::LoadU(lanes, row.Phi[0] + x)), hn::Abs(hn::LoadU(lanes, row.Phi[1] + x)));
  if (!hn::AllTrue(lanes, hn::Eq(inPlane, zero)))
  {
    return true;
  }
  for (float* sums : { row.ThetaTheta, row.ThetaPhi, row.PhiPhi, row.Accepted })
  {
    hn::StoreU(zero, lanes, sums + x);
  }
  return false;
}

HWY_INLINE Vector Sampled(const NearestSample& sample, const float* scalars)
{
  return hn::LoadU(Lanes(), scalars + sample.Offset);
}

HWY_INLINE Vector Sampled(const LinearSample& sample, const float* scalars)
{
  const Lanes lanes;
  Vector even = hn::Mul(hn::LoadU(lanes, scalars + sample.Offsets[0]), hn::Set(lanes, sample.Weights[0]));
  Vector odd = hn::Mul(hn::LoadU(lanes, scalars + sample.Offsets[1]), hn::Set(lanes, sample.Weights[1]));
  for (int corner = 2; corner < 8; corner += 2)
  {
    even = hn::MulAdd(
      hn::LoadU(lanes, scalars + sample.Offsets[corner]), hn::Set(lanes, sample.Weights[corner]), even);
    odd = hn::MulAdd(hn::LoadU(lanes, scalars + sample.Offsets[corner + 1]),
      hn::Set(lanes, sample.Weights[corner + 1]), odd);
  }
  return hn::Add(even, odd);
}

// Samples once and keeps for the second pass which samples are accepted.
template <typename Sample>
HWY_INLINE void AccumulateRow(const CovarianceRow& row, const Sample* samples, std::size_t count)
{
  const Lanes lanes;
  const std::size_t width = hn::Lanes(lanes);
  static thread_local std::vector<float> kept;
  kept.resize(count * width);
  float* const accepted = kept.data();
  const Vector one = hn::Set(lanes, 1.0f);
  const Vector tolerance = hn::Set(lanes, row.Tolerance);
  for (std::size_t x = 0; x < static_cast<std::size_t>(row.Count); x += width)
  {
    if (!HasWork(row, x))
    {
      continue;
    }
    const float* const scalars = row.Scalars + x;
    const Vector centre = hn::LoadU(lanes, scalars);
    Centroid centroid;
    for (std::size_t i = 0; i < count; ++i)
    {
      const Vector difference = hn::Abs(hn::Sub(Sampled(samples[i], scalars), centre));
      const Vector weight = hn::IfThenElseZero(hn::Le(difference, tolerance), one); // 0 for NaN
      hn::StoreU(weight, lanes, accepted + i * width);
      centroid.Add(weight, samples[i].World);
    }
    Moments moments(row, x, centroid);
    for (std::size_t i = 0; i < count; ++i)
    {
      moments.Add(hn::LoadU(lanes, accepted + i * width), samples[i].World);
    }
    Store(row, x, centroid, moments);
  }
}

void AccumulateNearestRow(const CovarianceRow& row, const NearestSample* samples, std::size_t count)
{
  AccumulateRow(row, samples, count);
}

void AccumulateLinearRow(const CovarianceRow& row, const LinearSample* samples, std::size_t count)
{
  AccumulateRow(row, samples, count);
}

const char* InstructionSet()
{
  return hwy::TargetName(HWY_TARGET);
}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace volumeoptics
{
HWY_EXPORT(AccumulateNearestRow);
HWY_EXPORT(AccumulateLinearRow);
HWY_EXPORT(InstructionSet);

void AccumulateNearest(const CovarianceRow& row, const NearestSample* samples, std::size_t count)
{
  HWY_DYNAMIC_DISPATCH(AccumulateNearestRow)(row, samples, count);
}

void AccumulateLinear(const CovarianceRow& row, const LinearSample* samples, std::size_t count)
{
  HWY_DYNAMIC_DISPATCH(AccumulateLinearRow)(row, samples, count);
}

const char* KernelInstructionSet()
{
  return HWY_DYNAMIC_DISPATCH(InstructionSet)();
}
}
#endif
