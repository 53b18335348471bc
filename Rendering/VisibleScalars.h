// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Which scalars can be seen: where the opacity that a ray looks up, in a table of entries with linear
// interpolation, may differ from zero. An interval of scalars is answered in O(1), by a prefix sum over the
// entries. Errs on the side of what can be seen.

#ifndef VisibleScalars_h
#define VisibleScalars_h

#include <vector>

class VisibleScalars
{
public:
  VisibleScalars() = default;

  /**
   * table: the opacities. coordinateRange: the scalars at the table's coordinates 0 and 1, which are the outer
   * edges of its first and last entry (as a texture's are) or their centres.
   */
  enum class Ends
  {
    Edges,
    Centres
  };
  VisibleScalars(const std::vector<float>& table, const double coordinateRange[2], Ends ends);

  /** Whether any scalar from low to high can be seen; low <= high. */
  bool HasAny(double low, double high) const;

  /** The mean opacity of the entries that scalars from low to high look up; low <= high. */
  double MeanOpacity(double low, double high) const;

  /**
   * Whether a scalar that is no number can be seen. Where a look-up by such a coordinate ends is left to the
   * driver: at one of the table's ends, or in a NaN, which VTK does not draw.
   */
  bool HasNaN() const;
  void ShowNaN() { this->ShowsNaN = true; } // for reasons of the caller's

  bool operator==(const VisibleScalars& other) const;

private:
  int Clamp(double position) const;

  std::vector<int> Below;             // number of entries below this one that are not zero
  std::vector<double> OpacitiesBelow; // their sum
  double Origin = 0.0;                // scalar to position in the table, in entries
  double Scale = 0.0;
  double Slack = 0.0;
  bool ShowsNaN = false;
};

#endif
