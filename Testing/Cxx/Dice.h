// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Numbers at random that are the same everywhere, which those of the library's distributions are not.

#ifndef Dice_h
#define Dice_h

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

namespace
{
class Dice
{
public:
  explicit Dice(std::uint32_t seed)
    : Engine(seed)
  {
  }

  // In [0, count).
  int Number(int count) { return static_cast<int>(this->Engine() % static_cast<std::uint32_t>(count)); }
  bool Is(double probability) { return this->Between(0.0, 1.0) < probability; }
  double Between(double least, double largest)
  {
    return least + (largest - least) * (static_cast<double>(this->Engine()) / 4294967296.0);
  }
  double PowerOfTen(double least, double largest) { return std::pow(10.0, this->Between(least, largest)); }

  // Mostly in the range, sometimes at its ends, beyond them, or no number at all.
  double Setting(double least, double largest)
  {
    const double infinity = std::numeric_limits<double>::infinity();
    switch (this->Number(16))
    {
      case 0:
        return least;
      case 1:
        return largest;
      case 2:
        return this->Is(0.5) ? largest + 1.0 : least - 1.0;
      case 3:
        return this->Is(0.5) ? infinity : -1.0e300;
      case 4:
        return std::numeric_limits<double>::quiet_NaN();
      default:
        return this->Between(least, largest);
    }
  }

  // The same of whole numbers.
  int Count(int least, int largest)
  {
    const int outside[] = { least - 1, largest + 1, std::numeric_limits<int>::lowest(),
      std::numeric_limits<int>::max() };
    return this->Is(0.1) ? outside[this->Number(4)] : least + this->Number(largest - least + 1);
  }

  // Of so many choices; rarely one that there is not.
  int Choice(int count) { return this->Count(0, count - 1); }

  // One of a list.
  template <typename T, int N>
  T Of(const T (&list)[N])
  {
    return list[this->Number(N)];
  }

private:
  std::mt19937 Engine;
};
}

#endif
