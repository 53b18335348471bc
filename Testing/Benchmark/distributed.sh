#!/usr/bin/env bash
# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# The tables of docs/scaling.md: BenchmarkDistributed on 1, 2 and 4 processes, of a volume and lines that stay
# (strong scaling) and that grow with the processes (weak).
#
#   Testing/Benchmark/distributed.sh BUILD [options of BenchmarkDistributed]

set -euo pipefail
program=${1:?usage: distributed.sh BUILD [options]}/bin/BenchmarkDistributed
shift

# More processes than cores, as root, in containers.
export OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_btl_vader_single_copy_mechanism=none
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1

for scaling in "--size 160 --segments 1000000" "--weak --size 112 --segments 500000"; do
  for processes in 1 2 4; do
    mpirun -n "$processes" "$program" $scaling "$@"
  done
done
