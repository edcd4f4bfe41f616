#!/usr/bin/env bash
# Gets Debian's ParaView without installing it, and builds the plugin against it.
#
#   build.sh [FOLDER] [CMake's options...]
#
# FOLDER (default build-paraview) is the build folder, ParaView lies in FOLDER/paraview. After that,
# FOLDER/with-paraview.sh PROGRAM... runs pvbatch, pvpython or paraview with the plugin.
set -euo pipefail
cd "$(dirname "$0")/.."
build=${1:-build-paraview}
shift || true

./Testing/Scripts/install-dependencies.sh --paraview "$build/paraview"
cmake -S . -B "$build" -G Ninja -D PIXELEXACT_BUILD_PARAVIEW=ON \
  -D CMAKE_PREFIX_PATH="$(realpath "$build")/paraview/usr" "$@"
cmake --build "$build" --parallel "$(nproc)"
