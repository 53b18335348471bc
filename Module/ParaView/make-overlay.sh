#!/usr/bin/env bash
# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Makes a ParaView to build against and to run, beside Debian's VTK for Python.
#
#   Module/ParaView/make-overlay.sh FOLDER
#   cmake -D VOLUMEOPTICS_BUILD_PARAVIEW_PLUGIN=ON -D "ParaView_DIR=$(cat FOLDER/cmake-folder)" ...
#
# Debian's python3-paraview and python3-vtk9 exclude each other, but paraview-dev is of no use without the
# first, and libvtk9-dev depends on the second. So python3-paraview is unpacked, not installed, and
# FOLDER joins it to the installed packages paraview and paraview-dev. A FOLDER made from the same version
# is left as it is.

set -euo pipefail

folder=${1:?usage: make-overlay.sh FOLDER}
version=$(dpkg-query -W -f '${Version}' paraview)
[ "$(cat "$folder/version" 2>/dev/null)" != "$version" ] || exit 0

rm -rf "$folder"
mkdir -p "$folder/python3-paraview"
folder=$(cd "$folder" && pwd)
libraries=lib/$(dpkg-architecture -qDEB_HOST_MULTIARCH)

# apt-get downloads into the current folder; where it has no lists of packages, root can get them.
download() {
  apt-get download -q "python3-paraview=$version" 2>/dev/null
}
(
  cd "$folder/python3-paraview"
  download || { apt-get update -q && download; }
  dpkg -x ./*.deb .
  rm ./*.deb
)

# Programs find Python's modules, and CMake's files their prefix, from where they really lie: these are
# copied. Everything else is linked to.
join() {
  local file=$1 target=$folder/${1#/usr/}
  mkdir -p "$(dirname "$target")"
  case $file in
    /usr/bin/* | */cmake/*) cp -a "$file" "$target" ;;
    *) ln -s "$file" "$target" ;;
  esac
}
while read -r file; do
  if [ -f "$file" ] || [ -L "$file" ]; then
    join "$file"
  fi
done < <(dpkg -L paraview paraview-dev | grep -E '^/usr/(bin|lib)/' | sort -u)
mkdir "$folder/include"
ln -s /usr/include/paraview-5.11 "$folder/include/paraview-5.11"

cp -a "$folder/python3-paraview/usr/bin/." "$folder/bin/"
ln -s "$folder/python3-paraview/usr/lib/python3" "$folder/lib/python3"
mkdir -p "$folder/$libraries/vtk"
ln -s "$folder/python3-paraview/usr/$libraries/vtk/hierarchy" "$folder/$libraries/vtk/hierarchy"
echo "$folder/$libraries/cmake/paraview-5.11" >"$folder/cmake-folder"
echo "$version" >"$folder/version"
