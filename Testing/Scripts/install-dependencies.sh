#!/usr/bin/env bash
# Installs what PixelExact needs on Debian 12 or newer, and only what is missing.
#
#   install-dependencies.sh                    to build and run
#   install-dependencies.sh --testing          to test as well
#   install-dependencies.sh --paraview PREFIX  to build the ParaView plugin: unpacks ParaView below PREFIX
set -euo pipefail

packages=(
  ca-certificates cmake g++ ninja-build
  libcairo2-dev libcli11-dev libeigen3-dev libembree-dev libfmt-dev libfontconfig-dev libfreetype-dev
  libglm-dev libhdf5-dev libhwy-dev libpng-dev libpugixml-dev libtbb-dev libtiff-dev libvtk9-dev
  libwebsockets-dev libxxhash-dev
  mpi-default-dev nlohmann-json3-dev pkg-config tao-pegtl-dev zlib1g-dev
  python3 python3-dev python3-numpy python3-vtk9
)
if [[ "${1:-}" == --testing ]]; then
  packages+=(
    ccache chromium chromium-driver clang clang-format clang-tidy debootstrap dpkg-dev ffmpeg file git libbenchmark-dev libclang-rt-dev
    jupyter-nbconvert jupyter-notebook libgmp-dev libgtest-dev libmpfr-dev mypy openmpi-bin python3-ipykernel python3-pil
    poppler-utils valgrind xauth xdotool xvfb
  )
fi
prefix=""
if [[ "${1:-}" == --paraview ]]; then
  prefix=$(realpath -m "${2:?"--paraview PREFIX: where to unpack ParaView"}")
  packages+=(xauth xvfb)
fi

missing=()
for package in "${packages[@]}"; do
  status=$(dpkg-query -W -f '${Status}' "$package" 2>/dev/null || true)
  if [[ "$status" != "install ok installed" ]]; then
    missing+=("$package")
  fi
done
as_root=()
if [[ $EUID -ne 0 ]]; then
  as_root=(sudo)
fi
if [[ ${#missing[@]} -gt 0 ]]; then
  "${as_root[@]}" apt-get -o Acquire::Retries=3 update -q
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get -o Acquire::Retries=3 install -q -y --no-install-recommends "${missing[@]}"
fi

# Unpacked and not installed: python3-paraview conflicts with python3-vtk9, which libvtk9-dev needs.
if [[ -n "$prefix" && ! -e "$prefix/complete" ]]; then
  mkdir -p "$prefix/packages"
  cd "$prefix/packages"
  apt-get -o Acquire::Retries=3 download paraview paraview-dev python3-paraview || {
    "${as_root[@]}" apt-get -o Acquire::Retries=3 update -q
    apt-get -o Acquire::Retries=3 download paraview paraview-dev python3-paraview
  }
  dpkg-deb -f paraview_*.deb Depends | tr , '\n' | grep '^ *lib' | paste -s -d , >libraries
  for package in *.deb; do
    dpkg -x "$package" ..
    rm "$package"
  done
  # Its CMake files look for Python's modules under the names that they had before Debian added the
  # interpreter's suffix.
  find "$prefix/usr/lib/python3" -name '*.cpython-*.so' | while read -r module; do
    plain=${module%.cpython-*}.so
    [[ -e "$plain" ]] || ln -s "$(basename "$module")" "$plain"
  done
  mv libraries ../complete
fi
# What it is linked with.
if [[ -n "$prefix" ]]; then
  libraries=$(<"$prefix/complete")
  if ! LC_ALL=C apt-get -s satisfy "$libraries" | grep -q '^0 upgraded, 0 newly installed'; then
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
      apt-get -o Acquire::Retries=3 satisfy -q -y --no-install-recommends "$libraries"
  fi
fi
