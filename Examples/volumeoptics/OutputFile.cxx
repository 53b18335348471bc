// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "OutputFile.h"

#include "ReadingGuard.h"
#include "UserError.h"

#include <filesystem>
#include <unistd.h>

namespace
{
namespace fs = std::filesystem;

// Removes what is left of a file that did not become one.
struct Temporary
{
  explicit Temporary(const std::string& path)
    : Path(path + ".part" + std::to_string(getpid()))
  {
  }
  ~Temporary()
  {
    std::error_code ignored;
    fs::remove(this->Path, ignored);
  }

  const std::string Path;
};
}

void WriteFile(const std::string& path, const std::function<bool(const std::string& temporary)>& write)
{
  std::error_code error;
  const fs::path target = fs::is_symlink(path, error) ? fs::weakly_canonical(path, error) : fs::path(path);
  const bool isReplaceable = !fs::exists(target, error) || fs::is_regular_file(target, error);
  const Temporary temporary(target.string());
  const VtkMessages quiet; // the reason is told below
  const bool isWritten =
    write(isReplaceable ? temporary.Path : path) && quiet.GetError().empty(); // path: a device
  error.clear();
  if (isWritten && isReplaceable)
  {
    fs::rename(temporary.Path, target, error);
  }
  if (!isWritten || error)
  {
    throw UserError("'" + path + "' cannot be written. Check that its folder exists and is writable.");
  }
}
