// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Work that may end in a crash, in a process of its own: what it tells before is known after.

#ifndef ChildProcess_h
#define ChildProcess_h

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <new>

namespace
{
// Memory that a process and its children share.
template <class T>
class Shared
{
public:
  Shared()
  {
    void* memory = mmap(nullptr, sizeof(T), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED)
    {
      throw std::bad_alloc();
    }
    this->Value = new (memory) T();
  }
  ~Shared() { munmap(this->Value, sizeof(T)); }
  Shared(const Shared&) = delete;
  Shared& operator=(const Shared&) = delete;

  T* operator->() const { return this->Value; }

private:
  T* Value;
};

// Waits for it. Whether it came to its end; the process must not have a window before.
inline bool EndsWell(const std::function<void()>& work)
{
  std::cout.flush();
  const pid_t child = fork();
  if (child == 0)
  {
    for (const int crash : { SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL })
    {
      std::signal(
        crash, SIG_DFL); // VTK's logger would wait for ever for the memory of a heap that is damaged
    }
    work();
    std::cout.flush();
    std::exit(0); // by which a sanitizer looks for leaks
  }
  int status = 0;
  return waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}
}

#endif
