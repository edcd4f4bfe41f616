#!/usr/bin/env bash
# Installs a package of `cpack -G DEB` in a clean Debian, uses it, and removes it again; as root.
#
#   package.sh PACKAGE.deb [RELEASE [ROOTS]]   RELEASE: what it was built on (default: bookworm)
#
# The root is made by debootstrap, in ROOTS (default: /var/tmp/pixelexact-roots) and anew each time.
# Exit status 77: no clean system could be made here (no mirror within reach, no right to enter it).
set -euo pipefail
package=$(realpath "${1:?"package.sh PACKAGE.deb [RELEASE [ROOTS]]"}")
release=${2:-bookworm}
roots=${3:-/var/tmp/pixelexact-roots}
root=$roots/$release-package
data=$(cd "$(dirname "$0")/../../Data" && pwd)
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
told "a clean $release"

mkdir "$root/work"
cp "$package" "$root/work/package.deb"
cp "$data/toroid_hex_g3_p6.vtu" "$root/work/mesh.vtu"
inside apt-get update -q >/dev/null || none "apt-get update failed in it"
# What depends on a package that Debian does not have fails here; what cannot be downloaded, below.
inside apt-get install -q -s --no-install-recommends /work/package.deb >/dev/null
inside apt-get install -q -y -d --no-install-recommends /work/package.deb >/dev/null ||
  none "what it depends on could not be downloaded"
inside apt-get install -q -y --no-install-recommends /work/package.deb >"$roots/$release-package.log" 2>&1
told "installed, with what it depends on"

inside pixelexact --version
inside sh -c 'cd /work && pixelexact render mesh.vtu --size 200x200 --quiet --output cut.png'
inside python3 -c '
import pixelexact
picture = pixelexact.render("/work/mesh.vtu", "u", size=(200, 200), output="/work/python.png")
print("Python", pixelexact.__version__, (picture.verdicts == 1).sum(), "exact pixels")'
inside sh -c 'ldd /usr/bin/pixelexact-view | grep "not found" && exit 1 || exit 0'
told "used"

inside apt-get purge -q -y pixelexact >>"$roots/$release-package.log" 2>&1
left=$(find "$root/usr" -ipath '*pixelexact*')
if [[ -n "$left" ]]; then
  printf 'left behind:\n%s\n' "$left" >&2
  exit 1
fi
told "removed, and nothing is left"
