#!/usr/bin/env bash
# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Makes the pictures of this folder from those of a gallery (default: gallery/ of the repository, which
# ./quickstart.sh draws). Needs ImageMagick.

set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
cd "${1:-$here/../../gallery}/images"

row() { # NAME SIZE LABEL=PICTURE ...
  local name=$1 size=$2 arguments=() item
  shift 2
  for item in "$@"; do
    arguments+=(-label "${item%%=*}" "${item#*=}.png")
  done
  montage -font DejaVu-Sans -pointsize 13 "${arguments[@]}" -tile "$#x1" -geometry "${size}x${size}+3+3" miff:- |
    convert - +dither -colors 128 -strip "PNG8:$here/$name.png"
}

row cranium 300 "stock VTK=cranium-vtk" "phase function=cranium-none" "Blinn-Phong=cranium-blinn-phong-high" \
  "Ward=cranium-ward-high" "Lafortune=cranium-lafortune-high"
row skin 400 "phase function=skin-none" "Blinn-Phong=skin-blinn-phong" "Lafortune=skin-lafortune"
row marschner-lobb 400 "Blinn-Phong=marschner-lobb-blinn-phong" \
  "Lafortune, gamma 10=marschner-lobb-lafortune-10" "Lafortune, gamma 60=marschner-lobb-lafortune-60"
row vortex-tubes 400 "phase function=tubes-none" "Blinn-Phong=tubes-blinn-phong" "Lafortune=tubes-lafortune"
row data-space 400 "opacity by length=coulomb-standard" "by difference of the data=coulomb-data" \
  "with silhouettes=coulomb-data-exact" "and light=coulomb-lit-data-exact"
row lighting 400 "no light=lighting-none" "uniform light=lighting-uniform" "opacity raised=lighting-opacity" \
  "lighting transfer function=lighting-chosen"
row occlusion 400 "Lambert=occlusion-tubes-lambert" "occlusion=occlusion-tubes" "no shadows=shadow-bone-off" \
  "soft shadows=shadow-bone-soft"
row lines 400 "a million segments as tubes, 100 samples a pixel=lines-spirals-1m-tubes" "as voxels=lines-spirals-1m" \
  "10 million, thin=lines-ring-secondaries" "thick=lines-ring-radii"
