// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The rows of a covering array of terms, each of which is judged; a faulty one is reduced to what the fault needs.

#ifndef CombinationRun_h
#define CombinationRun_h

#include "Combinations.h"
#include "CommandLine.h"

namespace
{
// What is wrong with a row; empty: nothing. number: of the row, or -1 where it is being reduced.
using Judge = std::function<std::string(const Combination& row, int number)>;

inline void CheckCombination(Check& check, const std::vector<Term>& terms,
  const std::vector<Exclusion>& exclusions, const Judge& judge, const Combination& row, int number)
{
  const std::string fault = judge(row, number);
  if (check.That(fault.empty(), "row " + std::to_string(number) + " (" + NameOf(terms, row) + "): " + fault))
  {
    return;
  }
  const Combination less =
    Reduced(terms, exclusions, row, [&](const Combination& other) { return !judge(other, -1).empty(); });
  std::cout << "with fewer choices, " << NameOf(terms, less) << ": " << judge(less, -1) << std::endl;
}

// --strength N: every N choices, not 2; --part I N: one of N parts of the rows; --row I: this one alone; --list:
// names the rows.
inline void RunCombinations(Check& check, const CommandLine& line, const std::vector<Term>& terms,
  const std::vector<Exclusion>& exclusions, const Judge& judge)
{
  const CoveringArray array = Cover(terms, exclusions, line.GetNumber("--strength", 0, 2));
  const std::vector<Combination>& rows = array.GetRows();
  const int part = line.GetNumber("--part", 0, 1), parts = line.GetNumber("--part", 1, 1);
  const int only = line.GetNumber("--row", 0, -1);
  std::cout << rows.size() << " rows; " << array.GetNumberOfImpossible() << " combinations in none of them\n";
  for (int i = 0; i < static_cast<int>(rows.size()); ++i)
  {
    if (line.Has("--list"))
    {
      std::cout << i << ": " << NameOf(terms, rows[i]) << '\n';
    }
    else if (only < 0 ? i % parts == part - 1 : i == only)
    {
      CheckCombination(check, terms, exclusions, judge, rows[i], i);
    }
  }
}
}

#endif
