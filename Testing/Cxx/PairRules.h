// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Which choices two terms may have in one row of a covering array.

#ifndef PairRules_h
#define PairRules_h

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace
{
class PairRules
{
public:
  using Test = std::function<bool(int term, int choice, int otherTerm, int otherChoice)>;
  using Choices = std::uint64_t;        // of a term, a bit each
  using Domains = std::vector<Choices>; // those that each term still may have

  PairRules(const std::vector<int>& choices, const Test& isAllowed)
    : All(choices.size())
    , Partners(choices.size())
  {
    const int terms = static_cast<int>(choices.size());
    for (int term = 0; term < terms; ++term)
    {
      this->All[term] = ~Choices(0) >> (64 - choices[term]);
      for (int choice = 0; choice < choices[term]; ++choice)
      {
        this->Partners[term].emplace_back(terms);
        for (int other = 0; other < terms; ++other)
        {
          Choices& partners = this->Partners[term].back()[other];
          for (int otherChoice = 0; otherChoice < choices[other]; ++otherChoice)
          {
            const bool holds = other == term || isAllowed(term, choice, other, otherChoice);
            partners |= Choices(holds) << otherChoice;
          }
        }
      }
    }
  }

  const Domains& GetAll() const { return this->All; }

  bool AreAllowed(int term, int choice, int other, int otherChoice) const
  {
    return (this->Partners[term][choice][other] >> otherChoice & 1U) != 0;
  }

  // Takes away what no longer goes with any choice of some other term; false where a term is left without one.
  bool Choose(Domains& domains, int term, int choice) const
  {
    domains[term] &= Choices(1) << choice;
    std::vector<int> changed = { term };
    while (!changed.empty() && domains[term] != 0)
    {
      const int last = changed.back();
      changed.pop_back();
      for (int other = 0; other < static_cast<int>(domains.size()); ++other)
      {
        const Choices left =
          other == last ? domains[other] : domains[other] & this->PartnersOf(domains, last, other);
        if (left == 0)
        {
          return false;
        }
        if (left != domains[other])
        {
          domains[other] = left;
          changed.push_back(other);
        }
      }
    }
    return domains[term] != 0;
  }

private:
  Choices PartnersOf(const Domains& domains, int term, int other) const
  {
    Choices partners = 0;
    for (std::size_t choice = 0; choice < this->Partners[term].size(); ++choice)
    {
      partners |= (domains[term] >> choice & 1U) != 0 ? this->Partners[term][choice][other] : 0;
    }
    return partners;
  }

  Domains All;
  std::vector<std::vector<std::vector<Choices>>> Partners; // of term and choice, in each other term
};
}

#endif
