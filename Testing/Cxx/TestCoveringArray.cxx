// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// A covering array holds what it says, in few rows, and the same ones each time; what is excluded is in none of them.

#include "Check.h"
#include "CoveringArray.h"

namespace
{
const std::vector<int> Choices = { 3, 1, 4, 2, 5, 2, 3, 4 };

// 3 of term 2 and 1 of term 5; and whoever takes 0 of term 4 needs 0 of term 6, which excludes 2 of term 7.
bool IsAllowed(int term, int choice, int other, int otherChoice)
{
  const auto are = [&](int a, int b) { return term == a && other == b; };
  return !(are(2, 5) && choice == 3 && otherChoice == 1) && !(are(4, 6) && choice == 0 && otherChoice > 0) &&
    !(are(6, 7) && choice == 0 && otherChoice == 2);
}

bool IsAllowedEitherWay(int term, int choice, int other, int otherChoice)
{
  return term < other ? IsAllowed(term, choice, other, otherChoice)
                      : IsAllowed(other, otherChoice, term, choice);
}

int CountRows(
  const std::vector<Combination>& rows, const std::vector<int>& terms, const std::vector<int>& choices)
{
  return static_cast<int>(std::count_if(rows.begin(), rows.end(), [&](const Combination& row) {
    bool holds = true;
    for (std::size_t i = 0; i < terms.size(); ++i)
    {
      holds &= row[terms[i]] == choices[i];
    }
    return holds;
  }));
}

void CheckPairs(Check& check)
{
  const CoveringArray array(Choices, 2, IsAllowedEitherWay);
  const std::vector<Combination>& rows = array.GetRows();
  check.That(
    rows == CoveringArray(Choices, 2, IsAllowedEitherWay).GetRows(), "another array the second time");
  check.AtMost("rows", static_cast<double>(rows.size()), 28.0); // 20 pairs of the largest two terms
  int impossible = 0;
  const int terms = static_cast<int>(Choices.size());
  for (int i = 0; i < terms; ++i)
  {
    for (int j = i + 1; j < terms; ++j)
    {
      for (int pair = 0; pair < Choices[i] * Choices[j]; ++pair)
      {
        const int a = pair % Choices[i], b = pair / Choices[i];
        const bool isMissing = CountRows(rows, { i, j }, { a, b }) == 0;
        const bool isAllowed = IsAllowed(i, a, j, b);
        impossible += isAllowed && isMissing ? 1 : 0;
        check.That(isAllowed || isMissing, "a row has what is excluded");
      }
    }
  }
  // 0 of term 4 with 2 of term 7, by way of term 6
  check.Near("pairs that no row can hold", impossible, 1.0, 0.0);
  check.Near("pairs that are said to be impossible", array.GetNumberOfImpossible(), 1.0, 0.0);
}

void CheckTriples(Check& check)
{
  const auto always = [](int, int, int, int) { return true; };
  const std::vector<int> choices = { 2, 3, 4, 2, 3 };
  const std::vector<Combination> rows = CoveringArray(choices, 3, always).GetRows();
  for (int triple = 0; triple < 3 * 4 * 3; ++triple)
  {
    check.AtLeast("a triple", CountRows(rows, { 1, 2, 4 }, { triple % 3, triple / 3 % 4, triple / 12 }), 1.0);
  }
  check.AtMost("rows of triples", static_cast<double>(rows.size()), 54.0); // 36 triples of the largest terms
}
}

int TestCoveringArray(int, char*[])
{
  Check check;
  CheckPairs(check);
  CheckTriples(check);
  return check.ExitCode();
}
