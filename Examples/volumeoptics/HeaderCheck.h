// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Headers that VTK's readers believe, whatever they say: what is wrong with one, or an empty text.

#ifndef HeaderCheck_h
#define HeaderCheck_h

#include <string>

// An end that is missing in .vti or .vtp; spacing, origin and direction that are not numbers, which VTK's
// reader leaves out.
std::string FaultOfXml(const std::string& path);

// Sizes, spacings and data files of a .nrrd or .nhdr. bytes: that its raw data have, infinite for others.
std::string FaultOfNrrd(const std::string& path, double& bytes);

#endif
