// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LineExchange.h"

#include "Batches.h"
#include "LineAccumulator.h"
#include "ProcessGroup.h"

#include <algorithm>
#include <functional>

namespace volumeoptics
{
namespace
{
const std::size_t LargestMessage = std::size_t(1) << 26; // bytes
}

float* LineSums::At(int place, std::size_t size)
{
  short& slot = this->Slots[place];
  if (slot < 0)
  {
    slot = static_cast<short>(this->Values.size() / size);
    this->Values.resize(this->Values.size() + size, 0.0F);
  }
  return &this->Values[slot * size];
}

void LineSums::Add(const LineSums& other)
{
  const auto isUsed = [](short slot) { return slot >= 0; };
  const auto used = std::count_if(other.Slots.begin(), other.Slots.end(), isUsed);
  const std::size_t size = used > 0 ? other.Values.size() / used : 0;
  this->Slots.resize(other.Slots.size(), -1);
  for (std::size_t place = 0; place < other.Slots.size(); ++place)
  {
    if (other.Slots[place] >= 0)
    {
      const float* from = &other.Values[other.Slots[place] * size];
      float* to = this->At(static_cast<int>(place), size);
      std::transform(from, from + size, to, to, std::plus<>());
    }
  }
}

void BytesWriter::Write(const LineSums& sums)
{
  this->Write(sums.Slots);
  this->Write(sums.Values);
}

void BytesReader::Read(LineSums& sums)
{
  this->Read(sums.Slots);
  this->Read(sums.Values);
}

void BytesWriter::Write(const LineBrick& brick)
{
  this->Write(brick.Places);
  this->Write(brick.Counts);
  this->Write(brick.Harmonics);
  this->Write(brick.Values);
}

void BytesReader::Read(LineBrick& brick)
{
  this->Read(brick.Places);
  this->Read(brick.Counts);
  this->Read(brick.Harmonics);
  this->Read(brick.Values);
}

// Processes take turns as the owners of bricks: number i belongs to i modulo their number. An owner adds up what
// all have of a brick, in the order of the processes, compresses it, and gives it to those who want it.
// Portions of bricks bound what is under way at a time.
bool LineAccumulator::FinishTogether(Batches& batches, double progressAtEnd, const ProcessGroup& processes,
  const std::vector<long long>& occupied, std::vector<LineTypeBricks>& bricks)
{
  const std::size_t ofBrick = this->Settings.Grid.VoxelsOfBrick() * this->SizeOfVoxel() * sizeof(float);
  const std::size_t ofPortion = ofBrick * std::max<std::size_t>(this->Types.size(), 1) * processes.GetSize();
  const auto portion =
    static_cast<long long>(std::max<std::size_t>(LargestMessage / ofPortion, 1)) * processes.GetSize();
  const auto count = static_cast<long long>(occupied.size());
  const double start = batches.GetProgress();
  bool isComplete = true;
  for (long long first = 0; first < count; first += portion)
  {
    const BrickRange range = { 0, static_cast<std::size_t>(first),
      static_cast<std::size_t>(std::min(first + portion, count)) };
    const std::vector<SharedBrick> own = this->Collect(processes, occupied, range);
    std::vector<LineBrick> compressed(own.size());
    const double end = start + (progressAtEnd - start) * range.Last / count;
    const auto compress = [&](long long i) { this->Compress(own[i].Sums, compressed[i]); };
    isComplete = batches.Run(static_cast<long long>(own.size()), end, compress) && isComplete;
    BytesWriter writer;
    for (std::size_t i = 0; i < own.size(); ++i)
    {
      writer.Write(own[i].Label);
      writer.Write(compressed[i]);
    }
    const std::vector<char> all = this->Settings.OnAllProcesses ? processes.GatherEverywhere(writer.Bytes)
                                                                : processes.GatherAt(0, writer.Bytes);
    for (BytesReader reader(all); !reader.IsAtEnd();)
    {
      BrickLabel label;
      reader.Read(label);
      reader.Read(bricks[label.Set].Bricks[label.Brick]);
    }
  }
  return processes.All(isComplete);
}

// The bricks of a range that are this process's own, as the sums of all processes.
std::vector<LineAccumulator::SharedBrick> LineAccumulator::Collect(
  const ProcessGroup& processes, const std::vector<long long>& occupied, const BrickRange& range)
{
  std::vector<SharedBrick> own;
  for (int owner = 0; owner < processes.GetSize(); ++owner)
  {
    const std::vector<char> all =
      processes.GatherAt(owner, this->BytesFor(owner, processes, occupied, range));
    std::map<std::pair<long long, int>, LineSums> sums;
    for (BytesReader reader(all); !reader.IsAtEnd();)
    {
      BrickLabel label;
      LineSums part;
      reader.Read(label);
      reader.Read(part);
      sums[{ label.Brick, label.Set }].Add(part);
    }
    for (auto& [label, sum] : sums)
    {
      own.push_back({ { label.first, label.second }, std::move(sum) });
    }
  }
  return own;
}

// What this process has of an owner's bricks; it has it no longer.
std::vector<char> LineAccumulator::BytesFor(
  int owner, const ProcessGroup& processes, const std::vector<long long>& occupied, const BrickRange& range)
{
  BytesWriter writer;
  for (std::size_t i = range.First; i < range.Last; ++i)
  {
    if (static_cast<int>(i % processes.GetSize()) != owner)
    {
      continue;
    }
    int set = 0;
    for (auto& type : this->Types)
    {
      if (std::unique_ptr<LineSums>& sums = type.second.Bricks[occupied[i]])
      {
        writer.Write(BrickLabel{ static_cast<long long>(i), set });
        writer.Write(*sums);
        sums.reset();
      }
      ++set;
    }
  }
  return writer.Bytes;
}
}
