// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The sanitizers of addresses and of threads keep freed memory, and shadows of it, for a while: what
// the process holds then says nothing of what the program holds. (Leaks they find themselves.)

#ifndef FreedMemory_h
#define FreedMemory_h

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool FreedMemoryIsKept = true;
#else
constexpr bool FreedMemoryIsKept = false;
#endif

#endif
