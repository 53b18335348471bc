#!/usr/bin/env bash
# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# ClientServer.py with a server of two ranks. Arguments: the folder of ParaView's programs, mpirun, and whether
# the plugin is on both sides (both) or on the client's alone (client).

set -euo pipefail
programs=$1
mpirun=$2
sides=$3
folder=$(dirname "${BASH_SOURCE[0]}")
port=$((20000 + $$ % 20000))
log=$VOLUMEOPTICS_OUTPUT/server-$sides.log

"$mpirun" --oversubscribe -n 2 "$programs/pvserver" --server-port=$port --force-offscreen-rendering >"$log" 2>&1 &
server=$!
trap 'kill $server 2>/dev/null || true' EXIT
for _ in $(seq 100); do
  grep -q "Accepting connection" "$log" && break
  sleep 0.2
done
"$programs/pvpython" "$folder/ClientServer.py" $port "$sides" 2>&1
wait $server || true
cat "$log"
