// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// volumeoptics trade covariance: time of the covariance filter against its error.

#ifndef TradeCovariance_h
#define TradeCovariance_h

#include <string>

struct CovarianceTradeOptions
{
  std::string Folder = "trade";
  std::string Field = "tubes"; // see GalleryField()
  std::string File;            // a volume instead of the field
  double Radius = 10.0;
  double Tolerance = 0.05;
};

// Writes covariance.csv, covariance-poles.csv, covariance.svg and covariance-poles.svg.
void TradeCovariance(const CovarianceTradeOptions& options);

#endif
