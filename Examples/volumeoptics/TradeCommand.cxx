// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// volumeoptics trade: time against error of the quality parameters.

#include "Commands.h"
#include "TradeCovariance.h"
#include "TradeIntegration.h"
#include "TradeLighting.h"
#include "TradeLines.h"
#include "TradeShading.h"
#include "TradeTable.h"
#include "TradeVisibility.h"

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

void AddShading(CLI::App& trade)
{
  const auto options = std::make_shared<ShadingTradeOptions>();
  CLI::App* command = trade.add_subcommand("shading",
    "Frames: RMSE and maximum against the double-precision ray caster, by step length, bits, storage, "
    "samples, "
    "grid factor and extinction gradient (CSV and SVG)");
  command->add_option("-o,--output", options->Folder, "Folder to write")->capture_default_str();
  command->add_option("--field", options->Field, "Synthetic field")
    ->check(CLI::IsMember({ "marschner-lobb", "ellipsoid", "cylinder", "packed", "tubes" }))
    ->capture_default_str();
  command->add_option("--model", options->Model, "Reflectance model")
    ->check(CLI::IsMember({ "none", "blinn-phong", "ward", "lafortune" }))
    ->capture_default_str();
  command->add_option("--size", options->Size, "Width and height of the picture")
    ->check(CLI::Range(16, 2048))
    ->capture_default_str();
  command->add_flag("--headless", options->Headless, "Use no X server (the default without DISPLAY)");
  command->callback([options] { TradeShading(*options); });
}

void AddIntegration(CLI::App& trade)
{
  const auto options = std::make_shared<IntegrationTradeOptions>();
  CLI::App* command = trade.add_subcommand("integration",
    "Post-classified and pre-integrated, in physical and data space: frames of the Marschner-Lobb signal "
    "against the double-precision ray caster, by step length, table size and bits, smooth and spiky transfer "
    "functions (CSV, SVG and figures)");
  command->add_option("-o,--output", options->Folder, "Folder to write")->capture_default_str();
  command->add_option("--size", options->Size, "Width and height of the picture")
    ->check(CLI::Range(16, 2048))
    ->capture_default_str();
  command->add_flag("--headless", options->Headless, "Use no X server (the default without DISPLAY)");
  command->callback([options] { TradeIntegration(*options); });
}

void AddLighting(CLI::App& trade)
{
  const auto options = std::make_shared<LightingTradeOptions>();
  CLI::App* command = trade.add_subcommand("lighting",
    "Lighting transfer functions: RMSE and maximum against the double-precision ray caster, by step along "
    "the gradient, table size, bits, fetches and step length (CSV and SVG)");
  command->add_option("-o,--output", options->Folder, "Folder to write")->capture_default_str();
  command->add_option("--field", options->Field, "Synthetic field")
    ->check(CLI::IsMember({ "marschner-lobb", "ellipsoid", "cylinder", "packed", "plant", "tubes" }))
    ->capture_default_str();
  command->add_option("--size", options->Size, "Width and height of the picture")
    ->check(CLI::Range(16, 2048))
    ->capture_default_str();
  command->add_flag("--headless", options->Headless, "Use no X server (the default without DISPLAY)");
  command->callback([options] { TradeLighting(*options); });
}

void AddLines(CLI::App& trade)
{
  const auto options = std::make_shared<LinesTradeOptions>();
  CLI::App* command = trade.add_subcommand("lines",
    "Lines as anisotropic voxels: time, memory and PSNR against 10 x 10 supersampled tubes, by order, grid, "
    "projection, tolerance, opacity, storage and evaluation; storage by the number of segments (CSV and "
    "SVG)");
  command->add_option("-o,--output", options->Folder, "Folder to write")->capture_default_str();
  command->add_option("--segments", options->Segments, "Segments of the spirals")
    ->check(CLI::Range(1000, 100000000))
    ->capture_default_str();
  command->add_option("--size", options->Size, "Width and height of the picture")
    ->check(CLI::Range(16, 1024))
    ->capture_default_str();
  command->add_option("--radius", options->Radius, "Radius of the spirals, which fill [-1, 1]^3")
    ->check(CLI::PositiveNumber)
    ->capture_default_str();
  command->add_option("--knob", options->Knob, "Measure one setting alone")
    ->check(CLI::IsMember(
      { "segments", "grid", "order", "tolerance", "projection", "opacity", "storage", "evaluation" }));
  command->add_flag("--headless", options->Headless, "Use no X server (the default without DISPLAY)");
  command->callback([options] { TradeLines(*options); });
}

void AddVisibility(CLI::App& trade)
{
  const auto options = std::make_shared<VisibilityTradeOptions>();
  CLI::App* command = trade.add_subcommand("visibility",
    "Directional occlusion against the cone integral by rays in double: by froxel size, slice distance, "
    "directions, angle, algorithm and bits, with the time of a frame over that without (CSV, SVG and "
    "figures)");
  command->add_option("-o,--output", options->Folder, "Folder to write")->capture_default_str();
  command->add_option("--field", options->Field, "What is drawn")
    ->check(CLI::IsMember({ "marschner-lobb", "cranium" }))
    ->capture_default_str();
  command->add_option("--cranium", options->Cranium, "CT of the cranium (.inv3)");
  command->add_option("--size", options->Size, "Width and height of the pictures that are compared")
    ->check(CLI::Range(8, 512))
    ->capture_default_str();
  command->add_option("--frame-size", options->FrameSize, "Width and height of the frames that are timed")
    ->check(CLI::Range(16, 4096))
    ->capture_default_str();
  command->add_option("--rays", options->Rays, "Rays of the truth, at each sample")
    ->check(CLI::Range(4, 65536))
    ->capture_default_str();
  command->add_option("--part", options->Part, "The algorithms in double, the mapper's frames, or both")
    ->check(CLI::IsMember({ "all", "algorithms", "frames" }))
    ->capture_default_str();
  command->add_flag("--headless", options->Headless, "Use no X server (the default without DISPLAY)");
  command->callback([options] { TradeVisibility(*options); });
}

void AddTable(CLI::App& trade)
{
  const auto options = std::make_shared<TableOptions>();
  CLI::App* command = trade.add_subcommand("table",
    "Normals, covariance and frames of every model: time, memory and frames per second, with early ray "
    "termination (CSV)");
  command->add_option("-o,--output", options->Folder, "Folder to write")->capture_default_str();
  command->add_option("--cranium", options->Cranium, "Cranium.inv3, to have the cranium in the table");
  command->add_option("--size", options->Size, "Width and height of the frames")
    ->check(CLI::Range(16, 4096))
    ->capture_default_str();
  command->add_option("--frames", options->Frames, "Frames of each model, of which the median is taken")
    ->check(CLI::Range(1, 100))
    ->capture_default_str();
  command->add_flag("--headless", options->Headless, "Use no X server (the default without DISPLAY)");
  command->callback([options] { TradeTable(*options); });
}
}

void AddTradeCommand(CLI::App& program)
{
  CLI::App* trade = program.add_subcommand("trade", "Measure time against error of the quality parameters");
  trade->require_subcommand(1);
  AddCovariance(*trade);
  AddShading(*trade);
  AddIntegration(*trade);
  AddLighting(*trade);
  AddLines(*trade);
  AddTable(*trade);
  AddVisibility(*trade);
}
