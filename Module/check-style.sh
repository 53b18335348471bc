#!/usr/bin/env bash
# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Checks the style of the C++ files that git tracks.
#
#   Module/check-style.sh                 clang-format; quick, for .git/hooks/pre-commit
#   Module/check-style.sh --fix           lets clang-format write the files
#   Module/check-style.sh --tidy BUILD    clang-tidy, with BUILD/compile_commands.json, on the files
#                                         that differ from origin/main, or on all (with CI in the
#                                         environment, or where there is no origin/main); all take
#                                         400 s of processor time, so 3 to 4 minutes on two cores

set -euo pipefail
# by a variable: cd "" would succeed where git is missing or refuses the folder
top=$(git rev-parse --show-toplevel)
cd "$top"

format() {
  git ls-files '*.h' '*.cxx' | xargs clang-format "$@"
}

# Those that this branch changes, or all, as in CI.
sources_to_tidy() {
  local base
  if [ -z "${CI:-}" ] && base=$(git merge-base HEAD origin/main 2>/dev/null) &&
    [ "$base" != "$(git rev-parse HEAD)" ]; then
    git diff --name-only --diff-filter=d "$base" -- '*.cxx'
  else
    git ls-files '*.cxx'
  fi
}

tidy() {
  local build=$1 files=() log clean bad
  while read -r file; do
    # What is compiled is in the data base of commands.
    if grep -q "\"file\": \"$PWD/$file\"" "$build/compile_commands.json" && [ -e "$file" ]; then
      files+=("$file")
    fi
  done < <(sources_to_tidy)
  if [ ${#files[@]} -eq 0 ]; then
    echo "clang-tidy: no compiled C++ file differs from origin/main"
    return 0
  fi

  log=$(mktemp)
  printf '%s\0' "${files[@]}" |
    xargs -0 -n 1 -P "$(nproc)" sh -c '
      if clang-tidy --quiet -p "$0" --extra-arg=-Wno-unknown-warning-option "$2" 2>/dev/null; then
        echo "clean $2" >>"$1"
      else
        echo "bad $2" >>"$1"
      fi' "$build" "$log"
  clean=$(grep -c '^clean' "$log" || true)
  bad=$(sed -n 's/^bad //p' "$log")
  echo "clang-tidy: $(wc -l <"$log") of ${#files[@]} files were checked, $clean are clean"
  rm -f "$log"
  if [ -n "$bad" ]; then
    printf 'Not clean: %s\n' $bad
    return 1
  fi
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
