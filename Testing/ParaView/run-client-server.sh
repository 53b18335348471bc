#!/usr/bin/env bash
# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# ClientServer.py with a server of two ranks. Arguments: the folder of ParaView's programs, mpirun, and whether
# the plugin is on both sides (both), there in another version on the server (other), or on the client's alone (client).

set -euo pipefail
programs=$1
mpirun=$2
sides=$3
folder=$(dirname "${BASH_SOURCE[0]}")
port=$((20000 + $$ % 20000))
log=$VOLUMEOPTICS_OUTPUT/server-$sides.log

# Another version of the plugin: the same but for the number's digits, each of which another one takes the place of.
if [ "$sides" = other ]; then
  folder_of_other=$VOLUMEOPTICS_OUTPUT/other
  rm -rf "$folder_of_other"
  cp -r "$(dirname "$VOLUMEOPTICS_PLUGIN")" "$folder_of_other"
  export VOLUMEOPTICS_OTHER_PLUGIN=$folder_of_other/VolumeOptics.so
  VOLUMEOPTICS_OTHER_VERSION=$(tr 0-9 1-90 <<<"$VOLUMEOPTICS_VERSION")
  export VOLUMEOPTICS_OTHER_VERSION
  sed -i "s/${VOLUMEOPTICS_VERSION//./\\.}/$VOLUMEOPTICS_OTHER_VERSION/g" "$VOLUMEOPTICS_OTHER_PLUGIN"
fi

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
