// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Which scalars can be seen: where the opacity that a ray looks up, in a table of entries with linear
// interpolation, may differ from zero. What is seen may depend on the gradient's magnitude too: each entry has the least
// one with which it is. An interval of scalars is answered in O(1), by the least of the entries in each interval whose
// length is a power of two. Errs on the side of what can be seen.

#ifndef VisibleScalars_h
#define VisibleScalars_h

#include <vector>

class VisibleScalars
{
public:
  VisibleScalars() = default;

  /**
   * table: the opacities. coordinateRange: the scalars at the table's coordinates 0 and 1, which are the outer
   * edges of its first and last entry (as a texture's are) or their centres. leastGradients: of each entry the least
   * gradient magnitude, in [0, 1], with which it is seen; empty where any will do.
   */
  enum class Ends
  {
    Edges,
    Centres
  };
  VisibleScalars(const std::vector<float>& table, const double coordinateRange[2], Ends ends,
    const std::vector<float>& leastGradients = {});

  /** Of an entry, which textures divide into at least 256 parts. */
  static constexpr double LookUpSlack = 1.0 / 128.0;

  /** Whether any scalar from low to high can be seen, with a gradient magnitude up to this one; low <= high. */
  bool HasAny(double low, double high, float gradient = 1.0F) const;

  /** Whether some scalars are seen with a large gradient alone. */
  bool DependsOnGradient() const;

  /** For the mean opacity alone: what opacities are multiplied by with gradient magnitudes from 0 to 1. */
  void SetGradientOpacities(const std::vector<float>& table);

  /**
   * The mean opacity of the entries that scalars from low to high look up, times that of gradient magnitudes up to this
   * one; low <= high.
   */
  double MeanOpacity(double low, double high, float gradient = 1.0F) const;

  /**
   * Whether a scalar that is no number can be seen. Where a look-up by such a coordinate ends is left to the
   * driver: at one of the table's ends, or in a NaN, which VTK does not draw.
   */
  bool HasNaN() const;
  void ShowNaN() { this->ShowsNaN = true; } // for reasons of the caller's

  bool operator==(const VisibleScalars& other) const;

private:
  int Clamp(double position) const;
  void JoinEntries();

  std::vector<std::vector<float>>
    Least; // gradient with which any of 1, 2, 4, ... entries from this one on is seen
  std::vector<double> OpacitiesBelow; // sum of the entries below this one
  std::vector<double> GradientOpacitiesBelow;
  double Origin = 0.0; // scalar to position in the table, in entries
  double Scale = 0.0;
  double Slack = 0.0;
  bool ShowsNaN = false;
};

#endif
