#!/usr/bin/env bash
# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Everything that CI runs: packages, style, build, and all tests, in X windows and without a display,
# against the same baselines, then the plugin for ParaView and its tests. Closes with CTest's last lines. Arguments are passed to CTest:
#
#   ./test.sh                  everything
#   ./test.sh -L image         the tests of one label
#   ./test.sh -R Headless      the tests of one name

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

build=build-ci
plugin_build=build-paraview
failures=()

# step NAME COMMAND...: a failure is remembered, so that the steps after it still run.
step() {
  local name=$1
  shift
  echo
  echo "== $name ($((SECONDS / 60)) min)"
  "$@" || failures+=("$name")
}

launcher=()
if command -v ccache >/dev/null; then
  launcher=(-D CMAKE_CXX_COMPILER_LAUNCHER=ccache)
fi

build() {
  cmake --preset ci "${launcher[@]}" && cmake --build "$build"
}

build_paraview_plugin() {
  local overlay=$PWD/$plugin_build/overlay
  Module/ParaView/make-overlay.sh "$overlay" &&
    cmake --preset paraview "${launcher[@]}" -D "ParaView_DIR=$(cat "$overlay/cmake-folder")" &&
    cmake --build "$plugin_build"
}

test_in_paraview() {
  ctest --test-dir "$plugin_build" --output-on-failure -j "$(nproc)" "$@" 2>&1 | tee "$plugin_build/ctest.log"
}

run_ctest() {
  local log=$1
  shift
  ctest --test-dir "$build" --output-on-failure -j "$(nproc)" "$@" 2>&1 | tee "$log"
}

test_in_x_windows() {
  xvfb-run -a -s "-noreset -screen 0 1280x1024x24" \
    env -u VOLUMEOPTICS_HEADLESS bash -c "$(declare -f run_ctest); set -o pipefail; build=$build;"'
      run_ctest "$@"' bash "$build/ctest-x.log" "$@"
}

# Filters have no window, and were tested in the first run.
test_without_display() {
  (
    unset DISPLAY
    export VOLUMEOPTICS_HEADLESS=1
    run_ctest "$build/ctest-headless.log" -LE '^filter$' "$@"
  )
}

closing_lines() {
  echo
  echo "== $1"
  sed -n '/tests passed/,$p' "$2" 2>/dev/null || true
}

step "packages" Module/install-packages.sh --with-paraview
[ ${#failures[@]} -eq 0 ] || exit 1
step "format" Module/check-style.sh
step "build" build
case " ${failures[*]:-} " in
  *" build "*) exit 1 ;;
esac
step "clang-tidy" Module/check-style.sh --tidy "$build"
step "tests in X windows" test_in_x_windows "$@"
step "tests without a display" test_without_display "$@"
step "build of the ParaView plugin" build_paraview_plugin
step "tests in ParaView" test_in_paraview "$@"

closing_lines "tests in ParaView" "$plugin_build/ctest.log"
closing_lines "tests without a display" "$build/ctest-headless.log"
closing_lines "tests in X windows" "$build/ctest-x.log"
if [ ${#failures[@]} -gt 0 ]; then
  echo
  printf 'Failed: %s\n' "${failures[@]}"
  exit 1
fi
