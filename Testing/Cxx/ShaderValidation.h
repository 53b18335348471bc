// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Texts of shaders, which one run of the reference compiler of GLSL checks: it is stricter than a driver.

#ifndef ShaderValidation_h
#define ShaderValidation_h

#include "Check.h"

#include <fstream>
#include <set>
#include <string>
#include <vector>

namespace
{
class ShaderValidation
{
public:
  // A text that was there before is not checked again.
  void Add(Check& check, const std::string& name, const std::string& text)
  {
    check.That(!text.empty(), name + ": has no text");
    if (this->Texts.insert(text).second)
    {
      const std::string path = std::string(VOLUMEOPTICS_TEMPORARY) + "/Optics-" + name + ".frag";
      std::ofstream(path) << text;
      check.That(this->Paths.insert(path).second, name + ": is checked twice");
    }
  }

  void Run(Check& check) const
  {
    std::string command = VOLUMEOPTICS_GLSLANG;
    for (const std::string& path : this->Paths)
    {
      command += " " + path;
    }
    check.That(
      this->Paths.empty() || std::system(command.c_str()) == 0, "a shader named above is not valid GLSL");
  }

private:
  std::set<std::string> Texts, Paths;
};
}

#endif
