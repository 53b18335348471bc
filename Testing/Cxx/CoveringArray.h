// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// A covering array: rows of choices, one of each term, so that any two (or three, ...) terms are drawn with every
// combination of their choices that is allowed. Row by row, each around a combination that is still missing and with the
// choices that add most, as in [Cohen1997]; and the same each time.

#ifndef CoveringArray_h
#define CoveringArray_h

#include "PairRules.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace
{
using Combination = std::vector<int>; // a choice of each term; -1: not chosen yet

class CoveringArray
{
public:
  // choices: how many each term has, up to 64. isAllowed: whether two choices may be in one row.
  CoveringArray(
    const std::vector<int>& choices, int strength, const PairRules::Test& isAllowed, std::uint32_t seed = 1)
    : Choices(choices)
    , Rules(choices, isAllowed)
    , SetsOfTerm(choices.size())
    , State(seed)
  {
    std::vector<int> terms;
    this->AddSets(terms, std::min(strength, static_cast<int>(choices.size())));
    for (const Set& set : this->Sets)
    {
      for (std::size_t tuple = 0; tuple < set.Count; ++tuple)
      {
        if (this->Missing[set.First + tuple] != 0)
        {
          this->AddRow(set, tuple);
        }
      }
    }
  }

  const std::vector<Combination>& GetRows() const { return this->Rows; }

  // Combinations whose pairs are allowed, but which no row can hold.
  int GetNumberOfImpossible() const { return this->Impossible; }

private:
  // Some terms, and where the combinations of their choices begin; the last term's choice counts fastest.
  struct Set
  {
    std::vector<int> Terms;
    std::size_t First;
    std::size_t Count;
  };

  void AddSets(std::vector<int>& terms, int more)
  {
    if (more == 0)
    {
      this->AddSet(terms);
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

  void AddSet(const std::vector<int>& terms)
  {
    Set set = { terms, this->Missing.size(), 1 };
    for (const int term : terms)
    {
      set.Count *= static_cast<std::size_t>(this->Choices[term]);
      this->SetsOfTerm[term].push_back(this->Sets.size());
    }
    for (std::size_t tuple = 0; tuple < set.Count; ++tuple)
    {
      this->Missing.push_back(this->AreAllowed(this->ChoicesOf(set, tuple), terms) ? 1 : 0);
    }
    this->Sets.push_back(set);
  }

  Combination ChoicesOf(const Set& set, std::size_t tuple) const
  {
    Combination row(this->Choices.size(), -1);
    for (auto term = set.Terms.rbegin(); term != set.Terms.rend(); ++term)
    {
      const auto count = static_cast<std::size_t>(this->Choices[*term]);
      row[*term] = static_cast<int>(tuple % count);
      tuple /= count;
    }
    return row;
  }

  bool AreAllowed(const Combination& row, const std::vector<int>& terms) const
  {
    for (std::size_t i = 0; i < terms.size(); ++i)
    {
      for (std::size_t j = 0; j < i; ++j)
      {
        if (!this->Rules.AreAllowed(terms[i], row[terms[i]], terms[j], row[terms[j]]))
        {
          return false;
        }
      }
    }
    return true;
  }

  // Around a combination; the best of some attempts, which take the other terms in another order.
  void AddRow(const Set& set, std::size_t tuple)
  {
    const Combination seed = this->ChoicesOf(set, tuple);
    PairRules::Domains domains = this->Rules.GetAll();
    bool isPossible = std::all_of(set.Terms.begin(), set.Terms.end(),
      [&](int term) { return this->Rules.Choose(domains, term, seed[term]); });
    Combination best;
    int most = 0;
    for (int attempt = 0; attempt < 8 && isPossible; ++attempt)
    {
      Combination row = seed;
      isPossible = this->Fill(row, domains, this->OrderOfOthers(row), 0);
      const int found = isPossible ? this->CountMissing(row) : 0;
      if (found > most)
      {
        most = found;
        best = row;
      }
    }
    if (!isPossible)
    {
      this->Missing[set.First + tuple] = 0;
      ++this->Impossible;
      return;
    }
    this->Rows.push_back(best);
    for (const Set& covered : this->Sets)
    {
      this->Missing[this->PlaceOf(covered, best)] = 0;
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
  bool Fill(Combination& row, const PairRules::Domains& domains, const std::vector<int>& order,
    std::size_t place) const
  {
    if (place == order.size())
    {
      return true;
    }
    const int term = order[place];
    for (const auto& added : this->ChoicesByGain(row, domains[term], term))
    {
      PairRules::Domains left = domains;
      row[term] = added.second;
      if (this->Rules.Choose(left, term, added.second) && this->Fill(row, left, order, place + 1))
      {
        return true;
      }
    }
    row[term] = -1;
    return false;
  }

  // Minus the number of missing combinations that each choice adds to the row, and the choice.
  std::vector<std::pair<int, int>> ChoicesByGain(
    const Combination& row, PairRules::Choices domain, int term) const
  {
    std::vector<std::pair<int, int>> gains;
    for (int choice = 0; choice < this->Choices[term]; ++choice)
    {
      if ((domain >> choice & 1U) != 0)
      {
        gains.emplace_back(0, choice);
      }
    }
    Combination with = row;
    with[term] = 0;
    for (const std::size_t number : this->SetsOfTerm[term])
    {
      const Set& set = this->Sets[number];
      const bool isChosen =
        std::all_of(set.Terms.begin(), set.Terms.end(), [&](int member) { return with[member] >= 0; });
      if (isChosen)
      {
        const std::size_t place = this->PlaceOf(set, with), step = this->StepOf(set, term);
        for (auto& gain : gains)
        {
          gain.first -= this->Missing[place + gain.second * step];
        }
      }
    }
    std::sort(gains.begin(), gains.end());
    return gains;
  }

  std::size_t PlaceOf(const Set& set, const Combination& row) const
  {
    std::size_t tuple = 0;
    for (const int term : set.Terms)
    {
      tuple = tuple * static_cast<std::size_t>(this->Choices[term]) + static_cast<std::size_t>(row[term]);
    }
    return set.First + tuple;
  }

  // From one choice of a term to its next.
  std::size_t StepOf(const Set& set, int term) const
  {
    std::size_t step = 1;
    for (auto member = set.Terms.rbegin(); *member != term; ++member)
    {
      step *= static_cast<std::size_t>(this->Choices[*member]);
    }
    return step;
  }

  int CountMissing(const Combination& row) const
  {
    int count = 0;
    for (const Set& set : this->Sets)
    {
      count += this->Missing[this->PlaceOf(set, row)];
    }
    return count;
  }

  // Numerical Recipes' linear congruence; its high bits.
  std::uint32_t Random()
  {
    this->State = 1664525U * this->State + 1013904223U;
    return this->State >> 8U;
  }

  std::vector<int> Choices;
  PairRules Rules;
  std::vector<Set> Sets;
  std::vector<std::vector<std::size_t>> SetsOfTerm;
  std::vector<unsigned char> Missing; // of each combination of each set: 1 until a row has it
  std::vector<Combination> Rows;
  int Impossible = 0;
  std::uint32_t State;
};
}

#endif
