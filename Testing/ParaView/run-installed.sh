#!/usr/bin/env bash
# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Installs the plugin's component, and runs Installed.py with ParaView's programs, which find the plugin by
# themselves. Arguments: CMake, the build tree, where to install, ParaView's programs.

set -euo pipefail
rm -rf "$3"
"$1" --install "$2" --prefix "$3" --component paraview_plugins
plugin=$(find "$3" -name VolumeOptics.so)
PV_PLUGIN_PATH=$(dirname "$plugin")
export PV_PLUGIN_PATH
for program in "${@:4}"; do
  "$program" "$(dirname "${BASH_SOURCE[0]}")/Installed.py" | grep "all checks passed"
done
