#!/usr/bin/env bash
# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Installs what is missing of debian-packages.txt, as root or through sudo.
#
#   Module/install-packages.sh                  everything
#   Module/install-packages.sh --without-tests  what it takes to build and run
#   Module/install-packages.sh --with-paraview  everything, and what the ParaView plugin takes

set -euo pipefail
list=$(dirname "${BASH_SOURCE[0]}")/debian-packages.txt
case "${1:-}" in
  --without-tests) wanted=$(sed '/^# To test/,$d' "$list") ;;
  --with-paraview) wanted=$(cat "$list" "${list%.txt}-paraview.txt") ;;
  *) wanted=$(cat "$list") ;;
esac

missing=()
for package in $(sed 's/#.*//' <<<"$wanted"); do
  dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'install ok installed' ||
    missing+=("$package")
done
[ ${#missing[@]} -gt 0 ] || exit 0

sudo=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    echo "Install these packages first: ${missing[*]}" >&2
    exit 1
  fi
  sudo=(sudo)
fi
"${sudo[@]}" apt-get update -q
"${sudo[@]}" env DEBIAN_FRONTEND=noninteractive \
  apt-get install -q -y --no-install-recommends "${missing[@]}"
