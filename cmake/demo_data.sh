#!/usr/bin/env bash
# Unpacks the real clouds and meshes of Debian's package libcgal-demo, unless they are there already. Some images
# are set up to leave out /usr/share/doc, where it puts them; then they are taken from the package itself.
#
#   cmake/demo_data.sh FOLDER     leaves FOLDER/meshes and FOLDER/points_3, or nothing and the exit status 1
set -euo pipefail

folder=$1
[ ! -d "$folder/points_3" ] || exit 0
mkdir -p "$(dirname "$folder")"
scratch=$(mktemp -d "$folder.XXXXXX")
trap 'rm -rf "$scratch"' EXIT

archive=/usr/share/doc/libcgal-dev/data.tar.gz
if [ ! -f "$archive" ]; then
  (cd "$scratch" && apt-get download libcgal-demo && dpkg-deb -x libcgal-demo_*.deb .) > /dev/null 2>&1 || true
  archive=$scratch$archive
fi
if [ ! -f "$archive" ]; then
  echo "no real clouds: this machine leaves out /usr/share/doc/libcgal-dev/data.tar.gz, and its package" \
    "libcgal-demo could not be downloaded" >&2
  exit 1
fi
tar -xzf "$archive" -C "$scratch" data/points_3 data/meshes
# Complete or not at all, whoever else is at it.
mv -T "$scratch/data" "$folder" 2> /dev/null || [ -d "$folder/points_3" ]
