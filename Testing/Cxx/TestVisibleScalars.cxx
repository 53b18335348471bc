// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// What can be seen of a random table: whatever a look-up in single precision with linear interpolation finds in an
// interval must be told, and an interval that lies an entry off all that can be seen must be told as empty.

#include "Check.h"
#include "VisibleScalars.h"

#include <algorithm>
#include <random>
#include <vector>

namespace
{
struct Table
{
  std::vector<float> Entries;
  double Range[2];
  VisibleScalars::Ends Ends;

  // As a texture of linear interpolation, clamped to its edges.
  float LookUp(double scalar) const
  {
    const float scale = 1.0F / static_cast<float>(this->Range[1] - this->Range[0]);
    const float bias = -static_cast<float>(this->Range[0]) * scale;
    const float coordinate = static_cast<float>(scalar) * scale + bias;
    const float size = static_cast<float>(this->Entries.size());
    const float position =
      this->Ends == VisibleScalars::Ends::Edges ? coordinate * size - 0.5F : coordinate * (size - 1.0F);
    const float inside = std::clamp(position, 0.0F, size - 1.0F);
    const std::size_t entry = std::min(static_cast<std::size_t>(inside), this->Entries.size() - 2);
    const float part = inside - static_cast<float>(entry);
    return this->Entries[entry] * (1.0F - part) + this->Entries[entry + 1] * part;
  }
};

void CheckTable(Check& check, const Table& table, std::mt19937& random)
{
  const VisibleScalars visible(table.Entries, table.Range, table.Ends);
  const double width = table.Range[1] - table.Range[0];
  std::uniform_real_distribution<double> place(-0.1, 1.1), length(0.0, 0.05);
  int empty = 0;
  for (int i = 0; i < 300; ++i)
  {
    const double low = table.Range[0] + width * place(random), high = low + width * length(random);
    bool isSeen = false;
    for (int sample = 0; sample <= 200; ++sample)
    {
      isSeen |= table.LookUp(low + (high - low) * sample / 200.0) > 0.0F;
    }
    check.That(!isSeen || visible.HasAny(low, high), "what can be seen is told as empty");
    empty += visible.HasAny(low, high) ? 0 : 1;
  }
  check.That(empty > 30, "only " + std::to_string(empty) + " of 300 intervals are told as empty");
}

void TestRandomTables(Check& check)
{
  std::mt19937 random(7);
  const double ranges[][2] = { { 0.0, 1.0 }, { -1024.0, 3071.0 }, { 1.0e6, 1.0e6 + 1.0e3 },
    { 0.0, 1.0e-30 } };
  for (const auto& range : ranges)
  {
    for (const auto ends : { VisibleScalars::Ends::Edges, VisibleScalars::Ends::Centres })
    {
      Table table{ std::vector<float>(1024, 0.0F), { range[0], range[1] }, ends };
      std::uniform_int_distribution<int> entry(0, 1023);
      for (int i = 0; i < 20; ++i)
      {
        table.Entries[entry(random)] = 0.5F;
      }
      CheckTable(check, table, random);
    }
  }
}

// Entries that are seen with large gradients alone, against a look at each of them.
void TestGradients(Check& check)
{
  std::mt19937 random(11);
  const auto uniform = [&]() { return random() / 4294967296.0; };
  std::vector<float> table(300), least(300);
  for (std::size_t i = 0; i < table.size(); ++i)
  {
    table[i] = uniform() < 0.5 ? 0.0F : 0.5F;
    least[i] = static_cast<float>(0.2 + uniform());
  }
  const double range[2] = { 0.0, 299.0 }; // scalars are entries
  const VisibleScalars visible(table, range, VisibleScalars::Ends::Centres, least);
  check.That(visible.DependsOnGradient(), "depends on the gradient");
  check.That(
    !VisibleScalars(table, range, VisibleScalars::Ends::Centres).DependsOnGradient(), "does not depend");
  for (int i = 0; i < 2000; ++i)
  {
    const int low = static_cast<int>(299.0 * uniform()),
              high = std::min(low + static_cast<int>(20.0 * uniform()), 298);
    const float gradient = static_cast<float>(uniform());
    bool isSeen = false;
    for (int entry = low; entry <= high + 1; ++entry)
    {
      isSeen |= table[entry] > 0.0F && least[entry] <= gradient;
    }
    check.That(visible.HasAny(low + 0.1, high + 0.9, gradient) == isSeen, "seen with a gradient");
  }
}

// Half of the gradients up to the largest have an opacity of a half.
void TestMeanOpacity(Check& check)
{
  const double range[2] = { 0.0, 1.0 };
  VisibleScalars visible({ 0.4F, 0.4F }, range, VisibleScalars::Ends::Centres);
  check.Near("mean opacity", visible.MeanOpacity(0.0, 1.0, 0.5F), 0.4, 1.0e-6);
  std::vector<float> gradients(1000, 0.0F);
  std::fill(gradients.begin() + 250, gradients.end(), 0.5F);
  visible.SetGradientOpacities(gradients);
  check.Near("with small gradients", visible.MeanOpacity(0.0, 1.0, 0.2F), 0.0, 1.0e-12);
  check.Near("with gradients", visible.MeanOpacity(0.0, 1.0, 0.5F), 0.4 * 0.25, 1.0e-3);
}

// The background has the scalar at which opacity begins.
void TestEnds(Check& check)
{
  std::vector<float> ramp(1024);
  for (std::size_t i = 0; i < ramp.size(); ++i)
  {
    ramp[i] = static_cast<float>(i) / 1023.0F;
  }
  const double range[2] = { 0.0, 255.0 };
  const VisibleScalars visible(ramp, range, VisibleScalars::Ends::Edges);
  check.That(!visible.HasAny(0.0, 0.0), "the first scalar has no opacity");
  check.That(!visible.HasAny(-10.0, 0.0), "scalars below have none");
  check.That(visible.HasAny(0.0, 1.0), "the next scalar has one");
  check.That(visible.HasAny(255.0, 1.0e30), "scalars above have one");
  check.That(visible.HasNaN(), "a coordinate that is no number may end at the last entry");
  ramp.back() = 0.0F;
  check.That(!VisibleScalars(ramp, range, VisibleScalars::Ends::Edges).HasNaN(), "both ends are clear");
}
}

int TestVisibleScalars(int, char*[])
{
  Check check;
  TestRandomTables(check);
  TestGradients(check);
  TestMeanOpacity(check);
  TestEnds(check);
  return check.ExitCode();
}
