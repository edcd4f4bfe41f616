#!/usr/bin/env bash
# Runs the measurements and the studies in their full form, and writes a page NAME.md for each: its
# command, date, machine, commit and output.
#
#   results.sh [--output FOLDER] [NAME...]     default: into build/results, all
#
#   frames        made meshes by shape, order, elements and pixels; against the bare kernel
#   suite         real data: three planes of each larger case; against the bare kernel
#   surfaces      curved surfaces beside planes, on real data; what a pipeline adds to a frame
#   pieces        faces, patches, triangles and iso-surfaces beside planes, on real data
#   contours      what they add to frames of real data, and the paper's algorithm beside ours
#   instructions  counted under callgrind
#   loading       time and memory from large files to first pictures (Python: numpy)
#   baselines     vtkProbeFilter, VTK's window, loading
#   careful-path  its share in the files of Data/ and the larger cases
#   slowest-point the most that one point costs, cold, in the same files
#   face-points   a million points on, beside and around faces, of each mesh
#   stability     all sweeps against 113 bits
#   enclosures    width and cost of value enclosures
#   ranges        rounding of Bernstein coefficients, cost of ranges
#   adversary     elements made to break the proofs, against 60 digits (Debian: python3-mpmath)
#   collapsed     elements with collapsed faces and edges, against 60 digits
#   history       answers of all cases, asked in every way that could leave a trace
#   curved        faces, patches and iso-surfaces against subdivision and marching
#   oracles       values, gradients and points against the solvers' own
set -euo pipefail
here=$PWD
cd "$(dirname "$0")/../.."
build=${PIXELEXACT_BUILD:-build}
output=$build/results
if [[ ${1:-} == --output ]]; then
  output=$(cd "$here" && realpath -m "${2:?--output needs a folder}")
  shift 2
fi
all=(frames suite surfaces pieces contours instructions loading baselines careful-path slowest-point face-points stability adversary
  collapsed history enclosures ranges curved oracles)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

data=(Data)
if [[ -d ../shared/data ]]; then
  data+=(../shared/data)
fi

# Runs a command and keeps what it prints.
measure() {
  commands+=("$*")
  "$@" >>"$scratch/output"
}

table() { body=$(cat "$scratch/output"); }
text() { body=$'```\n'"$(cat "$scratch/output")"$'\n```'; }
# Of a test's output only what it measured.
measured() {
  body=$'```\n'"$(sed -n 's/^\[ measured \] //p' "$scratch/output")"$'\n```'
}

run_frames() {
  title="Frames against the bare kernel"
  measure "$build/bin/pixelexact" bench --elements 1000000 --size 1000x1000 --repeat 5
  text
}
run_suite() {
  title="Frames of real data against the bare kernel"
  measure Testing/Benchmarks/suite.py "$build/bin/pixelexact" ../shared/data --threads 1
  table
}
run_surfaces() {
  title="Curved surfaces beside planes"
  measure Testing/Benchmarks/surfaces.py "$build/bin/pixelexact" ../shared/data
  echo >>"$scratch/output"
  echo '```' >>"$scratch/output"
  measure "$build/bin/PixelExactBenchmarks" --benchmark_filter=Pipelines
  echo '```' >>"$scratch/output"
  table
}
run_pieces() {
  title="Faces, patches, triangles and iso-surfaces beside planes"
  measure Testing/Benchmarks/pieces.py "$build/bin/pixelexact" ../shared/data
  table
}
run_contours() {
  title="Contours on real data"
  local script=Testing/Benchmarks/contours.py
  measure "$script" "$build/bin/pixelexact" ../shared/data --scratch "$scratch"
  printf '\n500 x 500 pixels, 10 values: pixels undecided, and seconds of a frame; the project'"'"'s own, then the\npaper'"'"'s algorithm at 0 to 8 subdivisions.\n\n' >>"$scratch/output"
  measure "$script" "$build/bin/pixelexact" ../shared/data --levels --size 500 --repeat 1 \
    --scratch "$scratch" --only fichera_hex_g3 toroid_hex_g3_p6 toroid_prism escher_tet_p3 escher_tet_p8 \
    cylinder_hexprism
  table
}
run_instructions() {
  title="Instructions a point"
  measure Testing/Benchmarks/instructions.py "$build/bin/InstructionCounts"
  text
}
run_loading() {
  title="From large files to first pictures"
  Testing/Benchmarks/large_files.py "$scratch/made" >/dev/null
  measure Testing/Benchmarks/loading.py "$build/bin/pixelexact" "$scratch/made" ../shared/data
  table
}
run_baselines() {
  title="What users have: vtkProbeFilter, the window, loading"
  local run=("$build/bin/PixelExactBenchmarks" --benchmark_out="$scratch/run.json")
  commands+=("Testing/Scripts/with-display.sh $build/bin/PixelExactBenchmarks")
  Testing/Scripts/with-display.sh "${run[@]}" >"$scratch/log" 2>/dev/null
  Testing/Benchmarks/table.py "$scratch/run.json" >"$scratch/output"
  body="$(cat "$scratch/output")"$'\n\nAll benchmarks:\n\n```\n'"$(cat "$scratch/log")"$'\n```'
}
run_careful-path() {
  title="The share of the careful path"
  measure "$build/bin/CarefulShare" "${data[@]}"
  table
}
run_slowest-point() {
  title="The most that a single point costs"
  measure "$build/bin/SlowestPoint" "${data[@]}"
  table
}
run_face-points() {
  title="Points on and beside faces"
  measure env PIXELEXACT_FACE_POINTS="${PIXELEXACT_FACE_POINTS:-1000000}" \
    "$build/bin/TestCore" --gtest_filter='*FacePoints*'
  measured
}
run_stability() {
  title="Stability: all sweeps against 113 bits"
  cmake --build "$build" --target StabilityStudy >/dev/null
  commands+=("$build/bin/StabilityStudy DIRECTORY")
  "$build/bin/StabilityStudy" "$scratch/stability" | tee "$scratch/log" >&2
  body="$(cat "$scratch/stability/table.md")"$'\n\n'"$(tail -n 1 "$scratch/log")."
}
run_adversary() {
  title="Elements made to break the proofs"
  measure Testing/Stability/adversary.py "$build/bin/pixelexact"
  table
}
run_collapsed() {
  title="Elements with collapsed faces and edges"
  cmake --build "$build" --target AskPoints >/dev/null
  # What is wrong is in the table.
  measure Testing/Stability/collapsed.py "$build/bin/AskPoints" || true
  table
}
run_history() {
  title="Answers do not depend on what was asked before"
  measure Testing/Stability/history.py "$build/bin/pixelexact" "${data[@]}" || true
  table
}
run_enclosures() {
  title="Value enclosures: width and cost"
  measure "$build/bin/PixelExactEnclosureTable"
  table
}
run_ranges() {
  title="Certified ranges: rounding and cost"
  measure "$build/bin/PixelExactRangeTable"
  table
}
run_curved() {
  title="Faces, patches and iso-surfaces against subdivision and marching"
  measure env PIXELEXACT_CURVED_RAYS="${PIXELEXACT_CURVED_RAYS:-1000}" "$build/bin/TestTrace" \
    --gtest_filter='*FacesOracle*:*PatchesOracle*:*IsoOracle*'
  measured
}
run_oracles() {
  title="Against the solvers' own values"
  measure "$build/bin/TestFilters" --gtest_filter='*Oracles.*'
  measured
}

mkdir -p "$output"
for name in "${@:-${all[@]}}"; do
  if ! declare -F "run_$name" >/dev/null; then
    echo "no such result: $name; there are ${all[*]}" >&2
    exit 2
  fi
  printf '== %s\n' "$name" >&2
  commands=()
  : >"$scratch/output"
  "run_$name"
  {
    printf '# %s\n\n' "$title"
    printf 'Made by `Testing/Scripts/results.sh %s`:\n\n' "$name"
    printf '    %s\n' "${commands[@]}"
    printf '\n%s; commit %s; %s, %d processors, %s; %s.\n\n' \
      "$(date -u +%Y-%m-%d)" "$(git describe --always --dirty --exclude='*')" \
      "$(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1)" "$(nproc)" \
      "$(. /etc/os-release && echo "$PRETTY_NAME")" "$(c++ --version | head -n 1)"
    printf '%s\n' "$body"
  } >"$scratch/page"
  mv "$scratch/page" "$output/$name.md"
done
