#!/usr/bin/env bash
# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Ranks.py on one rank, two and three, and the comparison. Arguments: pvbatch, mpirun.

set -euo pipefail
pvbatch=$1
mpirun=$2
export LP_NUM_THREADS=1 # the rasteriser of each rank
folder=$(dirname "${BASH_SOURCE[0]}")

run() {
  local log=$VOLUMEOPTICS_OUTPUT/ranks-$1.log
  "${@:2}" "$pvbatch" "$folder/Ranks.py" "$1" >"$log" 2>&1 || true
  if ! grep -q "all checks passed" "$log" || grep -qE "Traceback|ERR\||ERROR:" "$log"; then
    cat "$log"
    exit 1
  fi
  grep WARN "$log" || true
}
run 1
run 2 "$mpirun" --oversubscribe -n 2
run 3 "$mpirun" --oversubscribe -n 3
"$pvbatch" "$folder/CompareRanks.py" 2 3
