#!/usr/bin/env bash
# Builds and tests what is committed in a clean Debian of its own, as root.
#
#   run.sh RELEASE [ROOTS]   RELEASE: bookworm, trixie or testing; ROOTS: where the systems are kept
#
# The root is made once (debootstrap) and taken again. In the environment:
#   MATRIX_STAGES    of dependencies, build, test, paraview, package, syntax (default: the first three);
#                    package: of what was built, installed, used and removed in another clean root; syntax:
#                    the compiler reads what both builds compile, if they are there, and makes nothing
#   MATRIX_TESTS     which tests, as ctest -R takes it (default: all)
#   MATRIX_TARGETS   what is built (default: all)
#   MATRIX_COMPILER  such as g++-15, installed there (default: what the release has)
#   MATRIX_CXXFLAGS  for builds that are new, such as
#                    "-DHWY_COMPILE_ONLY_STATIC -DPIXELEXACT_FEW_ORDERS": fewer kernels
#   MATRIX_JOBS      compilers at once (default 1); all run at the lowest priority
#   MATRIX_MIRROR    (default http://deb.debian.org/debian)
#   MATRIX_STALE     yes: of a mirror that is behind, lists that have expired are taken, too
# The last line is a row of the table in Testing/README.md.
set -euo pipefail
release=${1:?"run.sh RELEASE [ROOTS]: bookworm, trixie or testing"}
roots=${2:-/var/tmp/pixelexact-roots}
stages=${MATRIX_STAGES:-dependencies build test}
jobs=${MATRIX_JOBS:-1}
compiler=${MATRIX_COMPILER:-g++}
root=$roots/$release
source=$(cd "$(dirname "$0")/../.." && pwd)
if [[ $EUID -ne 0 ]]; then
  echo "run.sh: a root of its own is made and entered by root alone" >&2
  exit 2
fi

for program in debootstrap git; do
  command -v "$program" >/dev/null || apt-get install -q -y --no-install-recommends "$program"
done
mkdir -p "$roots"
if [[ ! -e $root/complete ]]; then
  rm -rf "$root"
  nice -n 19 debootstrap --variant=minbase "$release" "$root" \
    "${MATRIX_MIRROR:-http://deb.debian.org/debian}"
  touch "$root/complete"
fi
cp /etc/resolv.conf "$root/etc/resolv.conf"
rm -f "$root/etc/apt/apt.conf.d/90stale"
if [[ ${MATRIX_STALE:-no} == yes ]]; then
  echo 'Acquire::Check-Valid-Until "false";' >"$root/etc/apt/apt.conf.d/90stale"
fi

# What is mounted is taken away again, whatever happens.
leave() {
  umount "$root/dev" "$root/sys" "$root/proc" 2>/dev/null || true
}
trap leave EXIT
mountpoint -q "$root/proc" || mount -t proc proc "$root/proc"
mountpoint -q "$root/sys" || mount -t sysfs -o ro sysfs "$root/sys" # MPI asks it for the machine
mountpoint -q "$root/dev" || mount --bind /dev "$root/dev"

rm -rf "$root/src/new" && mkdir -p "$root/src/new"
git -C "$source" archive HEAD | tar -x -C "$root/src/new"
# Unchanged files keep their times, so that not everything is built again.
mkdir -p "$root/src/pixelexact"
chroot "$root" sh -c 'command -v rsync >/dev/null || { apt-get update -q && apt-get install -q -y --no-install-recommends rsync; }' >/dev/null
chroot "$root" rsync -rlpc --delete --exclude /build --exclude /build-paraview /src/new/ /src/pixelexact/

inside() {
  nice -n 19 chroot "$root" env -i HOME=/root LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
    PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
    CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache CCACHE_DEPEND=1 \
    CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime \
    CXXFLAGS="${MATRIX_CXXFLAGS:-}" PIXELEXACT_TEST_STAGES="$1" bash -c "cd /src/pixelexact && $2"
}
# Of a package, installed or not.
version() {
  chroot "$root" apt-cache policy "$1" 2>/dev/null | sed -n 's/^ *Candidate: \([0-9]*:\)\?\([^+~-]*\).*/\2/p'
}

compiled=-
tested=-
for stage in $stages; do
  printf '\n== %s: %s\n' "$release" "$stage"
  case $stage in
    dependencies)
      inside "$stage" "./Testing/Scripts/install-dependencies.sh --testing"
      if [[ $compiler != g++ ]]; then
        inside "$stage" "apt-get install -q -y --no-install-recommends $compiler"
      fi
      ;;
    build)
      if inside "$stage" "cmake -S . -B build -G Ninja -D CMAKE_CXX_COMPILER=$compiler \
        -D PIXELEXACT_WARNINGS_AS_ERRORS=ON -D PIXELEXACT_BUILD_BENCHMARKS=ON && ninja -C build -k 0 -j $jobs ${MATRIX_TARGETS:-}"; then
        compiled=yes
      else
        compiled=no
      fi
      ;;
    test)
      inside "$stage" "xvfb-run -a -s '-screen 0 1280x1024x24 -noreset' bash -c '
        export PIXELEXACT_TEST_DISPLAY=\$DISPLAY; unset DISPLAY
        exec ctest --test-dir build --output-on-failure -j $jobs -R \"${MATRIX_TESTS:-.}\"'" |
        tee "$roots/$release.tests" || true
      tested=$(grep -o '[0-9]*% tests passed.*' "$roots/$release.tests" || echo failed)
      ;;
    paraview)
      if inside "$stage" "./Testing/Scripts/test.sh"; then
        tested+=", the plugin's passed"
      else
        tested+=", the plugin's failed"
      fi
      ;;
    package)
      if inside "$stage" "rm -f build/*.deb && cd build && cpack -G DEB" &&
        nice -n 19 "$source/Testing/Scripts/package.sh" "$root/src/pixelexact/build" "$release" "$roots"; then
        tested+=", packages passed"
      else
        tested+=", packages failed"
      fi
      ;;
    syntax)
      inside "$stage" "apt-get install -q -y --no-install-recommends $compiler"
      for folder in build build-paraview; do
        if [[ -e $root/src/pixelexact/$folder/compile_commands.json ]]; then
          inside "$stage" "Testing/Matrix/syntax.py $folder $compiler --jobs $jobs" || compiled=no
        fi
      done
      ;;
    *)
      echo "run.sh: no such stage: $stage" >&2
      exit 2
      ;;
  esac
done
printf '| %s | %s | %s | %s | %s | %s | %s | %s |\n' "$release" \
  "$(chroot "$root" "$compiler" -dumpfullversion 2>/dev/null)" "$(version libvtk9-dev)" \
  "$(version libembree-dev)" "$(version python3)" "$(version paraview)" "$compiled" "$tested"
