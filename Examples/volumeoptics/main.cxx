// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// volumeoptics: optical models for volume rendering, from the command line.

#include "Commands.h"
#include "Progress.h"
#include "UserError.h"

#include <vtkObject.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <new>
#include <string>

namespace
{
constexpr int UserErrorCode = 1;
constexpr int UsageErrorCode = 2;
constexpr std::size_t LongestMessage = 600;

const char* const Examples = R"(
Examples:
  volumeoptics render head.nrrd -o head.png --model ward --preset cranium --camera 35,8
  volumeoptics view Cranium.inv3 --model lafortune --glossiness 30
  volumeoptics view Cranium.inv3 --lighting
  volumeoptics lines streamlines.vtp -o lines.png --grid 256 --camera 30,20
  volumeoptics info Cranium.inv3
  volumeoptics gallery -o gallery
  volumeoptics trade covariance -o trade

Exit codes: 0 done, 1 a file or the machine is at fault, 2 the command line is.)";

// Messages quote files, which may hold anything.
std::string InOneLine(std::string text)
{
  std::replace_if(
    text.begin(), text.end(), [](unsigned char letter) { return std::iscntrl(letter) != 0; }, ' ');
  return text.size() <= LongestMessage ? text : text.substr(0, LongestMessage) + " ...";
}
}

// What throws outside the try block is a mistake in the options' own text: let it end the program.
// NOLINTNEXTLINE(bugprone-exception-escape)
int main(int argc, char** argv)
{
  CLI::App program(
    "Volume rendering with optical models: anisotropic highlights by the shape of the data.", "volumeoptics");
  program.footer(Examples);
  program.set_version_flag("--version", VOLUMEOPTICS_VERSION);
  program.require_subcommand(1);
  program.get_formatter()->column_width(32);
  program.fallthrough();
  program.add_flag_callback(
    "-q,--quiet", [] { Progress::SetQuiet(true); }, "No progress, no times");
  AddRenderCommand(program);
  AddLinesCommand(program);
  AddViewCommand(program);
  AddEditorCommand(program);
  AddInfoCommand(program);
  AddGalleryCommand(program);
  AddTradeCommand(program);
  try
  {
    program.parse(argc, argv);
  }
  catch (const CLI::ParseError& error)
  {
    return program.exit(error) == 0 ? 0 : UsageErrorCode;
  }
  catch (const std::bad_alloc&)
  {
    std::fprintf(
      stderr, "volumeoptics: The memory does not suffice. Check the sizes in the file's header.\n");
    return UserErrorCode;
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "volumeoptics: %s\n", InOneLine(error.what()).c_str());
    return UserErrorCode;
  }
  return 0;
}
