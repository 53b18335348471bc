// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The plugin on a client and on its server.

#ifndef PluginVersions_h
#define PluginVersions_h

#include <string>

/** On a client, whose server has the plugin in another version, that and what to do, once for a session; else nothing.
 * ParaView itself says only where it is missing. */
std::string FindOtherVersion();

#endif
