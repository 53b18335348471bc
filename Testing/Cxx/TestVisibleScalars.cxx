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
  TestEnds(check);
  return check.ExitCode();
}
