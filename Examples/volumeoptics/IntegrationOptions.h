// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Options of the command line that replace a transfer function's own settings of the integral.

#ifndef IntegrationOptions_h
#define IntegrationOptions_h

#include "IntegrationSettings.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

struct IntegrationOptions
{
  // Empty, or below 0: as the transfer function says.
  std::string Space, Classification, Silhouette, TransmittedLight;
  double UnitInterval = -1.0;
  std::vector<std::string> Isosurfaces;

  void AddTo(CLI::App& command);
  void Replace(IntegrationSettings& settings) const;
};

#endif
