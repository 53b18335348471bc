// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// What goes wrong because of what the user gave: one line that names the remedy, exit code 1.

#ifndef UserError_h
#define UserError_h

#include <stdexcept>

struct UserError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

#endif
