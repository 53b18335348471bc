#!/usr/bin/env bash
# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# The tables of docs/scaling.md, as they stand there: BenchmarkDistributed on 1, 2 and 4 processes, of a volume and lines
# that stay (strong scaling) and that grow with the processes (weak).
#
#   Testing/Benchmark/distributed.sh BUILD [options of BenchmarkDistributed]

set -euo pipefail
program=${1:?usage: distributed.sh BUILD [options]}/bin/BenchmarkDistributed
shift

# More processes than cores, as root, in containers.
export OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_btl_vader_single_copy_mechanism=none
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1

# Rows of one filter on 1, 2, 4 processes, one after the other, to a row of the table.
to_table() {
  awk '
    / processes, / { scene = scene (scene ? "; " : "") $0 }
    NF == 6 && $2 ~ /^[0-9.]+$/ {
      if (!($1 in seconds)) { order[++count] = $1 }
      between = ($1 in seconds) ? ", " : ""
      seconds[$1] = seconds[$1] between ($3 < 0.1 ? sprintf("%.3f", $3) : sprintf("%.2f", $3))
      memory[$1] = memory[$1] between sprintf("%.0f", $4)
      messages[$1] = messages[$1] between sprintf("%.0f", $5)
      if ($6 > 0) { ghosts[$1] = ghosts[$1] between $6 }
    }
    END {
      print scene "\n"
      print "| filter | seconds of the processor with 1, 2, 4 processes | MiB a process | KiB handed to MPI by a process | input over output voxels |"
      print "| --- | --- | --- | --- | --- |"
      for (i = 1; i <= count; ++i) {
        name = order[i]
        printf "| %s | %s | %s | %s | %s |\n", name, seconds[name], memory[name], messages[name], ghosts[name]
      }
      print ""
    }'
}

measure() {
  local processes
  for processes in 1 2 4; do
    mpirun -n "$processes" "$program" "$@"
  done | to_table
}

measure --size 160 --segments 1000000 "$@"
measure --weak --size 112 --segments 500000 "$@"
