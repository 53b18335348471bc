// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The range of the scalars of an image's whole extent, found slab by slab, and remembered.

#ifndef RangeSearch_h
#define RangeSearch_h

#include "ScalarSource.h"

#include <string>

namespace volumeoptics
{
class Batches;

class RangeSearch
{
public:
  // What a range belongs to.
  struct Key
  {
    unsigned long long Time; // of the pipeline up to the image
    std::string Name;        // of the array
    int Component;
    bool operator==(const Key& other) const
    {
      return this->Time == other.Time && this->Name == other.Name && this->Component == other.Component;
    }
  };

  bool IsKnown(const Key& key) const { return this->HasKey && this->Found == key; }
  const double* GetRange() const { return this->Range; } // (1, 0) if there is no value

  bool IsSearching() const { return this->Slab >= 0; }
  void Stop() { this->Slab = -1; }

  // Slabs are of about as many voxels as `sizeLike`.
  void Start(const Extent& whole, const Extent& sizeLike);
  Extent GetSlab(const Extent& whole) const;

  // Adds a box of the image; false if aborted.
  bool Add(Batches& batches, const ImageRows& rows);

  // Goes on to the next slab; false if there is none.
  bool Next(const Extent& whole);

  // The search is over.
  void Finish(const Key& key);

private:
  double Range[2] = { 1.0, 0.0 };
  Key Found = {};
  bool HasKey = false;
  int Slab = -1;
  int SlabSize = 1; // slices
};
}

#endif
