// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef InteractionQuality_h
#define InteractionQuality_h

namespace volumeoptics
{
// How many times as coarse as a preset says frames are drawn while the user interacts, 1, 2 or 4: the finest
// that takes no longer than `allocated` seconds. full: seconds of a frame at 1, 0 if none is known. last: of the frame
// before; a finer one must fit with room to spare, so that frames do not change to and fro.
inline int CoarsenessFor(double full, double allocated, int last)
{
  const int unknown = 2, largest = 4;
  const double room = 0.7;
  if (!(full > 0.0))
  {
    return unknown;
  }
  for (int coarseness = 1; coarseness < largest; coarseness *= 2)
  {
    if (full / coarseness <= (coarseness < last ? room : 1.0) * allocated)
    {
      return coarseness;
    }
  }
  return largest;
}
}

#endif
