// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// What a file of unknown origin may do to the program while it is read: nothing but fail.

#ifndef ReadingGuard_h
#define ReadingGuard_h

#include <vtkSmartPointer.h>

#include <memory>
#include <string>

class vtkImageData;
class vtkOutputWindow;

// Bytes that the contents of a file may take: half of the machine's memory.
double MostBytes();

// Throws UserError unless path is a file, or a folder where one may be.
void RequireFile(const std::string& path, bool allowsFolder = false);

// Throws UserError unless the extent holds points that memory has room for, and spacing, origin and
// direction (may be null) are finite, the spacing above 0.
void RequireGrid(const std::string& path, const int extent[6], double bytesOfPoint, const double spacing[3],
  const double origin[3], const double direction[9]);

// The message of a VTK error, in one line, without the place in the source.
std::string LastLine(const std::string& message);

// Keeps what VTK complains about off the terminal, from construction to destruction.
class VtkMessages
{
public:
  VtkMessages();
  ~VtkMessages();
  VtkMessages(const VtkMessages&) = delete;
  void operator=(const VtkMessages&) = delete;

  // The first of its kind in one line, or empty.
  std::string GetError() const;
  std::string GetWarning() const;

private:
  vtkSmartPointer<vtkOutputWindow> Former;
  int FormerVerbosity;
};

// While it lives, memory is limited (a request beyond throws std::bad_alloc), and a reader that crashes on
// the file ends the program with an error about the file and exit code 1. One at a time.
class ReadingGuard
{
public:
  explicit ReadingGuard(const std::string& path);
  ~ReadingGuard();
  ReadingGuard(const ReadingGuard&) = delete;
  void operator=(const ReadingGuard&) = delete;

  std::string GetError() const { return this->Messages.GetError(); }

private:
  VtkMessages Messages;
  struct State;
  const std::unique_ptr<State> Before;
};

#endif
