#!/usr/bin/env bash
# Installs the packages of `cpack -G DEB` in a clean Debian, uses them, and removes them again; as root.
#
#   package.sh FOLDER [RELEASE [ROOTS]]   FOLDER: where they are; RELEASE: what they were built on
#                                         (default: bookworm)
#
# First the program, then what Python needs, then what programs in C++ are built with. debootstrap
# makes a new root each time, in ROOTS (default: /var/tmp/pixelexact-roots); the
# environment's MATRIX_MIRROR and MATRIX_STALE are those of Testing/Matrix/run.sh.
# Exit status 77: no clean system could be made here (no mirror within reach, no right to enter it).
set -euo pipefail
folder=$(realpath "${1:?"package.sh FOLDER [RELEASE [ROOTS]]"}")
release=${2:-bookworm}
roots=${3:-/var/tmp/pixelexact-roots}
root=$roots/$release-package
source=$(cd "$(dirname "$0")/../.." && pwd)
log=$roots/$release-package.log
packages=(pixelexact python3-pixelexact libpixelexact-dev)
if [[ $EUID -ne 0 ]]; then
  echo "package.sh: a root of its own is made and entered by root alone" >&2
  exit 2
fi
command -v debootstrap >/dev/null || apt-get install -q -y --no-install-recommends debootstrap

leave() {
  umount "$root/proc" 2>/dev/null || true
}
trap leave EXIT
inside() {
  chroot "$root" env -i HOME=/root LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
    PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin "$@"
}
told() {
  printf '%4d s  %s\n' "$SECONDS" "$1"
}

leave
rm -rf --one-file-system "$root"
mkdir -p "$roots"
none() {
  echo "package.sh: no clean $release could be made here: $1" >&2
  exit 77
}
debootstrap --variant=minbase "$release" "$root" "${MATRIX_MIRROR:-http://deb.debian.org/debian}" >/dev/null ||
  none "debootstrap failed"
mount -t proc proc "$root/proc" 2>/dev/null || echo "without /proc, which may not be mounted here"
cp /etc/resolv.conf "$root/etc/resolv.conf"
if [[ ${MATRIX_STALE:-no} == yes ]]; then
  echo 'Acquire::Check-Valid-Until "false";' >"$root/etc/apt/apt.conf.d/90stale"
fi
told "a clean $release"

mkdir "$root/work"
for package in "${packages[@]}"; do
  found=("$folder/${package}"_*.deb)
  if [[ ${#found[@]} -ne 1 || ! -e "${found[0]}" ]]; then
    echo "package.sh: $folder has not one $package, but: ${found[*]}" >&2
    exit 2
  fi
  cp "${found[0]}" "$root/work/$package.deb"
done
cp "$source/Data/toroid_hex_g3_p6.vtu" "$root/work/mesh.vtu"
cp -r "$source/Testing/Consumer" "$root/work/consumer"
inside apt-get update -q >/dev/null || none "apt-get update failed in it"

# What depends on a package that Debian does not have fails at once; what cannot be downloaded, then.
installed() {
  inside apt-get install -q -s --no-install-recommends "$@" >/dev/null
  inside apt-get install -q -y -d --no-install-recommends "$@" >/dev/null ||
    none "what it depends on could not be downloaded"
  inside apt-get install -q -y --no-install-recommends "$@" >>"$log" 2>&1
  told "installed $*, with what it depends on"
}
: >"$log"

installed /work/pixelexact.deb
inside pixelexact --version
inside sh -c 'cd /work && pixelexact render mesh.vtu --size 200x200 --quiet --output cut.png'
inside sh -c 'ldd /usr/bin/pixelexact-view /usr/bin/pixelexact-mpi | grep "not found" && exit 1 || exit 0'
told "the program used"

installed /work/python3-pixelexact.deb
inside python3 -c '
import pixelexact
picture = pixelexact.render("/work/mesh.vtu", "u", size=(200, 200), output="/work/python.png")
print("Python", pixelexact.__version__, (picture.verdicts == 1).sum(), "exact pixels")'
told "Python used"

installed /work/libpixelexact-dev.deb cmake g++ ninja-build
inside sh -c 'cmake -G Ninja -S /work/consumer -B /work/build && cmake --build /work/build' >>"$log" 2>&1
inside /work/build/CoreConsumer
inside /work/build/VTKConsumer
told "programs in C++ built and run"

inside apt-get purge -q -y "${packages[@]}" >>"$log" 2>&1
left=$(find "$root/usr" -ipath '*pixelexact*')
if [[ -n "$left" ]]; then
  printf 'left behind:\n%s\n' "$left" >&2
  exit 1
fi
told "removed, and nothing is left"
