#!/usr/bin/env bash
# Everything that must hold before a change goes in. Runs on a clean Debian 12 or newer.
#
# PIXELEXACT_TEST_STAGES selects from (default: all, in this order)
#   dependencies build test instructions sanitize fuzz format tidy
# The last line reads "N passed, N failed": tests of both builds, and one for each other stage. What
# failed is said once more before it, so that the end of a log is enough to go on.
set -uo pipefail
cd "$(dirname "$0")/../.."

stages=${PIXELEXACT_TEST_STAGES:-dependencies build test instructions sanitize fuzz format tidy}
build=build
sanitize_build=build-sanitize
fuzz_build=build-fuzz
jobs=$(nproc)
passed=0
failed=0
timings=""
failures=""
stage=""

launcher=()
if command -v ccache >/dev/null; then
  launcher=(-D CMAKE_C_COMPILER_LAUNCHER=ccache -D CMAKE_CXX_COMPILER_LAUNCHER=ccache)
fi

# Runs ctest in a build folder and adds its tests to the totals. Skipped tests count as neither.
run_ctest() {
  local folder=$1
  shift
  local log="$folder/ctest.log"
  ctest --test-dir "$folder" --parallel "$jobs" --output-on-failure --no-tests=error "$@" |
    tee "$log"
  local summary suite_failed suite_total suite_skipped
  summary=$(sed -n 's/.* \([0-9]*\) tests failed out of \([0-9]*\)$/\1 \2/p' "$log")
  if [[ -z "$summary" ]]; then
    count 1
    return
  fi
  read -r suite_failed suite_total <<<"$summary"
  suite_skipped=$(grep -c '[*][*][*]Skipped' "$log")
  passed=$((passed + suite_total - suite_failed - suite_skipped))
  failed=$((failed + suite_failed))
  if [[ $suite_failed -gt 0 ]]; then
    failures+="$(failed_tests "$log")"$'\n'
  fi
}

# What each failed test of a ctest log printed, at most 60 lines of each.
failed_tests() {
  awk '/^ *[0-9]+\/[0-9]+ Test|^ *Start +[0-9]+:/ { shown = 0 }
       /^ *[0-9]+\/[0-9]+ Test.*[*][*][*]/ && !/[*][*][*]Skipped/ { shown = 60 }
       shown > 0 { print; --shown }' "$1"
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

stage_dependencies() {
  ./Testing/Scripts/install-dependencies.sh --testing
  count $?
}

stage_build() {
  cmake -S . -B "$build" -G Ninja "${launcher[@]}" \
    -D PIXELEXACT_WARNINGS_AS_ERRORS=ON \
    -D PIXELEXACT_BUILD_TESTING=ON \
    -D PIXELEXACT_BUILD_PYTHON=ON \
    -D PIXELEXACT_BUILD_BENCHMARKS=ON &&
    cmake --build "$build" --parallel "$jobs" | tee "$build/build.log"
  count $? "$build/build.log"
}

stage_test() {
  run_ctest "$build"
}

# Frames must not cost more instructions than on record.
stage_instructions() {
  ./Testing/Benchmarks/instructions.py "$build/bin/InstructionCounts" |
    tee "$build/instructions.log"
  count $? "$build/instructions.log"
}

# Assertions are on and -O1 keeps the stack traces. No Python, no OpenGL: an interpreter or a driver
# without sanitizers cannot load our libraries.
stage_sanitize() {
  cmake -S . -B "$sanitize_build" -G Ninja "${launcher[@]}" \
    -D CMAKE_BUILD_TYPE=Debug \
    -D CMAKE_CXX_FLAGS_DEBUG="-O1 -g1" \
    -D PIXELEXACT_SANITIZE=ON \
    -D PIXELEXACT_BUILD_TESTING=ON \
    -D PIXELEXACT_BUILD_PYTHON=OFF &&
    cmake --build "$sanitize_build" --parallel "$jobs" --target PixelExactTests |
    tee "$sanitize_build/build.log"
  count $? "$sanitize_build/build.log"
  run_ctest "$sanitize_build" --label-exclude slow
}

# The parsers of the solvers' files, on any bytes. Both fuzzers run at once.
stage_fuzz() {
  cmake -S Testing/Fuzz -B "$fuzz_build" -G Ninja "${launcher[@]}" -D CMAKE_CXX_COMPILER=clang++ &&
    cmake --build "$fuzz_build" --parallel "$jobs" &&
    ./Testing/Fuzz/run.sh "$fuzz_build" 60 2>&1 | tee "$fuzz_build/fuzz.log"
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
  find Module Filters Rendering Testing Examples -name '*.h' -o -name '*.cxx' |
    xargs clang-format --dry-run -Werror 2>&1 | tee "$build/format.log"
  count $? "$build/format.log"
}

# One of Highway's instruction sets is enough to read a kernel. The tool's own commands and its counts
# of warnings in system headers are left out of the log.
stage_tidy() {
  run-clang-tidy -quiet -j "$jobs" -p "$build" -extra-arg=-DHWY_COMPILE_ONLY_STATIC \
    "^$PWD/(Module|Filters|Rendering)/.*\.cxx\$" 2>&1 |
    { grep -v -E '^(clang-tidy|[0-9]+ warnings? generated|$)' || true; } | tee "$build/tidy.log"
  count $? "$build/tidy.log"
}

for stage in $stages; do
  if ! declare -F "stage_$stage" >/dev/null; then
    echo "no such stage: $stage" >&2
    exit 2
  fi
  printf '\n== %s\n' "$stage"
  start=$SECONDS
  "stage_$stage"
  timings+="$(printf '%6d s  %s' $((SECONDS - start)) "$stage")"$'\n'
  # Nothing that follows could work.
  if [[ $stage == dependencies && $failed -gt 0 ]]; then
    break
  fi
done

if [[ -n "$failures" ]]; then
  printf '\n== failures\n%s' "$failures"
fi
printf '\n%s\n%d passed, %d failed\n' "$timings" "$passed" "$failed"
[[ $failed -eq 0 ]]
