#!/usr/bin/env bash
# Uses an installed pcl_manifold as its users would: through CMake, through pkg-config, and by its apps.
#
#   test/consumer/run.sh PREFIX core|delaunay      the second names the last component that was installed
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
prefix=$(cd "$1" && pwd)
component=$2
expect_delaunay=$([ "$component" = delaunay ] && echo ON || echo OFF)

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

echo "--- consumer through CMake"
cmake -S "$here" -B "$work/cmake" -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$prefix" \
  -DEXPECT_DELAUNAY="$expect_delaunay" > "$work/cmake.log" || { cat "$work/cmake.log"; exit 1; }
grep 'refused as it should be' "$work/cmake.log" || true
cmake --build "$work/cmake" > "$work/build.log" || { cat "$work/build.log"; exit 1; }
for program in "$work"/cmake/use_*; do "$program"; done

echo "--- consumer through pkg-config"
pc=$(dirname "$(find "$prefix" -name pcl_manifold_core.pc)")
for name in core delaunay; do
  if [ $name = delaunay ] && [ "$component" = core ]; then
    continue
  fi
  # shellcheck disable=SC2046
  g++ -std=c++17 -O1 "$here/use_$name.cpp" -o "$work/$name" \
    $(PKG_CONFIG_PATH=$pc pkg-config --cflags --libs pcl_manifold_$name)
  LD_LIBRARY_PATH=$(PKG_CONFIG_PATH=$pc pkg-config --variable=libdir pcl_manifold_core) "$work/$name"
done

echo "--- installed apps"
for app in "$prefix"/bin/*; do
  [ -x "$app" ] || continue
  "$app" -h > "$work/help" || { echo "error: $app -h failed"; cat "$work/help"; exit 1; }
  echo "$(basename "$app"): $(head -n 1 "$work/help")"
done
