// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The order in which boxes are drawn, so that what is in front is drawn last.

#ifndef BlockOrder_h
#define BlockOrder_h

#include <array>
#include <cstddef>
#include <vector>

using BlockBounds = std::array<double, 6>;

/**
 * The numbers of the boxes, back to front, for an eye in homogeneous coordinates of the boxes: its fourth is 1,
 * or 0 for a parallel view, the first three then pointing to the viewer. Boxes that hide each other in a ring
 * have no such order; of these the one with the smallest number is drawn first.
 */
std::vector<std::size_t> SortBackToFront(const std::vector<BlockBounds>& boxes, const double eye[4]);

#endif
