#!/usr/bin/env bash
# Everything that must hold before a change goes in. Runs on a clean Debian 12 or newer.
#
#   test.sh           as CI runs it
#   test.sh --quick   dependencies, build and tests: for a first look
#   test.sh --full    also all tests under sanitizers, each source compiled alone, and ten minutes of
#                     clang-tidy: before a release, and after work on what reads files or counts
#                     indices
#
# PIXELEXACT_TEST_STAGES selects from (default: all but sanitize and plain, in this order)
#   dependencies build test paraview instructions sanitize plain fuzz format tidy package
# A stage that uses more seconds of the processor than its budget fails. After PIXELEXACT_DEADLINE
# seconds in all (4800) what runs is ended and what is left fails: whoever stops a run after 90
# minutes still gets its report.
# The last line reads "N passed, N failed, N skipped": tests of both builds, and one for each other
# stage. What failed is said once more before it, so that the end of a log is enough to go on.
set -uo pipefail
cd "$(dirname "$0")/../.."

stages=${PIXELEXACT_TEST_STAGES:-dependencies build test paraview instructions fuzz format tidy package}
tidy_seconds=120
case "${1:-}" in
  --quick) stages="dependencies build test" ;;
  --full)
    stages="dependencies build test paraview instructions sanitize plain fuzz format tidy package"
    tidy_seconds=600
    ;;
  "") ;;
  *)
    echo "test.sh: --quick, --full, or nothing, not '$1'" >&2
    exit 2
    ;;
esac
# Seconds of the processor, which depend less on a machine's other work than the clock does. The
# network has none.
declare -A budgets=([build]=2400 [test]=3000 [paraview]=2400 [instructions]=900 [sanitize]=9000 [plain]=9000
  [fuzz]=1200 [format]=120 [tidy]=2400 [package]=1500)
deadline=${PIXELEXACT_DEADLINE:-4800}
build=build
plain_build=build-plain
paraview_build=build-paraview
sanitize_build=build-sanitize
fuzz_build=build-fuzz
jobs=$(nproc)
passed=0
failed=0
skipped=0
timings=""
times_file=$(mktemp)
trap 'rm -f "$times_file"' EXIT
failures=""
stage=""

# What was compiled before need not be compiled again, wherever the clone lies.
use_ccache() {
  if command -v ccache >/dev/null; then
    export CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache
    export CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1 CCACHE_DEPEND=1
    export CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
  fi
}

# Runs a command until the deadline; exit code 124 beyond it.
limited() {
  local left=$((deadline - SECONDS))
  if [[ $left -le 0 ]]; then
    echo "no time is left: $*"
    return 124
  fi
  timeout --kill-after=10 "$left" "$@"
}

# Runs ctest in a build folder and adds its tests to the totals. All tests that draw share a display;
# the others have none.
run_ctest() {
  local folder=$1
  shift
  rm -rf "$folder/Testing/Results" "$folder/Testing/junit.xml"
  local run=(ctest --test-dir "$folder" --parallel "$jobs" --no-tests=error
    --output-junit Testing/junit.xml --test-output-size-failed 1000000 "$@")
  if command -v xvfb-run >/dev/null; then
    limited xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" \
      bash -c \
      'export PIXELEXACT_TEST_DISPLAY=$DISPLAY; unset DISPLAY; exec "$@"' run "${run[@]}"
  else
    limited "${run[@]}"
  fi
  local report
  if ! report=$(./Testing/Scripts/report.py tests "$folder"); then
    count 1
    return
  fi
  printf '%s\n' "$report"
  local summary suite_passed suite_failed suite_skipped
  summary=$(tail -n 1 <<<"$report")
  read -r suite_passed _ suite_failed _ suite_skipped _ <<<"$summary"
  passed=$((passed + suite_passed))
  failed=$((failed + suite_failed))
  skipped=$((skipped + suite_skipped))
  if [[ $suite_failed -gt 0 ]]; then
    failures+="$(sed '/^slowest tests:$/,$d' <<<"$report")"$'\n'
  fi
}

# Counts a stage that is not a suite of tests as one; $2 is the log that ends with its reason.
count() {
  if [[ $1 -eq 0 ]]; then
    passed=$((passed + 1))
  else
    failed=$((failed + 1))
    failures+="stage $stage failed with exit code $1"$'\n'
    if [[ -n "${2:-}" ]]; then
      failures+="$(tail -n 60 "$2")"$'\n'
    fi
  fi
}

# Of Debian's packages.
has_paraview() {
  [[ $(. /etc/os-release && echo "$ID") == debian ]]
}

stage_dependencies() {
  ./Testing/Scripts/install-dependencies.sh --testing
  count $?
  use_ccache
}

# Names what the main job's preset leaves out, which may have made the folder.
stage_build() {
  cmake -S . -B "$build" -G Ninja \
    -D PIXELEXACT_JOINED_BUILD=ON \
    -D PIXELEXACT_AVX512=ON \
    -D PIXELEXACT_BUILD_VIEW=ON \
    -D PIXELEXACT_WARNINGS_AS_ERRORS=ON \
    -D PIXELEXACT_BUILD_TESTING=ON \
    -D PIXELEXACT_BUILD_PYTHON=ON \
    -D PIXELEXACT_BUILD_BENCHMARKS=ON &&
    limited cmake --build "$build" --parallel "$jobs" | tee "$build/build.log"
  count $? "$build/build.log"
  ./Testing/Scripts/report.py files "$build"
}

configure_plain() {
  cmake -S . -B "$plain_build" -G Ninja \
    -D PIXELEXACT_JOINED_BUILD=OFF \
    -D PIXELEXACT_WARNINGS_AS_ERRORS=ON \
    -D PIXELEXACT_BUILD_BENCHMARKS=ON
}

stage_test() {
  run_ctest "$build"
}

# Debian's packages, in a clean system of the same release.
stage_package() {
  local release package
  release=$(. /etc/os-release && echo "$ID ${VERSION_CODENAME:-}")
  if [[ $EUID -ne 0 || "$release" != "debian "* ]]; then
    echo "skipped: a clean Debian is made and entered by root, on Debian"
    skipped=$((skipped + 1))
    return
  fi
  if [[ $((deadline - SECONDS)) -lt 600 ]]; then
    echo "skipped: too little time is left for a clean system"
    skipped=$((skipped + 1))
    return
  fi
  rm -f "$build"/*.deb
  { (cd "$build" && limited cpack -G DEB) &&
    limited ./Testing/Scripts/package.sh "$build" "${release#debian }" "$PWD/$build/package"; } 2>&1 |
    tee "$build/package.log"
  local status=$?
  if [[ $status -eq 77 ]]; then
    echo "skipped: no clean system could be made here"
    skipped=$((skipped + 1))
  else
    count $status "$build/package.log"
  fi
  rm -rf --one-file-system "$build/package"
}

# The plugin alone, in scripts that pvbatch runs. What is free of VTK comes from ccache.
stage_paraview() {
  if ! has_paraview; then
    echo "skipped: ParaView is taken from Debian's packages"
    skipped=$((skipped + 1))
    return
  fi
  mkdir -p "$paraview_build"
  limited ./ParaView/build.sh "$paraview_build" -D PIXELEXACT_WARNINGS_AS_ERRORS=ON |
    tee "$paraview_build/build.log"
  count $? "$paraview_build/build.log"
  run_ctest "$paraview_build"
}

# Frames must not cost more instructions than on record.
stage_instructions() {
  limited ./Testing/Benchmarks/instructions.py "$build/bin/InstructionCounts" |
    tee "$build/instructions.log"
  local status=$?
  if [[ $status -eq 77 ]]; then
    echo "skipped: valgrind cannot run the program on this processor"
    skipped=$((skipped + 1))
  else
    count $status "$build/instructions.log"
  fi
}

# Assertions are on and -O1 keeps the stack traces. No Python, no OpenGL: an interpreter or a driver
# without sanitizers cannot load our libraries.
stage_sanitize() {
  cmake -S . -B "$sanitize_build" -G Ninja \
    -D CMAKE_BUILD_TYPE=Debug \
    -D CMAKE_CXX_FLAGS_DEBUG="-O1 -g1" \
    -D PIXELEXACT_SANITIZE=ON \
    -D PIXELEXACT_BUILD_TESTING=ON \
    -D PIXELEXACT_BUILD_PYTHON=OFF &&
    limited cmake --build "$sanitize_build" --parallel "$jobs" --target PixelExactTests |
    tee "$sanitize_build/build.log"
  count $? "$sanitize_build/build.log"
  ./Testing/Scripts/report.py files "$sanitize_build"
  run_ctest "$sanitize_build"
}

# Everything, each source compiled alone, as for development.
stage_plain() {
  configure_plain && limited cmake --build "$plain_build" --parallel "$jobs" | tee "$plain_build/build.log"
  count $? "$plain_build/build.log"
}

# The parsers of the solvers' files, on any bytes. Both fuzzers run at once.
stage_fuzz() {
  cmake -S Testing/Fuzz -B "$fuzz_build" -G Ninja -D CMAKE_CXX_COMPILER=clang++ &&
    limited cmake --build "$fuzz_build" --parallel "$jobs" &&
    limited ./Testing/Fuzz/run.sh "$fuzz_build" 60 2>&1 | tee "$fuzz_build/fuzz.log"
  count $? "$fuzz_build/fuzz.log"
}

# Only one version's idea of the format can hold: other versions differ in details.
stage_format() {
  local version
  version=$(clang-format --version | sed 's/.*version \([0-9]*\).*/\1/')
  if [[ "$version" != 14 ]]; then
    echo "skipped: the sources are formatted with clang-format 14, this is $version"
    return
  fi
  find Module Filters Rendering ParaView Testing Examples -name '*.h' -o -name '*.cxx' |
    xargs clang-format --dry-run -Werror 2>&1 | tee "$build/format.log"
  count $? "$build/format.log"
}

# Reads sources alone, as the plain build compiles them.
stage_tidy() {
  local builds=("$plain_build")
  if ! { configure_plain && cmake --build "$plain_build" --target PixelExactRows; } >"$build/tidy.log"; then
    count 1 "$build/tidy.log"
    return
  fi
  if [[ -e $paraview_build/paraview/complete ]]; then
    cmake -S . -B "$paraview_build/plain" -G Ninja -D PIXELEXACT_BUILD_PARAVIEW=ON -D PIXELEXACT_JOINED_BUILD=OFF \
      -D CMAKE_PREFIX_PATH="$PWD/$paraview_build/paraview/usr" >>"$build/tidy.log"
    builds+=("$paraview_build/plain")
  fi
  limited ./Testing/Scripts/tidy.py "${builds[@]}" --seconds "$tidy_seconds" 2>&1 | tee "$build/tidy.log"
  count $? "$build/tidy.log"
}

# Sets `used` to the seconds of the processor that the programs that have ended took. Not in a
# subshell, which would count its own.
measure() {
  times >"$times_file"
  used=$(tr 'ms' '  ' <"$times_file" | awk '{ sum += 60 * $1 + $2 + 60 * $3 + $4 } END { print int(sum) }')
}

# What takes longer belongs into Testing/Scripts/results.sh.
check_budget() {
  local seconds=$1 budget=${budgets[$stage]:-0}
  if [[ $budget -gt 0 && $seconds -gt $budget ]]; then
    failed=$((failed + 1))
    failures+="stage $stage used $seconds s of the processor; its budget is $budget s"$'\n'
  fi
}

use_ccache
for stage in $stages; do
  if ! declare -F "stage_$stage" >/dev/null; then
    echo "no such stage: $stage" >&2
    exit 2
  fi
  printf '\n== %s\n' "$stage"
  start=$SECONDS
  measure
  used_before=$used
  "stage_$stage"
  measure
  timings+="$(printf '%6d s, %6d s of the processor  %s' $((SECONDS - start)) $((used - used_before)) "$stage")"$'\n'
  check_budget $((used - used_before))
  # Nothing that follows could work.
  if [[ $stage == dependencies && $failed -gt 0 ]]; then
    break
  fi
done

if [[ -n "$failures" ]]; then
  printf '\n== failures\n%s' "$failures"
fi
printf '\n%s\n%d passed, %d failed, %d skipped\n' "$timings" "$passed" "$failed" "$skipped"
[[ $failed -eq 0 ]]
