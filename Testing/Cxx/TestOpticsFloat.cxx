// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Every formula in float against the same in double: over its domain and at the edges.

#include "TestedFunctions.h"

int TestOpticsFloat(int, char*[])
{
  Check check;
  Comparison comparison;
  for (const FunctionCase& c : CasesOfFunctions().Cases)
  {
    const glm::vec4 value =
      opticsFloat::Evaluate(c.Function, { c.Normal, c.ToLight, c.ToViewer, c.Major, c.P });
    comparison.Add(check, c, glm::dvec4(value), &TestedFunction::FloatUnits);
  }
  comparison.Print(check, &TestedFunction::FloatUnits);
  return check.ExitCode();
}
