// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// What a scene asks for, and what the terms can serve: questions that several terms ask.

#ifndef SceneNeeds_h
#define SceneNeeds_h

#include "OpticsScene.h"

#include <string>

/** What no term can draw, in words; empty where all can. */
std::string FindUnsupported(const OpticsScene& scene);

/** The same for what classifies or lights VTK's samples. */
std::string FindUnsupportedBySamples(const OpticsScene& scene);

/** Whether the volume is lines as anisotropic voxels, and what these can't be drawn with. */
bool HasLineVoxels(const OpticsScene& scene);
std::string FindUnsupportedByLines(const OpticsScene& scene);

/** The same for the integral along the ray. */
std::string FindUnsupportedByIntegral(const OpticsScene& scene);

/** Whether the scene asks for an integral other than VTK's own, and whether it gets it. */
bool WantsIntegral(const OpticsScene& scene);
bool ReplacesIntegral(const OpticsScene& scene);
bool IntegratesInData(const OpticsScene& scene);

/** Whether the scene asks for light other than VTK's own, and whether it gets it. */
bool WantsLighting(const OpticsScene& scene);
bool ReplacesLighting(const OpticsScene& scene);

/** Whether a lighting transfer function gives the coefficients, and whether normals take their side from
 * the classified density. */
bool HasLightingTable(const OpticsScene& scene);
bool HasHybridNormals(const OpticsScene& scene);

/** Whether the scene asks for colour and opacity by several samples, why they can't be had (empty where they
 * can), and whether it gets them. */
bool WantsClassification(const OpticsScene& scene);
std::string FindUnsupportedByClassification(const OpticsScene& scene);
bool ReplacesClassification(const OpticsScene& scene);

bool IsPreIntegrated(const OpticsScene& scene);
bool HasIsosurfaces(const OpticsScene& scene);
bool HasSilhouettes(const OpticsScene& scene);

/** Whether light shines through from behind. */
bool TransmitsLight(const OpticsScene& scene);

/** Whether the scene asks for ambient light other than white and everywhere the same, and whether it gets it. */
bool WantsAmbientLight(const OpticsScene& scene);
bool HasAmbientLight(const OpticsScene& scene);

/** Whether the scene asks for shadows of lights, of which there are some. */
bool WantsShadows(const OpticsScene& scene);

/** Whether it is darkened by what is in front. */
bool HasOcclusion(const OpticsScene& scene);

/** Whether rays look at the volume about a sample before the sweep's result is looked up: where one function of the
 * scalar says what is there. */
bool GathersOcclusion(const OpticsScene& scene);

bool HasGradientOpacity(const OpticsScene& scene);
bool Is2D(const OpticsScene& scene);
bool HasLabels(const OpticsScene& scene);

/** Colour that does not come from the scalar that opacity depends on: dependent components. */
bool HasOwnColor(const OpticsScene& scene);

bool HasSurface(const OpticsScene& scene);

/** Normals are those of the classified extinction, but VTK's model takes the scalar's. */
bool HasExtinctionSurface(const OpticsScene& scene);

bool IsAnisotropic(const OpticsScene& scene);

/** Where opacity depends on more than the scalar, its gradient is not along the stored normal. */
bool NeedsCentralDifferences(const OpticsScene& scene);

bool NeedsScalarGradient(const OpticsScene& scene);
bool StoresScalarGradient(const OpticsScene& scene);

/** Whether stored normals, and with them tangent frames, are looked up. */
bool NeedsFrames(const OpticsScene& scene);

/** Whether the opacity and the colour function are looked up at a sample, as they are: not corrected for
 * the step. */
bool NeedsOpacityTable(const OpticsScene& scene);
bool NeedsColorTable(const OpticsScene& scene);

#endif
