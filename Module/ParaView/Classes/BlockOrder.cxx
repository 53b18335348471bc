// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "BlockOrder.h"

#include <algorithm>

namespace
{
// A plane across the axis with the first box below it and the second above; boxes that overlap are parted
// in the middle of the overlap.
struct Parting
{
  double Overlap; // below 0: a gap
  double Plane;
};

Parting Part(const BlockBounds& below, const BlockBounds& above, std::size_t axis)
{
  const double end = below[2 * axis + 1];
  const double begin = above[2 * axis];
  return { end - begin, 0.5 * (end + begin) };
}

bool LiesBelow(const double eye[4], std::size_t axis, double plane)
{
  return eye[axis] < plane * eye[3];
}

// Whether a ray from the eye may enter the first box before the second. A plane that parts them, with the
// eye on the side of the second one, proves that none does.
bool MayHide(const BlockBounds& first, const BlockBounds& second, const double eye[4])
{
  double least = 0.0;
  bool secondIsNearer = false;
  bool isParted = false;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const Parting up = Part(first, second, axis);
    const Parting down = Part(second, first, axis);
    const bool firstIsBelow = up.Overlap < down.Overlap;
    const Parting& parting = firstIsBelow ? up : down;
    const bool nearer = firstIsBelow != LiesBelow(eye, axis, parting.Plane);
    if (parting.Overlap <= 0.0)
    {
      isParted = true;
      if (nearer)
      {
        return false;
      }
    }
    if (axis == 0 || parting.Overlap < least)
    {
      least = parting.Overlap;
      secondIsNearer = nearer;
    }
  }
  return isParted || !secondIsNearer; // boxes that overlap: by the axis of the smallest overlap
}
}

//------------------------------------------------------------------------------
std::vector<std::size_t> SortBackToFront(const std::vector<BlockBounds>& boxes, const double eye[4])
{
  const std::size_t count = boxes.size();
  std::vector<std::size_t> hidden(count, 0); // by how many boxes that are not drawn each one hides
  std::vector<std::vector<std::size_t>> before(count);
  for (std::size_t front = 0; front < count; ++front)
  {
    for (std::size_t back = 0; back < count; ++back)
    {
      if (front != back && MayHide(boxes[front], boxes[back], eye) &&
        !MayHide(boxes[back], boxes[front], eye))
      {
        ++hidden[front];
        before[back].push_back(front);
      }
    }
  }
  std::vector<std::size_t> order;
  std::vector<bool> drawn(count, false);
  while (order.size() < count)
  {
    std::size_t next = count;
    for (std::size_t box = 0; box < count; ++box)
    {
      if (!drawn[box] && (next == count || hidden[box] < hidden[next]))
      {
        next = box;
      }
    }
    drawn[next] = true;
    order.push_back(next);
    for (const std::size_t front : before[next])
    {
      --hidden[front];
    }
  }
  return order;
}
