#!/usr/bin/env bash
# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Checks the style of the C++ files that git tracks.
#
#   Module/check-style.sh                 clang-format; quick, for .git/hooks/pre-commit
#   Module/check-style.sh --fix           lets clang-format write the files
#   Module/check-style.sh --tidy BUILD    clang-tidy, with BUILD/compile_commands.json, on the files
#                                         that differ from origin/main, or on all; it stops after
#                                         TIDY_SECONDS (300) and says how many files are left

set -euo pipefail
cd "$(git rev-parse --show-toplevel)"

sources() { git ls-files "$@"; }

format() {
  sources '*.h' '*.cxx' | xargs clang-format "$@"
}

changed_sources() {
  local base
  if base=$(git merge-base HEAD origin/main 2>/dev/null) &&
    [ "$base" != "$(git rev-parse HEAD)" ]; then
    git diff --name-only --diff-filter=d "$base" -- '*.cxx'
  else
    sources '*.cxx'
  fi
}

tidy() {
  local build=$1 files=() left
  # Only what is compiled, and so is in the data base of commands.
  while read -r file; do
    if grep -q "\"file\": \"$PWD/$file\"" "$build/compile_commands.json"; then
      files+=("$file")
    fi
  done < <(changed_sources)
  [ ${#files[@]} -gt 0 ] || return 0

  local log status=0
  log=$(mktemp)
  printf '%s\0' "${files[@]}" |
    timeout "${TIDY_SECONDS:-300}" xargs -0 -n 1 -P "$(nproc)" sh -c '
      clang-tidy --quiet -p "$0" --extra-arg=-Wno-unknown-warning-option "$2" 2>/dev/null &&
        echo "$2" >>"$1"' "$build" "$log" || status=$?
  left=$((${#files[@]} - $(wc -l <"$log")))
  rm -f "$log"
  if [ "$status" -eq 124 ]; then
    echo "clang-tidy: time is up; $left of ${#files[@]} files were not checked"
    return 0
  fi
  echo "clang-tidy: $((${#files[@]} - left)) of ${#files[@]} files are clean"
  return "$status"
}

case "${1:-}" in
  "") format --dry-run --Werror ;;
  --fix) format -i ;;
  --tidy) tidy "${2:?usage: check-style.sh --tidy BUILD}" ;;
  *)
    echo "usage: check-style.sh [--fix | --tidy BUILD]" >&2
    exit 2
    ;;
esac
