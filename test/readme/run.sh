#!/usr/bin/env bash
# Builds and runs the code of README.md, and of other pages, against an installed tree, as a reader would.
#
#   test/readme/run.sh BUILD [PAGE.md ...]     BUILD is a folder that the project with its apps was built in
#
# Every program has a row in expected.txt that says how it is called and what it prints.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
readme=$here/../../README.md
build=$1
shift

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cmake --install "$build" --prefix "$work/installed" > "$work/install.log"
"$work/installed/bin/generate_cloud" scene "$work/scene.pcd" -n 3000 -quiet
"$work/installed/bin/generate_cloud" torus "$work/torus.pcd" -n 20000 -quiet

fail () { echo "error: $*" >&2; exit 1; }

# Runs a program in the folder of the clouds, and looks for the line that it has to print.
check () {
  local program=$1 row arguments pattern
  row=$(grep -E "^$(basename "$program") +\|" "$here/expected.txt") ||
    fail "$(basename "$program") has no row in test/readme/expected.txt"
  IFS='|' read -r _ arguments pattern <<< "$row"
  pattern=$(sed 's/^ *//; s/ *$//' <<< "$pattern")
  # shellcheck disable=SC2086
  (cd "$work" && "$program" $arguments > "$work/output") || fail "$(basename "$program") $arguments failed"
  if [ -n "$pattern" ] && ! grep -qxE "$pattern" "$work/output"; then
    fail "$(basename "$program") $arguments printed '$(cat "$work/output")', not '$pattern'"
  fi
  echo "$(basename "$program"): $(cat "$work/output")"
}

for page in "$readme" "$@"; do
  echo "--- $(basename "$page")"
  project=$work/$(basename "$page" .md)
  mkdir "$project"
  awk -v folder="$project" -f "$here/blocks.awk" "$page"
  # A page without a project of its own is built as README's programs are.
  [ -e "$project/CMakeLists.txt" ] ||
    grep -E '^(cmake_minimum_required|project|set|find_package) ' "$work/README/CMakeLists.txt" > "$project/CMakeLists.txt"
  for source in "$project"/*.cpp; do
    program=$(basename "$source" .cpp)
    grep -qw "$program" "$project/CMakeLists.txt" ||
      printf '%s\n' "add_executable ($program $program.cpp)" \
        "target_link_libraries ($program PRIVATE pcl_manifold::delaunay \${PCL_LIBRARIES})" >> "$project/CMakeLists.txt"
  done
  cmake -S "$project" -B "$project/build" -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$work/installed" \
    > "$work/log" 2>&1 && cmake --build "$project/build" --parallel "$("$here/../../cmake/build_jobs.sh")" >> "$work/log" 2>&1 ||
    { cat "$work/log" >&2; fail "the programs of $(basename "$page") do not build"; }
  for source in "$project"/*.cpp; do
    check "$project/build/$(basename "$source" .cpp)"
  done
done
