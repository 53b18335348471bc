// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// How much structure a picture shows beyond a reference: vtkStructuralDissimilarity of two PNG files.

#ifndef StructuralScore_h
#define StructuralScore_h

#include <string>

double StructuralScore(const std::string& picture, const std::string& reference);

#endif
