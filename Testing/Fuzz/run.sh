#!/usr/bin/env bash
# run.sh BUILD SECONDS: runs the fuzzers of the build folder at once, for some seconds, on the corpus
# kept here. What makes one crash, hang (20 s) or take 2 GB is left in BUILD.
set -euo pipefail
build=$(cd "$1" && pwd)
seconds=$2
here=$(cd "$(dirname "$0")" && pwd)

cd "$build"
runs=()
for format in Gmsh Mfem Nek5000 Nektar; do
  # Inputs found on the way stay in the build folder.
  mkdir -p "found/$format"
  "./Fuzz$format" -max_total_time="$seconds" -timeout=20 -rss_limit_mb=2048 -max_len=16384 \
    -seed=1 -print_final_stats=1 -dict="$here/$format.dict" "found/$format" "$here/Corpus/$format" \
    >"Fuzz$format.log" 2>&1 &
  runs+=($!)
done
status=0
for run in "${runs[@]}"; do
  wait "$run" || status=1
done
for format in Gmsh Mfem Nek5000 Nektar; do
  echo "== $format"
  grep -E 'ERROR|SUMMARY|stat::|Test unit' "Fuzz$format.log" || tail -20 "Fuzz$format.log"
done
exit $status
