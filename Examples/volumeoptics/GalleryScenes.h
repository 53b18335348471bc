// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The scenes of the gallery and of its scores: light, camera, transfer function, sampling; and the models
// with one size of highlight.

#ifndef GalleryScenes_h
#define GalleryScenes_h

#include "PictureSettings.h"

constexpr double HighGlossiness = 80.0;
constexpr double LowGlossiness = 10.0;

PictureSettings Cranium();
PictureSettings MarschnerLobb();
PictureSettings Primitive();
PictureSettings PackedEllipsoids();
PictureSettings Tubes();

// Estimated from all of the surroundings' voxels.
void TakeWholeBall(AmbientSettings& ambient, double radius, double resolutionFactor);

OpticsSettings Model(const std::string& model, double glossiness = -1.0, double anisotropy = -1.0);
OpticsSettings BlinnPhongOf(double exponent);
OpticsSettings WardOf(double exponent, double anisotropy);
OpticsSettings LafortuneOf(double exponent, double anisotropy);

#endif
