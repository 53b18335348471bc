// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Properties of the pre-integrated table over random transfer functions and random segments, and its
// floats against quadrature in double.

#include "Directions.h"
#include "TableTesting.h"

#include <string>

namespace
{
// Up to 20 nodes; steps, coincident nodes, peaks narrower than a cell, and either opaque nodes or VTK's sharp
// curves (then it returns true): a sharp curve towards 1 rounds to 1 on a part of its way, where its attenuation is OpaqueDepth.
bool MakeFunctions(RandomDirections& random, TestTable& t)
{
  const int nodes = 2 + static_cast<int>(random.Uniform(0.0, 18.0));
  const bool hasCurves = random.Uniform() < 0.5;
  double scalar = random.Uniform(-0.2, 0.3);
  for (int i = 0; i < nodes; ++i)
  {
    const double kind = random.Uniform();
    scalar += kind < 0.1 ? 0.0 : kind < 0.3 ? random.Uniform(1.0e-6, 1.0e-3) : random.Uniform(0.0, 0.2);
    const double opacity = kind < 0.5 ? 0.0 : kind < 0.6 && !hasCurves ? 1.0 : random.Uniform();
    const bool isSharp = hasCurves && random.Uniform() < 0.4;
    const double midpoint = isSharp ? random.Uniform(0.1, 0.9) : 0.5;
    t.Opacity->AddPoint(scalar, opacity, midpoint, isSharp ? random.Uniform() : 0.0);
    t.Color->AddRGBPoint(
      scalar + random.Uniform(-0.05, 0.05), random.Uniform(), random.Uniform(), random.Uniform());
  }
  t.Table->SetUnitInterval(std::pow(10.0, random.Uniform(-8.0, 1.0)));
  return hasCurves;
}

struct WorstErrors
{
  double Mean = 0.0;
  double Color = 0.0;
};

void CompareEntry(Check& check, TestTable& t, const reference::TransferIntegral& truth, int front, int back,
  double tolerance, WorstErrors& worst)
{
  const double last = t.Table->GetSize() - 1.0;
  const auto exact = truth.Between(front / last, back / last, t.Attenuation());
  const float* entry = t.Entry(front, back);
  const double depth = entry[3] * std::abs(front - back) / last;
  worst.Mean = std::max(worst.Mean, std::abs(depth - exact.depth) / (exact.depth + 1.0e-30));
  for (int i = 0; i < 3; ++i)
  {
    const double color = exact.opacity > 0.0 ? exact.color[i] / exact.opacity : entry[i];
    worst.Color = std::max(worst.Color, std::abs(entry[i] - color));
  }
  check.Near("mean against quadrature", depth, exact.depth, tolerance * exact.depth);
}

void TestAgainstQuadrature(Check& check)
{
  RandomDirections random(3);
  WorstErrors worst;
  for (int n = 0; n < 40; ++n)
  {
    TestTable t(n % 4 == 0 ? 17 : 256);
    // lines are exact, up to the quadrature's tolerance; a sharp curve is 16 lines with 4 parts each, where it
    // has the relative error of an eleventh power near its flat end
    const double tolerance = MakeFunctions(random, t) ? 0.02 : 1.0e-4;
    t.Table->Update();
    const reference::TransferIntegral truth(t.Opacity, t.Color, 1.0e-4);
    for (int i = 0; i < 8; ++i)
    {
      const int front = static_cast<int>(random.Uniform(0.0, t.Table->GetSize()));
      const int back = static_cast<int>(random.Uniform(0.0, t.Table->GetSize()));
      if (front != back)
      {
        CompareEntry(check, t, truth, front, back, tolerance, worst);
      }
    }
  }
  std::cout << "against quadrature: mean " << worst.Mean << ", colour " << worst.Color << std::endl;
  // within a part that is opaque itself, colour is linear in the optical depth, not in the scalar
  check.AtMost("colour against quadrature", worst.Color, 1.0 / 255.0);
}

// Finite, opacity in [0, 1], colours among the function's; more attenuation never less opacity.
void CheckSegment(Check& check, TestTable& thin, TestTable& dense, double front, double back)
{
  double rgba[4];
  thin.Table->GetEntry(front, back, rgba);
  double denser[4];
  dense.Table->GetEntry(front, back, denser);
  const double step =
    std::abs(thin.Table->GetNormalizedScalar(back) - thin.Table->GetNormalizedScalar(front));
  const double opacity = optics::SegmentOpacity(rgba[3], step);
  check.AtLeast("opacity", opacity, 0.0);
  check.AtMost("opacity", opacity, 1.0);
  check.AtLeast("monotone in attenuation", optics::SegmentOpacity(denser[3], step), opacity);
  for (int i = 0; i < 3; ++i)
  {
    check.AtLeast("colour", rgba[i], 0.0);
    check.AtMost("colour", rgba[i], 1.0 + 1.0e-6);
  }
}

void TestProperties(Check& check)
{
  for (int n = 0; n < 60; ++n)
  {
    const int size = n % 3 == 0 ? 2 : n % 3 == 1 ? 33 : 200;
    TestTable thin(size);
    TestTable dense(size);
    RandomDirections functions(100 + n);
    MakeFunctions(functions, thin);
    functions = RandomDirections(100 + n);
    MakeFunctions(functions, dense);
    dense.Table->SetUnitInterval(thin.Table->GetUnitInterval() / 3.0);
    for (TestTable* t : { &thin, &dense })
    {
      t->Table->SetSegmentLength(n % 5 == 0 ? 2.0 : 0.0);
      t->Table->Update();
    }
    for (int i = 0; i < 100; ++i)
    {
      const double front = functions.Uniform(-0.1, 1.1);
      const double change = i % 3 == 0 ? 0.0 : std::pow(10.0, functions.Uniform(-9.0, 0.0));
      CheckSegment(check, thin, dense, front, i % 2 == 0 ? front + change : front - change);
    }
  }
}
}

int TestPreIntegratedTableRandom(int, char*[])
{
  Check check;
  TestAgainstQuadrature(check);
  TestProperties(check);
  return check.ExitCode();
}
