#!/usr/bin/env bash
# Prints how many compilers may run at once: one a core, as long as each has 2.5 GiB of memory (CGAL and PCL
# headers need that much).
set -euo pipefail

kib=$(awk '/^MemAvailable:/ {print $2}' /proc/meminfo 2> /dev/null || true)
kib=${kib:-4194304}
limit=$(cat /sys/fs/cgroup/memory.max 2> /dev/null || true)
if [[ $limit =~ ^[0-9]+$ ]] && [ $((limit / 1024)) -lt "$kib" ]; then
  kib=$((limit / 1024))
fi
jobs=$((kib / 2621440))
cores=$(nproc)
[ "$jobs" -le "$cores" ] || jobs=$cores
[ "$jobs" -ge 1 ] || jobs=1
echo "$jobs"
