// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Which choices of two of the mapper's terms do not go together, and rows of those that do.

#ifndef Combinations_h
#define Combinations_h

#include "CombinationTerms.h"
#include "CoveringArray.h"

namespace
{
// Two terms' choices that do not go together; no names: all but the first.
struct Exclusion
{
  const char* Term;
  std::vector<const char*> Choices;
  const char* OtherTerm;
  std::vector<const char*> OtherChoices;
};

// What is refused (docs/support.md), and what would be drawn without one of the two.
const std::vector<Exclusion> Exclusions = {
  { "frames", {}, "reflectance", { "VTK", "not shaded", "None", "BlinnPhong" } },
  { "extinction gradient", {}, "reflectance", { "VTK", "not shaded", "None" } },
  { "specular", {}, "reflectance", { "VTK", "not shaded", "None" } },
  { "phase function", {}, "reflectance", { "VTK", "not shaded" } },
  { "transmitted light", {}, "reflectance", { "not shaded" } },
  { "lighting function", {}, "reflectance", { "not shaded" } },
  { "lighting function", { "hybrid normals" }, "reflectance", { "None" } },
  { "lighting function", { "hybrid normals" }, "opacity", { "2D" } },
  { "lighting knobs", {}, "lighting function", { "none" } },
  { "lighting knobs", {}, "reflectance", { "not shaded" } },
  { "shadows", {}, "reflectance", { "not shaded" } },
  { "shadows", {}, "lights", { "none" } },
  { "silhouette", {}, "integral", { "VTK's", "pre-integrated" } },
  { "transmitted light", {}, "integral", { "VTK's", "pre-integrated" } },
  { "isosurfaces", {}, "integral", { "VTK's", "pre-integrated" } },
  { "integral", {}, "opacity", { "2D" } },
  { "silhouette", {}, "opacity", { "2D" } },
  { "transmitted light", {}, "opacity", { "2D" } },
  { "isosurfaces", {}, "opacity", { "2D" } },
  { "integral", {}, "mask", { "labels" } },
  { "silhouette", {}, "mask", { "labels" } },
  { "transmitted light", {}, "mask", { "labels" } },
  { "isosurfaces", {}, "mask", { "labels" } },
  { "several samples", {}, "reflectance", { "BlinnPhong", "Ward", "Lafortune" } },
  { "several samples", {}, "integral", {} },
  { "several samples", {}, "silhouette", {} },
  { "several samples", {}, "transmitted light", {} },
  { "several samples", {}, "isosurfaces", {} },
  { "several samples", {}, "opacity", { "2D" } },
  { "several samples", {}, "frames", {} },
  { "several samples", {}, "extinction gradient", {} },
  { "several samples", {}, "specular", {} },
  { "opacity", { "2D" }, "mask",
    { "labels" } }, // VTK has no table of labels then, and draws what it finds instead
  { "data", { "lines" }, "reflectance", { "None", "BlinnPhong", "Ward", "Lafortune" } },
  { "data", { "lines" }, "integral", {} },
  { "data", { "lines" }, "silhouette", {} },
  { "data", { "lines" }, "transmitted light", {} },
  { "data", { "lines" }, "isosurfaces", {} },
  { "data", { "lines" }, "lighting function", {} },
  { "data", { "lines" }, "several samples", {} },
  { "data", { "lines" }, "lights", {} },
  { "data", { "lines" }, "mask", {} },
  { "data", { "lines" }, "matrix", { "uneven" } },
  { "data", { "cell data", "lines" }, "piece", {} }, // of other extents
  { "blocks", {}, "piece", {} },
  { "gathering", {}, "ambient light", { "white", "coloured" } },
  { "disk", {}, "ambient light", { "white", "coloured", "occlusion", "occlusion by 4", "occlusion by 16" } },
};

inline bool Names(const std::vector<const char*>& names, const Term& term, int choice)
{
  return names.empty() ? choice > 0 : std::any_of(names.begin(), names.end(), [&](const char* name) {
    return std::strcmp(name, term.Choices[choice].Name) == 0;
  });
}

inline bool IsExcluded(
  const Exclusion& exclusion, const Term& term, int choice, const Term& other, int otherChoice)
{
  return std::strcmp(exclusion.Term, term.Name) == 0 && std::strcmp(exclusion.OtherTerm, other.Name) == 0 &&
    Names(exclusion.Choices, term, choice) && Names(exclusion.OtherChoices, other, otherChoice);
}

inline bool GoTogether(
  const std::vector<Exclusion>& exclusions, const Term& term, int choice, const Term& other, int otherChoice)
{
  return std::none_of(exclusions.begin(), exclusions.end(), [&](const Exclusion& exclusion) {
    return IsExcluded(exclusion, term, choice, other, otherChoice) ||
      IsExcluded(exclusion, other, otherChoice, term, choice);
  });
}

inline CoveringArray Cover(
  const std::vector<Term>& terms, const std::vector<Exclusion>& exclusions, int strength)
{
  std::vector<int> choices;
  choices.reserve(terms.size());
  for (const Term& term : terms)
  {
    choices.push_back(static_cast<int>(term.Choices.size()));
  }
  return CoveringArray(choices, strength, [&](int term, int choice, int other, int otherChoice) {
    return GoTogether(exclusions, terms[term], choice, terms[other], otherChoice);
  });
}

// By the names of terms and choices that are not the default ones.
inline std::string NameOf(const std::vector<Term>& terms, const Combination& row)
{
  std::string name;
  for (std::size_t term = 0; term < terms.size(); ++term)
  {
    if (row[term] > 0)
    {
      name += (name.empty() ? "" : "; ") + std::string(terms[term].Name) + ": " +
        terms[term].Choices[row[term]].Name;
    }
  }
  return name.empty() ? "defaults" : name;
}

inline bool IsAllowed(
  const std::vector<Term>& terms, const std::vector<Exclusion>& exclusions, const Combination& row)
{
  for (std::size_t i = 0; i < terms.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      if (!GoTogether(exclusions, terms[i], row[i], terms[j], row[j]))
      {
        return false;
      }
    }
  }
  return true;
}

// The same fault with as many terms at their defaults as can be.
inline Combination Reduced(const std::vector<Term>& terms, const std::vector<Exclusion>& exclusions,
  Combination row, const std::function<bool(const Combination&)>& isFaulty)
{
  for (bool isLess = true; isLess;)
  {
    isLess = false;
    for (int& choice : row)
    {
      const int chosen = choice;
      choice = 0;
      const bool isStill = chosen > 0 && IsAllowed(terms, exclusions, row) && isFaulty(row);
      choice = isStill ? 0 : chosen;
      isLess |= isStill;
    }
  }
  return row;
}

inline void Apply(const std::vector<Term>& terms, const Combination& row, TestScene& scene)
{
  for (std::size_t term = 0; term < terms.size(); ++term)
  {
    terms[term].Choices[row[term]].Apply(scene);
  }
}
}

#endif
