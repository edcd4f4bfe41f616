#!/usr/bin/env bash
# Installs what PixelExact needs on Debian 12 or newer, and only what is missing.
#
#   install-dependencies.sh            to build and run
#   install-dependencies.sh --testing  to test as well
set -euo pipefail

packages=(
  ca-certificates cmake g++ ninja-build
  libcli11-dev libeigen3-dev libembree-dev libfmt-dev libglm-dev libhwy-dev libpugixml-dev
  libtbb-dev libvtk9-dev libxxhash-dev nlohmann-json3-dev tao-pegtl-dev zlib1g-dev
  python3 python3-dev python3-vtk9
)
if [[ "${1:-}" == --testing ]]; then
  packages+=(
    ccache clang clang-format clang-tidy git libbenchmark-dev libclang-rt-dev libgmp-dev libgtest-dev
    libmpfr-dev python3-numpy valgrind xauth xvfb
  )
fi

missing=()
for package in "${packages[@]}"; do
  status=$(dpkg-query -W -f '${Status}' "$package" 2>/dev/null || true)
  if [[ "$status" != "install ok installed" ]]; then
    missing+=("$package")
  fi
done
if [[ ${#missing[@]} -eq 0 ]]; then
  exit 0
fi

as_root=()
if [[ $EUID -ne 0 ]]; then
  as_root=(sudo)
fi
"${as_root[@]}" apt-get -o Acquire::Retries=3 update -q
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
  apt-get -o Acquire::Retries=3 install -q -y --no-install-recommends "${missing[@]}"
