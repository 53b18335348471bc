// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Files that are there whole or not at all.

#ifndef OutputFile_h
#define OutputFile_h

#include <functional>
#include <string>

// Has write() write a file beside path, which becomes path when write() returns true; a file that was there
// stays until then, and for good after an error. Throws UserError.
void WriteFile(const std::string& path, const std::function<bool(const std::string& temporary)>& write);

#endif
