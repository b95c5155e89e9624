#!/usr/bin/env bash
# run.sh [SECONDS]: builds the fuzz targets and runs each of them from its seeds, a minute long unless said otherwise.
# Needs clang-14 and libclang-rt-14-dev. What breaks a reader is left in build/fuzz/found.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
cmake --preset fuzz --log-level=WARNING
cmake --build --preset fuzz --target fuzz_obj fuzz_off fuzz_pcd fuzz_ply fuzz_text
mkdir -p build/fuzz/found
for seeds in test/fuzz/seeds/*; do
  reader=$(basename "$seeds")
  corpus=build/fuzz/corpus/$reader
  mkdir -p "$corpus"
  echo "$reader"
  build/fuzz/bin/"fuzz_$reader" -max_total_time="${1:-60}" -max_len=4096 -timeout=10 -rss_limit_mb=1024 \
    -artifact_prefix=build/fuzz/found/"$reader"- -print_final_stats=1 "$corpus" "$seeds" 2> build/fuzz/"$reader".log ||
    { tail -40 build/fuzz/"$reader".log; exit 1; }
  grep stat::number_of_executed_units build/fuzz/"$reader".log
done
