// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// volumeoptics trade table: time and memory of preprocessing, and frames of every model, as Table 1 of
// [Ament2015].

#ifndef TradeTable_h
#define TradeTable_h

#include <string>

struct TableOptions
{
  std::string Cranium; // file; without it the table leaves the cranium out
  std::string Folder = ".";
  int Size = 1024;
  int Frames = 3;
  bool Headless = false;
};

void TradeTable(const TableOptions& options);

#endif
