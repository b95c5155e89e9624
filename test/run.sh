#!/usr/bin/env bash
# Installs what the tests need, builds them and runs them. Works without a display; may be run again.
#
#   test/run.sh [PRESET]     a configure preset with tests: ci (default), debug, core-only, asan-ubsan, tsan
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

preset=${1:-ci}
case $preset in
  ci | debug | core-only | asan-ubsan | tsan) ;;
  *)
    echo "error: no preset with tests is named '$preset': ci, debug, core-only, asan-ubsan, tsan" >&2
    exit 2
    ;;
esac

cmake/install_dependencies.sh build samples test
cmake --preset "$preset" --log-level=WARNING > /dev/null
cmake --build --preset "$preset" --parallel "$(cmake/build_jobs.sh)"

log=build/$preset/ctest.log
status=0
ctest --preset "$preset" --parallel "$(nproc)" < /dev/null 2>&1 | tee "$log" || status=$?
echo "--- $preset: how the tests ended"
grep -E '^[0-9]+% tests passed|^Total Test time' "$log" || echo "ctest ran no test"
exit "$status"
