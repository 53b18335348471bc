// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Distances to the nearest cell that is not empty.

#ifndef MacrocellDistances_h
#define MacrocellDistances_h

#include <vector>

namespace volumeoptics
{
/**
 * distances: 0 of a cell that is not empty, any other number of one that is; then the distance of the largest
 * coordinate, at most 255. size: cells on each axis, x running fastest.
 */
void FindMacrocellDistances(const int size[3], std::vector<unsigned char>& distances);
}

#endif
