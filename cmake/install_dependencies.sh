#!/usr/bin/env bash
# Installs what the project needs from Debian's packages: only what is missing, so a second run does nothing.
#
#   cmake/install_dependencies.sh LEVEL...
#
#   build     what the libraries and the apps are compiled with
#   samples   what the apps' pictures need without a display, and real clouds to try them on
#   test      what the tests, the format check and the packages need
#   check     what .ci/run needs beside that: fuzzers and clang-tidy
set -euo pipefail

build=(g++ cmake ninja-build libpcl-dev libcgal-dev libtbb-dev libeigen3-dev libboost-dev
  libboost-program-options-dev libjsoncpp-dev libvtk9-dev libegl-dev libx11-dev)
samples=(libegl1 libgl1-mesa-dri libcgal-demo)
test=(libgtest-dev clang-format-14 ccache doxygen pkg-config dpkg-dev file git libegl1 libgl1-mesa-dri libcgal-demo)
check=(clang-14 clang-tidy-14 libclang-rt-14-dev)

fail () { echo "error: $*" >&2; exit 1; }

wanted=()
for level in "$@"; do
  case $level in
    build) wanted+=("${build[@]}") ;;
    samples) wanted+=("${samples[@]}") ;;
    test) wanted+=("${test[@]}") ;;
    check) wanted+=("${check[@]}") ;;
    *) fail "unknown level '$level', there are: build samples test check" ;;
  esac
done
[ $# -gt 0 ] || fail "which level? build, samples, test or check"
command -v apt-get > /dev/null ||
  fail "this is no Debian (no apt-get); install by hand what corresponds to: ${wanted[*]}"

missing=()
for package in "${wanted[@]}"; do
  status=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2> /dev/null || true)
  [ "$status" = installed ] || missing+=("$package")
done
if [ ${#missing[@]} -eq 0 ]; then
  echo "dependencies ($*): all there"
  exit 0
fi

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo > /dev/null || fail "missing packages: ${missing[*]}; run this as root, or install sudo"
  as_root=(sudo)
fi
apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get
  -q -y -o Acquire::Retries=3 -o DPkg::Lock::Timeout=300 -o Dpkg::Use-Pty=0)

log=$(mktemp)
trap 'rm -f "$log"' EXIT
echo "dependencies ($*): installing ${missing[*]}"
for attempt in 1 2 3; do
  # A mirror that is briefly out of reach, or whose lists have just changed, deserves another try.
  if "${apt[@]}" update < /dev/null > "$log" 2>&1 &&
    "${apt[@]}" install --no-install-recommends "${missing[@]}" < /dev/null >> "$log" 2>&1; then
    echo "dependencies ($*): installed"
    exit 0
  fi
  echo "dependencies ($*): apt-get failed, attempt $attempt of 3"
  sleep $((attempt * 5))
done
tail -n 20 "$log" >&2
fail "apt-get could not install: ${missing[*]}"
