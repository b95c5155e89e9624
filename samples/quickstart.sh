#!/usr/bin/env bash
# From a fresh Debian 12 to meshes, reports and pictures: installs what is missing (as root, or through sudo),
# builds the project, and finds the dimension and the shape of real and of generated clouds. Works without a
# display; may be run again.
#
#   samples/quickstart.sh [FOLDER]     where the results go; out/quickstart in the repository if not given
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
out=$(realpath -m "${1:-$root/out/quickstart}")
bin=$root/build/release/bin
cd "$root"

say () { echo "[$(printf '%4d' "$SECONDS") s] $*"; }

say "1/7 dependencies"
cmake/install_dependencies.sh build samples

jobs=$(cmake/build_jobs.sh)
say "2/7 build, release, $jobs at once (the first time takes minutes)"
cmake --preset release --log-level=WARNING > /dev/null
cmake --build --preset release --parallel "$jobs"
mkdir -p "$out/clouds"

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

say "3/7 clouds"
"$bin/generate_cloud" scene "$out/clouds/scene.pcd" -spacing 0.05
"$bin/generate_cloud" lidar-aerial "$out/clouds/lidar-aerial.pcd"
"$bin/generate_cloud" genus3 "$out/clouds/genus3.pcd" -n 100000 -sampling random
real=()
if cmake/demo_data.sh "$scratch/data"; then
  real=(points_3/b9_training.ply points_3/kitten.xyz meshes/bunny00.off meshes/knot1.off)
  for cloud in "${real[@]}"; do
    cp "$scratch/data/$cloud" "$out/clouds/"
  done
else
  say "going on with the generated clouds alone"
fi

# Runs an app on a cloud, with options of the app; the results are named after both.
run () {
  local app=$1 kind=$2 cloud=$3 type=$4
  say "$kind of $cloud"
  "$bin/$app" "$out/clouds/$cloud" "$out/${cloud%.*}-$kind.$type" "${@:5}" \
    -report "$out/${cloud%.*}-$kind.json" -picture "$out/${cloud%.*}-$kind.png"
}
dimension () { run pcl_dimension_detection dimension "$1" pcd "${@:2}"; }
shape () { run pcl_cocone_shape shape "$1" ply "${@:2}"; }
graph () { run pcl_graph_reconstruction graph "$1" ply "${@:2}"; }
fixed_point () { run pcl_fixed_point_reconstruction fixed-point "$1" ply "${@:2}"; }
landmarks () { run landmarks_to_mesh landmarks "$1" ply "${@:2}"; }

say "4/7 dimension: which points lie on curves, on surfaces, in solids"
dimension scene.pcd
dimension lidar-aerial.pcd
"$bin/pcl_dimension_detection" "$out/clouds/lidar-aerial.pcd" "$out/lidar-aerial-wires.pcd" -only horizontal
if [ ${#real[@]} -gt 0 ]; then
  dimension b9_training.ply
fi

say "5/7 shape: edges, triangles and tetrahedra"
shape scene.pcd
if [ ${#real[@]} -gt 0 ]; then
  shape kitten.xyz
  shape bunny00.off -watertight
  shape knot1.off
  shape b9_training.ply -thin 4
fi

say "6/7 a coarse mesh from graph distances alone"
graph genus3.pcd
if [ ${#real[@]} -gt 0 ]; then
  graph bunny00.off
  graph knot1.off
fi

say "7/7 a surface over all points, with a guarantee; and one that grows out of a coarse mesh"
fixed_point genus3.pcd
if [ ${#real[@]} -gt 0 ]; then
  fixed_point bunny00.off
  landmarks kitten.xyz
fi

say "done. In $out:"
(cd "$out" && find . -maxdepth 1 -type f -printf '%f\t%k KiB\n' | sort | awk -F '\t' '
  function kind(name) {
    if (name ~ /\.json$/) return "report"
    if (name ~ /\.png$/) return "picture"
    if (name ~ /\.ply$/) return "mesh"
    if (name ~ /-wires/) return "the points of wires alone"
    return "cloud with the fields dimension, manifold_dimension, boundary, scale, curve and more"
  }
  { printf "  %-34s %10s  %s\n", $1, $2, kind($1) }')
