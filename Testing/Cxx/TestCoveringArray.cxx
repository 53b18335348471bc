// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// A covering array of any strength holds every combination that some allowed row has, in few rows, and the same ones each
// time; what is excluded is in none of them.

#include "Check.h"
#include "CoveringArray.h"

#include <set>
#include <string>

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

bool IsAllowedRow(const Combination& row)
{
  for (int i = 0; i < static_cast<int>(row.size()); ++i)
  {
    for (int j = 0; j < i; ++j)
    {
      if (!IsAllowedEitherWay(i, row[i], j, row[j]))
      {
        return false;
      }
    }
  }
  return true;
}

// Every row there is.
std::vector<Combination> AllowedRows()
{
  std::vector<Combination> rows;
  int count = 1;
  for (const int choices : Choices)
  {
    count *= choices;
  }
  for (int number = 0; number < count; ++number)
  {
    Combination row;
    int rest = number;
    for (const int choices : Choices)
    {
      row.push_back(rest % choices);
      rest /= choices;
    }
    if (IsAllowedRow(row))
    {
      rows.push_back(row);
    }
  }
  return rows;
}

// Terms and choices of so many terms of a row, each of them.
void AddTuples(const Combination& row, int strength, std::size_t first, const Combination& begun,
  std::set<Combination>& tuples)
{
  if (strength == 0)
  {
    tuples.insert(begun);
    return;
  }
  for (std::size_t term = first; term < row.size(); ++term)
  {
    Combination more = begun;
    more.push_back(static_cast<int>(term));
    more.push_back(row[term]);
    AddTuples(row, strength - 1, term + 1, more, tuples);
  }
}

std::set<Combination> TuplesOf(const std::vector<Combination>& rows, int strength)
{
  std::set<Combination> tuples;
  for (const Combination& row : rows)
  {
    AddTuples(row, strength, 0, {}, tuples);
  }
  return tuples;
}

// mostRows: what is known of the largest terms, and a few more
void CheckStrength(Check& check, int strength, int mostRows)
{
  const CoveringArray array(Choices, strength, IsAllowedEitherWay);
  const std::vector<Combination>& rows = array.GetRows();
  const std::string name = "strength " + std::to_string(strength) + ": ";
  check.That(TuplesOf(rows, strength) == TuplesOf(AllowedRows(), strength),
    name + "a combination is missing, or one that is excluded is there");
  check.That(std::all_of(rows.begin(), rows.end(), IsAllowedRow), name + "a row has what is excluded");
  check.AtMost(name + "rows", static_cast<double>(rows.size()), mostRows);
  check.That(rows == CoveringArray(Choices, strength, IsAllowedEitherWay).GetRows(),
    name + "another array the second time");
  check.That(rows != CoveringArray(Choices, strength, IsAllowedEitherWay, 2).GetRows(),
    name + "the same array from another seed");
}

// As many terms as the mapper has, at the strength of the long run: takes a second at most.
void CheckManyTerms(Check& check)
{
  const int terms = 36, choices = 3;
  const auto isAllowed = [](int term, int choice, int other, int otherChoice) {
    return (term + other) % 7 != 0 || choice == 0 || otherChoice == 0;
  };
  const CoveringArray array(std::vector<int>(terms, choices), 3, isAllowed);
  std::size_t expected = 0;
  for (int number = 0; number < terms * terms * terms * 27; ++number)
  {
    const int i = number / 27 % terms, j = number / 27 / terms % terms, k = number / 27 / terms / terms;
    const int a = number % 3, b = number / 3 % 3, c = number / 9 % 3;
    expected +=
      i < j && j < k && isAllowed(i, a, j, b) && isAllowed(i, a, k, c) && isAllowed(j, b, k, c) ? 1 : 0;
  }
  check.Near("triples of many terms", static_cast<double>(TuplesOf(array.GetRows(), 3).size()),
    static_cast<double>(expected), 0.0);
  check.Near("triples that no row can hold", array.GetNumberOfImpossible(), 0.0, 0.0); // 0 goes with all
}
}

int TestCoveringArray(int, char*[])
{
  Check check;
  CheckStrength(check, 2, 28);  // 20 pairs of the largest two terms
  CheckStrength(check, 3, 120); // 80 triples of the largest three
  CheckStrength(check, 4, 400); // 240 of the largest four
  // 0 of term 4 with 2 of term 7, by way of term 6
  check.Near("pairs that no row can hold",
    CoveringArray(Choices, 2, IsAllowedEitherWay).GetNumberOfImpossible(), 1.0, 0.0);
  CheckManyTerms(check);
  return check.ExitCode();
}
