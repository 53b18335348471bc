// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Bricks of lines as bytes, for other processes.

#ifndef LineExchange_h
#define LineExchange_h

#include "LineVoxels.h"

#include <cstring>
#include <vector>

namespace volumeoptics
{
// Sums of a brick's voxels before they are compressed.
struct LineSums
{
  std::vector<short> Slots; // of each place, -1: none
  std::vector<float> Values;

  // Where a place's sums begin; it gets zeros if it had none. size: numbers of a voxel.
  float* At(int place, std::size_t size);
  void Add(const LineSums& other);
};

// What a brick's bytes say of it.
struct BrickLabel
{
  long long Brick;
  int Set; // of the line types
};

class BytesWriter
{
public:
  template <class Value>
  void Write(const Value& value)
  {
    const auto* bytes = reinterpret_cast<const char*>(&value);
    this->Bytes.insert(this->Bytes.end(), bytes, bytes + sizeof(Value));
  }
  template <class Value>
  void Write(const std::vector<Value>& values)
  {
    this->Write(static_cast<long long>(values.size()));
    const auto* bytes = reinterpret_cast<const char*>(values.data());
    this->Bytes.insert(this->Bytes.end(), bytes, bytes + values.size() * sizeof(Value));
  }
  void Write(const LineSums& sums);
  void Write(const LineBrick& brick);

  std::vector<char> Bytes;
};

class BytesReader
{
public:
  explicit BytesReader(const std::vector<char>& bytes)
    : Bytes(bytes)
  {
  }

  bool IsAtEnd() const { return this->Place >= this->Bytes.size(); }
  template <class Value>
  void Read(Value& value)
  {
    this->Copy(&value, sizeof(Value));
  }
  template <class Value>
  void Read(std::vector<Value>& values)
  {
    long long count = 0;
    this->Read(count);
    values.resize(count);
    this->Copy(values.data(), count * sizeof(Value));
  }
  void Read(LineSums& sums);
  void Read(LineBrick& brick);

private:
  void Copy(void* to, std::size_t size)
  {
    if (size > 0)
    {
      std::memcpy(to, this->Bytes.data() + this->Place, size);
      this->Place += size;
    }
  }

  const std::vector<char>& Bytes;
  std::size_t Place = 0;
};
}

#endif
