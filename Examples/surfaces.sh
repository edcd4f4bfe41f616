#!/usr/bin/env bash
# One picture for each kind of cut-surface, by the command-line tool. Usage: surfaces.sh [FOLDER [SIZE]]
# surfaces.py makes the like with VTK and Python.
set -euo pipefail
cd "$(dirname "$0")/.."
folder=${1:-pictures/surfaces}
size=${2:-400x330}
tool=${PIXELEXACT_TOOL:-build/bin/pixelexact}
mkdir -p "$folder"

mesh=Data/toroid_hex_g3_p6.vtu
look=(--colormap coolwarm --samples 9 --size "$size"
  --camera-position 2.5,-3,3.5 --focal-point 0,0,0 --view-up 0,0,1 --view-angle 33)

# draw NAME OPTION...: the field over the same colours in each picture.
draw() {
  "$tool" render "$mesh" --field u --range -0.85,0.85 "${look[@]}" "${@:2}" --output "$folder/$1.png"
}

# Surfaces in closed form.
draw plane --plane 0,0,0.05,0.06,-0.1,1
draw disc --disc 0.9,0,0,0.3,0.2,1,0.6
draw sphere --sphere 0.9,0.1,0.05,0.55
draw cylinder --cylinder 0,0,0,0,0,1,1
draw cone --cone 0,0,1,0,0,-1,45
draw torus --torus 0,0,0,0,0,1,1,0.25
draw box --box -0.7,-2,-0.2,2,0.7,0.2

# Surfaces of files: triangles, and bicubic Bezier patches.
draw triangles --surface Data/surfaces/octahedron.stl
draw patches --patch Data/surfaces/saddle.txt

# Surfaces of the mesh: its boundary, faces of some of its elements, and where a field has a value.
draw boundary --boundary --edges 2
draw elements --boundary=element:0,7,21,40
draw isosurface --isosurface u=0.3

# Contours with their values.
draw contours --torus 0,0,0,0,0,1,1,0.25 --contours=-0.4,-0.2,0,0.2,0.4 --contour-width 2 --contour-labels

# Several of them: the nearest within the mesh shows, and translucent ones let others through.
grey=opacity=0.25,color=0.75:0.75:0.8
draw transparent --plane 0,0,0.05,0.06,-0.1,1 --boundary --layer "2:$grey"
draw together --isosurface u=0.3 --isosurface u=-0.3 --boundary --layer "3:$grey"
