// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// volumeoptics trade: time against error of the quality parameters.

#include "Commands.h"
#include "TradeCovariance.h"

#include <memory>

namespace
{
void AddCovariance(CLI::App& trade)
{
  const auto options = std::make_shared<CovarianceTradeOptions>();
  CLI::App* command = trade.add_subcommand("covariance",
    "Covariance filter: angle and strength against the exhaustive ball, by pattern, samples, radius, grid "
    "factor, storage, bits and interpolation, also by the normal's direction (CSV and SVG)");
  command->add_option("FILE", options->File, "Volume instead of a synthetic field");
  command->add_option("-o,--output", options->Folder, "Folder to write")->capture_default_str();
  command->add_option("--field", options->Field, "Synthetic field")
    ->check(CLI::IsMember({ "marschner-lobb", "ellipsoid", "cylinder", "packed", "tubes" }))
    ->capture_default_str();
  command->add_option("--radius", options->Radius, "Radius in voxels")
    ->check(CLI::Range(1.0, 256.0))
    ->capture_default_str();
  command->add_option("--tolerance", options->Tolerance, "Half width of the interval of similar values")
    ->check(CLI::Range(0.0, 1.0))
    ->capture_default_str();
  command->callback([options] { TradeCovariance(*options); });
}
}

void AddTradeCommand(CLI::App& program)
{
  CLI::App* trade = program.add_subcommand("trade", "Measure time against error of the quality parameters");
  trade->require_subcommand(1);
  AddCovariance(*trade);
}
