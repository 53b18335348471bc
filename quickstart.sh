#!/usr/bin/env bash
# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# From a fresh Debian machine to gallery/index.html: installs the packages of
# Module/debian-packages.txt (those to build and run), builds, and draws the gallery of the CT cranium of
# Debian's invesalius-examples. No X server is needed. A second run does only what is left to do.
#
#   ./quickstart.sh              everything
#   ./quickstart.sh --force      draw all pictures again; arguments go to 'volumeoptics gallery'

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

build=build-release
examples=/usr/share/doc/invesalius-examples/examples/Cranium.inv3

step() {
  echo "== $1 (${SECONDS} s)" >&2
}

# Minimal images of Debian leave /usr/share/doc out: then the CT is unpacked beside the build.
find_cranium() {
  cranium=$examples
  [ ! -f "$cranium" ] || return 0
  cranium=$PWD/$build/data$examples
  [ ! -f "$cranium" ] || return 0
  mkdir -p "$build/data"
  (cd "$build/data" && apt-get download -q invesalius-examples && dpkg -x invesalius-examples_*.deb .)
}

build_program() {
  local launcher=()
  if command -v ccache >/dev/null; then
    launcher=(-D CMAKE_CXX_COMPILER_LAUNCHER=ccache)
  fi
  cmake --preset release -D Python3_EXECUTABLE=/usr/bin/python3 "${launcher[@]}" >"$build.log" ||
    { cat "$build.log" >&2; exit 1; }
  rm "$build.log"
  cmake --build "$build"
}

step "packages"
Module/install-packages.sh --without-tests
step "build"
build_program
find_cranium
step "gallery"
"$build/bin/volumeoptics" gallery --output gallery --cranium "$cranium" "$@"
step "done: open gallery/index.html"
