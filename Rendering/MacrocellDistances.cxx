// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "MacrocellDistances.h"

#include <algorithm>
#include <cstddef>

namespace volumeoptics
{
namespace
{
// A sweep forth or back. A distance is at most one more than that of any of the 26 neighbours, and two sweeps, each
// over the 13 that it has met before, make it so: of the largest coordinate that is exact.
class Sweep
{
public:
  Sweep(const int size[3], std::vector<unsigned char>& distances, bool isForth)
    : Distances(distances)
    , IsForth(isForth)
    , Nearest(size[0] + 2)
  {
    std::copy(size, size + 3, this->Size);
  }

  void Run()
  {
    for (int k = 0; k < this->Size[2]; ++k)
    {
      for (int j = 0; j < this->Size[1]; ++j)
      {
        this->UpdateRow(this->Turned(j, 1), this->Turned(k, 2));
      }
    }
  }

private:
  int Turned(int index, int axis) const { return this->IsForth ? index : this->Size[axis] - 1 - index; }

  unsigned char* Row(int j, int k)
  {
    return this->Distances.data() + (static_cast<std::size_t>(k) * this->Size[1] + j) * this->Size[0];
  }

  // The nearest of the rows that were met before, column by column, one column beyond each end.
  void UpdateRow(int j, int k)
  {
    std::fill(this->Nearest.begin(), this->Nearest.end(), static_cast<unsigned char>(255));
    const int back = this->IsForth ? -1 : 1;
    this->Meet(j + back, k);
    for (int neighbour = j - 1; neighbour <= j + 1; ++neighbour)
    {
      this->Meet(neighbour, k + back);
    }
    this->Spread(this->Row(j, k));
  }

  void Meet(int j, int k)
  {
    if (j >= 0 && j < this->Size[1] && k >= 0 && k < this->Size[2])
    {
      const unsigned char* row = this->Row(j, k);
      for (int i = 0; i < this->Size[0]; ++i)
      {
        this->Nearest[i + 1] = std::min(this->Nearest[i + 1], row[i]);
      }
    }
  }

  void Spread(unsigned char* row)
  {
    for (int i = 0; i < this->Size[0]; ++i)
    {
      const unsigned char nearest =
        std::min({ this->Nearest[i], this->Nearest[i + 1], this->Nearest[i + 2] });
      row[i] = std::min(row[i], Farther(nearest));
    }
    unsigned char before = 255;
    for (int n = 0; n < this->Size[0]; ++n)
    {
      unsigned char& distance = row[this->Turned(n, 0)];
      distance = before = std::min(distance, Farther(before));
    }
  }

  static unsigned char Farther(unsigned char distance)
  {
    return static_cast<unsigned char>(distance < 255 ? distance + 1 : 255);
  }

  int Size[3];
  std::vector<unsigned char>& Distances;
  bool IsForth;
  std::vector<unsigned char> Nearest;
};
}

void FindMacrocellDistances(const int size[3], std::vector<unsigned char>& distances)
{
  std::replace_if(
    distances.begin(), distances.end(), [](unsigned char distance) { return distance > 0; }, 255);
  Sweep(size, distances, true).Run();
  Sweep(size, distances, false).Run();
}
}
