#!/usr/bin/env bash
# Gets Debian's ParaView without installing it, and builds the plugin against it.
#
#   build.sh [FOLDER] [CMake's options...]
#
# FOLDER (default build-paraview) is the build folder, ParaView lies in FOLDER/paraview. After that,
# FOLDER/with-paraview.sh PROGRAM... runs pvbatch, pvpython or paraview with the plugin. Where the
# program was built before, in the folder build, the plugin takes the libraries that know no VTK
# from there.
set -euo pipefail
cd "$(dirname "$0")/.."
build=${1:-build-paraview}
shift || true

./Testing/Scripts/install-dependencies.sh --paraview "$build/paraview"
libraries=""
if [[ -e build/build.ninja ]]; then
  cmake --build build --target PixelExactCore PixelExactFormats PixelExactTrace
  libraries=$PWD/build
fi
cmake -S . -B "$build" -G Ninja -D PIXELEXACT_BUILD_PARAVIEW=ON \
  -D PIXELEXACT_LIBRARIES_FROM="$libraries" \
  -D CMAKE_PREFIX_PATH="$(realpath "$build")/paraview/usr" "$@"
cmake --build "$build" --parallel "$(nproc)"
