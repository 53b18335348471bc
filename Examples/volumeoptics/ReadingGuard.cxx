// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ReadingGuard.h"

#include "UserError.h"

#include <vtkLogger.h>
#include <vtkMath.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <sys/resource.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace
{
namespace fs = std::filesystem;

constexpr double Mebibyte = 1024.0 * 1024.0;
constexpr double BytesOfReader = 1024.0 * Mebibyte;
constexpr double BytesOfThread = 160.0 * Mebibyte; // its stack, and the address space of its allocator
constexpr double BestCompression = 8192.0;         // LZMA of zeros; zlib has 1032
constexpr int ExitCode = 1;
constexpr std::size_t SignalStackBytes = 64 * 1024;

// The signals of a crash.
constexpr std::array<int, 5> Crashes = { SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT };

// A file may claim more than any integer holds.
std::string WholeText(double number)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(0) << number;
  return text.str();
}

// Keeps the first error and warning in place of the terminal.
class MessageKeeper : public vtkOutputWindow
{
public:
  static MessageKeeper* New();
  vtkTypeMacro(MessageKeeper, vtkOutputWindow);
  void DisplayText(const char*) override {}
  void DisplayErrorText(const char* text) override
  {
    this->Error = this->Error.empty() ? LastLine(text) : this->Error;
  }

  void DisplayWarningText(const char* text) override
  {
    this->Warning = this->Warning.empty() ? LastLine(text) : this->Warning;
  }
  void DisplayGenericWarningText(const char* text) override { this->DisplayWarningText(text); }

  std::string Error, Warning;
};
vtkStandardNewMacro(MessageKeeper);

// A signal handler can only write what is ready.
std::array<char, 512> CrashMessage;
std::size_t CrashMessageLength = 0;

void OnCrash(int)
{
  if (write(STDERR_FILENO, CrashMessage.data(), CrashMessageLength) < 0)
  {
    _exit(ExitCode);
  }
  _exit(ExitCode);
}

double BytesOfMemory()
{
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

// The address space that the program has now.
double BytesInUse()
{
  double pages = 0.0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<double>(sysconf(_SC_PAGESIZE));
}

// The address space that reading a file may take. What is one file holds no more than the best compression,
// and a copy of it, gives; others have data beside.
double BytesToRead(const std::string& path)
{
  const std::string ending = fs::path(path).extension().string();
  std::error_code error;
  const auto size = static_cast<double>(fs::file_size(path, error));
  if (error || ending == ".mhd" || ending == ".nhdr" || ending == ".dcm")
  {
    return BytesOfMemory();
  }
  const double threads = std::thread::hardware_concurrency() * BytesOfThread;
  return std::min(BytesOfMemory(), BytesOfReader + threads + 2.0 * BestCompression * size);
}

UserError NotAGrid(const std::string& path, const std::string& what)
{
  return UserError("'" + path + "' cannot be read as a volume (" + what +
    "). Check that the file is complete and that its ending names its format.");
}

bool AreFinite(const double* numbers, int count)
{
  return std::all_of(numbers, numbers + count, [](double number) { return std::isfinite(number); });
}
}

double MostBytes()
{
  return 0.5 * BytesOfMemory();
}

void RequireFile(const std::string& path, bool allowsFolder)
{
  std::error_code ignored;
  if (!fs::exists(path, ignored))
  {
    throw UserError("'" + path + "' does not exist. Check the path.");
  }
  const bool isFolder = fs::is_directory(path, ignored);
  if (!fs::is_regular_file(path, ignored) && !(isFolder && allowsFolder))
  {
    throw UserError("'" + path + "' is " + (isFolder ? "a folder" : "no regular file") + ". Name a file.");
  }
}

void RequireGrid(const std::string& path, const int extent[6], double bytesOfPoint, const double spacing[3],
  const double origin[3], const double direction[9])
{
  double points = 1.0;
  std::string size;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double length = static_cast<double>(extent[2 * axis + 1]) - extent[2 * axis] + 1.0;
    if (!(length >= 1.0))
    {
      throw NotAGrid(path, "it has no voxels");
    }
    points *= length;
    size += (axis > 0 ? " x " : "") + WholeText(length);
  }
  if (points * bytesOfPoint > MostBytes())
  {
    throw NotAGrid(path,
      "its " + size + " voxels need " + WholeText(points * bytesOfPoint / Mebibyte) + " MiB, the limit is " +
        WholeText(MostBytes() / Mebibyte) + " MiB, half of the memory");
  }
  const bool isPlaced =
    AreFinite(spacing, 3) && AreFinite(origin, 3) && (!direction || AreFinite(direction, 9));
  if (!isPlaced || !(spacing[0] > 0.0 && spacing[1] > 0.0 && spacing[2] > 0.0))
  {
    throw NotAGrid(path, "spacing, origin and direction must be finite, spacing above 0");
  }
}

std::string LastLine(const std::string& message)
{
  std::string text = message;
  while (!text.empty() && (std::isspace(static_cast<unsigned char>(text.back())) || text.back() == '.'))
  {
    text.pop_back();
  }
  const auto at = text.find("): ");
  text = at == std::string::npos ? text : text.substr(at + 3);
  std::replace_if(
    text.begin(), text.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }, ' ');
  return text;
}

VtkMessages::VtkMessages()
  : Former(vtkOutputWindow::GetInstance())
  , FormerVerbosity(vtkLogger::GetCurrentVerbosityCutoff())
{
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkNew<MessageKeeper> keeper;
  vtkOutputWindow::SetInstance(keeper);
}

VtkMessages::~VtkMessages()
{
  vtkOutputWindow::SetInstance(this->Former);
  vtkLogger::SetStderrVerbosity(static_cast<vtkLogger::Verbosity>(this->FormerVerbosity));
}

std::string VtkMessages::GetError() const
{
  const auto* keeper = MessageKeeper::SafeDownCast(vtkOutputWindow::GetInstance());
  return keeper ? keeper->Error : "";
}

std::string VtkMessages::GetWarning() const
{
  const auto* keeper = MessageKeeper::SafeDownCast(vtkOutputWindow::GetInstance());
  return keeper ? keeper->Warning : "";
}

struct ReadingGuard::State
{
  rlimit Memory{};
  std::array<struct sigaction, Crashes.size()> Actions{};
  stack_t Stack{};
  std::vector<char> OwnStack = std::vector<char>(SignalStackBytes); // a crash may be of the stack
};

ReadingGuard::ReadingGuard(const std::string& path)
  : Before(new State)
{
  const int length = std::snprintf(CrashMessage.data(), CrashMessage.size(),
    "volumeoptics: '%.300s' cannot be read (its reader fails on it). Check that the file is complete.\n",
    path.c_str());
  CrashMessageLength = static_cast<std::size_t>(std::max(length, 0));

  stack_t stack{};
  stack.ss_sp = this->Before->OwnStack.data();
  stack.ss_size = this->Before->OwnStack.size();
  sigaltstack(&stack, &this->Before->Stack);
  struct sigaction action
  {
  };
  action.sa_handler = OnCrash;
  action.sa_flags = SA_ONSTACK;
  for (std::size_t i = 0; i < Crashes.size(); ++i)
  {
    sigaction(Crashes[i], &action, &this->Before->Actions[i]);
  }

  getrlimit(RLIMIT_AS, &this->Before->Memory);
  rlimit memory = this->Before->Memory;
  const double most = BytesInUse() + BytesToRead(path);
  memory.rlim_cur = std::min(memory.rlim_cur, static_cast<rlim_t>(most));
  setrlimit(RLIMIT_AS, &memory);
}

ReadingGuard::~ReadingGuard()
{
  setrlimit(RLIMIT_AS, &this->Before->Memory);
  for (std::size_t i = 0; i < Crashes.size(); ++i)
  {
    sigaction(Crashes[i], &this->Before->Actions[i], nullptr);
  }
  sigaltstack(&this->Before->Stack, nullptr);
}
