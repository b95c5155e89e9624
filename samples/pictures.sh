#!/usr/bin/env bash
# Draws the pictures of README.md and of the pages of the reference: generated clouds and a model of Debian's
# libcgal-demo, drawn by the apps' -picture, scaled down and with few colours, so that each has less than 150 kB.
# Needs netpbm and pngquant (apt-get install netpbm pngquant); may be run again.
#
#   samples/pictures.sh [FOLDER [BIN]]     FOLDER is include/pcl/manifold/pages/pictures in the repository if not given,
#                                          BIN, where the apps are, build/release/bin
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
out=$(realpath -m "${1:-$root/include/pcl/manifold/pages/pictures}")
bin=$(realpath -m "${2:-$root/build/release/bin}")
most=150000

for tool in pngtopnm pamscale pnmtopng pngquant; do
  command -v "$tool" > /dev/null || { echo "error: no $tool: apt-get install netpbm pngquant" >&2; exit 1; }
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$out"
"$root/cmake/demo_data.sh" "$work/data"
cp "$work/data/meshes/knot1.off" "$work/"
cd "$work" # titles are the names of the inputs

# NAME APP INPUT OUTPUT: what the app draws as NAME.png.
picture () {
  local name=$1
  "$bin/$2" "${@:3}" -picture drawn.png -quiet
  pngtopnm drawn.png | pamscale -quiet -width 960 | pnmtopng -quiet -compression 9 > small.png
  pngquant --force --speed 1 32 --output "$out/$name.png" small.png
  local size
  size=$(stat -c %s "$out/$name.png")
  echo "$name.png: $size bytes"
  [ "$size" -lt "$most" ] || { echo "error: $name.png: $size bytes are too many" >&2; exit 1; }
}

"$bin/generate_cloud" lidar-aerial aerial.pcd -n 40000 -quiet
"$bin/generate_cloud" scene scene.pcd -spacing 0.06 -quiet
"$bin/generate_cloud" genus3 genus3.pcd -n 60000 -quiet
picture wires pcl_dimension_detection aerial.pcd dimensions.pcd
picture shape pcl_cocone_shape scene.pcd shape.ply
picture fixed_point pcl_fixed_point_reconstruction knot1.off surface.ply
picture graph pcl_graph_reconstruction genus3.pcd coarse.ply
picture landmarks landmarks_to_mesh genus3.pcd fine.ply
