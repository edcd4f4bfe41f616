#!/usr/bin/env bash
# From nothing to pictures: installs what is missing, builds the program alone and cuts a real
# solution. The pictures are in ./pictures afterwards.
set -euo pipefail
cd "$(dirname "$0")/.."

./Testing/Scripts/install-dependencies.sh
if [[ ! -e build/CMakeCache.txt ]]; then
  cmake --preset program
fi
cmake --build build --target pixelexact

mkdir -p pictures
build/bin/pixelexact render Data/toroid_hex_g3_p6.vtu --field u \
  --plane 0,0,0,0,0,1 \
  --size 1000x1000 \
  --output pictures/toroid.png --buffers pictures/toroid.vti
