// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Pictures lit by ambient light whose visibility is found by rays, in double. They take minutes: the gallery
// shows those of Testing/Data/Traced, which `volumeoptics gallery --trace Testing/Data/Traced` made.

#ifndef TracedPicture_h
#define TracedPicture_h

#include <string>

class VolumeScene;

// What the scene shows, by rays out of a cone about the line of sight (half angle in degrees; 180: from
// everywhere), in place of its own occlusion. Draws a frame first.
void TracePicture(VolumeScene& scene, double angle, int rays, const std::string& pngFile);

// Writes a kept one. Throws UserError.
void WriteTracedPicture(const std::string& name, const std::string& pngFile);

#endif
