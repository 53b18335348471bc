// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// A covering array: rows of choices, one of each term, so that any two (or three, ...) terms are drawn with every
// combination of their choices that is allowed. Greedy, and the same each time.

#ifndef CoveringArray_h
#define CoveringArray_h

#include <algorithm>
#include <cstdint>
#include <functional>
#include <unordered_set>
#include <utility>
#include <vector>

namespace
{
using Combination = std::vector<int>; // a choice of each term; -1: not chosen yet

class CoveringArray
{
public:
  using PairTest = std::function<bool(int term, int choice, int otherTerm, int otherChoice)>;

  // choices: how many each term has. isAllowed: whether two choices may be in one row.
  CoveringArray(const std::vector<int>& choices, int strength, const PairTest& isAllowed)
    : Choices(choices)
    , IsAllowed(isAllowed)
    , SetsOfTerm(choices.size())
  {
    std::vector<int> terms;
    this->AddSets(terms, std::min(strength, static_cast<int>(choices.size())));
    for (const Tuple tuple : this->All)
    {
      if (this->Missing.count(tuple) > 0)
      {
        this->AddRow(tuple);
      }
    }
  }

  const std::vector<Combination>& GetRows() const { return this->Rows; }

  // Combinations whose pairs are allowed, but which no row can hold.
  int GetNumberOfImpossible() const { return this->Impossible; }

private:
  using Tuple = std::uint64_t; // a few terms, ascending, and their choices

  // Six bits each; up to five terms.
  static Tuple Extended(Tuple tuple, int term, int choice)
  {
    return (tuple << 12U) | static_cast<Tuple>((term + 1) << 6U | choice); // a term is never 0
  }

  void AddSets(std::vector<int>& terms, int more)
  {
    if (more == 0)
    {
      this->AddTuples(terms, Combination(this->Choices.size(), -1), 0, 0);
      for (const int term : terms)
      {
        this->SetsOfTerm[term].push_back(terms);
      }
      return;
    }
    for (int term = terms.empty() ? 0 : terms.back() + 1; term < static_cast<int>(this->Choices.size());
         ++term)
    {
      terms.push_back(term);
      this->AddSets(terms, more - 1);
      terms.pop_back();
    }
  }

  void AddTuples(const std::vector<int>& terms, Combination row, std::size_t place, Tuple tuple)
  {
    if (place == terms.size())
    {
      this->All.push_back(tuple);
      this->Missing.insert(tuple);
      return;
    }
    const int term = terms[place];
    for (int choice = 0; choice < this->Choices[term]; ++choice)
    {
      if (this->Fits(row, term, choice))
      {
        row[term] = choice;
        this->AddTuples(terms, row, place + 1, Extended(tuple, term, choice));
        row[term] = -1;
      }
    }
  }

  Combination RowOf(Tuple tuple) const
  {
    Combination row(this->Choices.size(), -1);
    for (; tuple != 0; tuple >>= 12U)
    {
      row[((tuple >> 6U) & 63U) - 1] = static_cast<int>(tuple & 63U);
    }
    return row;
  }

  // Around a combination; the best of some attempts, which take the other terms in another order.
  void AddRow(Tuple seed)
  {
    std::unordered_set<Tuple> best;
    Combination bestRow;
    for (int attempt = 0; attempt < 8; ++attempt)
    {
      Combination row = this->RowOf(seed);
      std::unordered_set<Tuple> found;
      if (this->Fill(row, this->OrderOfOthers(row), 0))
      {
        found = this->MissingIn(row);
      }
      if (found.size() > best.size())
      {
        best = found;
        bestRow = row;
      }
    }
    if (best.empty())
    {
      this->Missing.erase(seed);
      ++this->Impossible;
      return;
    }
    this->Rows.push_back(bestRow);
    for (const Tuple tuple : best)
    {
      this->Missing.erase(tuple);
    }
  }

  std::vector<int> OrderOfOthers(const Combination& row)
  {
    std::vector<int> order;
    for (std::size_t term = 0; term < row.size(); ++term)
    {
      if (row[term] < 0)
      {
        order.push_back(static_cast<int>(term));
      }
    }
    for (std::size_t i = order.size(); i > 1; --i)
    {
      std::swap(order[i - 1], order[this->Random() % i]);
    }
    return order;
  }

  // The choice that adds most first; another one where the rest of the row would have none.
  bool Fill(Combination& row, const std::vector<int>& order, std::size_t place) const
  {
    if (place == order.size())
    {
      return true;
    }
    const int term = order[place];
    std::vector<std::pair<int, int>> choices; // minus what it adds, and itself
    for (int choice = 0; choice < this->Choices[term]; ++choice)
    {
      if (this->Fits(row, term, choice))
      {
        row[term] = choice;
        int added = 0;
        this->ForEachMissing(row, term, [&](Tuple) { ++added; });
        choices.emplace_back(-added, choice);
        row[term] = -1;
      }
    }
    std::sort(choices.begin(), choices.end());
    for (const auto& added : choices)
    {
      row[term] = added.second;
      if (this->Fill(row, order, place + 1))
      {
        return true;
      }
      row[term] = -1;
    }
    return false;
  }

  bool Fits(const Combination& row, int term, int choice) const
  {
    for (int other = 0; other < static_cast<int>(row.size()); ++other)
    {
      if (other != term && row[other] >= 0 && !this->IsAllowed(other, row[other], term, choice))
      {
        return false;
      }
    }
    return true;
  }

  // Of the sets that a term is in, and whose other terms are chosen.
  template <typename Function>
  void ForEachMissing(const Combination& row, int term, const Function& function) const
  {
    for (const std::vector<int>& terms : this->SetsOfTerm[term])
    {
      const bool isChosen =
        std::all_of(terms.begin(), terms.end(), [&](int member) { return row[member] >= 0; });
      Tuple tuple = 0;
      for (const int member : terms)
      {
        tuple = Extended(tuple, member, std::max(row[member], 0));
      }
      if (isChosen && this->Missing.count(tuple) > 0)
      {
        function(tuple);
      }
    }
  }

  std::unordered_set<Tuple> MissingIn(const Combination& row) const
  {
    std::unordered_set<Tuple> all;
    for (int term = 0; term < static_cast<int>(row.size()); ++term)
    {
      this->ForEachMissing(row, term, [&](Tuple tuple) { all.insert(tuple); });
    }
    return all;
  }

  // Numerical Recipes' linear congruence; its high bits.
  std::uint32_t Random()
  {
    this->State = 1664525U * this->State + 1013904223U;
    return this->State >> 8U;
  }

  std::vector<int> Choices;
  PairTest IsAllowed;
  std::vector<std::vector<std::vector<int>>> SetsOfTerm;
  std::vector<Tuple> All;
  std::unordered_set<Tuple> Missing;
  std::vector<Combination> Rows;
  int Impossible = 0;
  std::uint32_t State = 1;
};
}

#endif
