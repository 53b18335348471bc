// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// volumeoptics trade integration: time of a frame against its error, post-classified and pre-integrated, in
// physical and in data space; the double-precision ray caster's picture is the truth.

#ifndef TradeIntegration_h
#define TradeIntegration_h

#include <string>

struct IntegrationTradeOptions
{
  std::string Folder = "trade";
  int Size = 128;
  bool Headless = false;
};

// Writes integration.csv, integration-smooth.svg, integration-spiky.svg, integration-tables.csv,
// integration-tables.svg, integration-rate.csv and integration-rate.svg; prints the figures.
void TradeIntegration(const IntegrationTradeOptions& options);

#endif
