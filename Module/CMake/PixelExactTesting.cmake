# How tests are added. Labels: core (no VTK), vtk (VTK without OpenGL), image (needs a display).

# Tests that draw run through this: it takes the display of $PIXELEXACT_TEST_DISPLAY, which a whole
# run of ctest may share, or starts one for the test alone.
set(PIXELEXACT_WITH_DISPLAY "${PROJECT_SOURCE_DIR}/Testing/Scripts/with-display.sh")

# Solver output that is too large for Data/; tests that want it skip where it is absent.
set(PIXELEXACT_DATA_DIR "${PROJECT_SOURCE_DIR}/Data")
set(PIXELEXACT_SHARED_DATA_DIR "${PROJECT_SOURCE_DIR}/../shared/data")

# Where each process of a test program leaves what it found, as JSON; see Testing/Scripts/report.py.
set(PIXELEXACT_TEST_RESULTS "${PROJECT_BINARY_DIR}/Testing/Results")

# Each test program is run as so many processes.
set(PIXELEXACT_TEST_PROCESSES 4)

# Builds the test programs and what they need, but not the rest.
add_custom_target(PixelExactTests)

# pixelexact_add_test(NAME SOURCES ... LINK ... LABELS ... [XVFB] [PRECOMPILE headers...])
#
# One GoogleTest executable. ctest runs it as a few processes, each with its share of the tests: a
# process per test would load all libraries each time. One test alone is run by
# NAME --gtest_filter=... XVFB: the tests draw with OpenGL and need a display; they are left out of a
# sanitizer build, because the OpenGL driver is not ours to sanitize. PRECOMPILE: what most sources
# include beside GoogleTest and the standard library.
function(pixelexact_add_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "XVFB" "" "SOURCES;LINK;LABELS;PRECOMPILE")
  if(NOT arg_SOURCES OR (arg_XVFB AND PIXELEXACT_SANITIZE))
    return()
  endif()

  add_executable(${name} ${arg_SOURCES})
  add_dependencies(PixelExactTests ${name})
  target_compile_definitions(${name} PRIVATE
    PIXELEXACT_DATA_DIR="${PIXELEXACT_DATA_DIR}"
    PIXELEXACT_SHARED_DATA_DIR="${PIXELEXACT_SHARED_DATA_DIR}")
  target_include_directories(${name} PRIVATE "${PROJECT_SOURCE_DIR}/Testing")
  target_link_libraries(${name} PRIVATE PixelExactWarnings ${arg_LINK} GTest::gtest_main)
  pixelexact_join(${name} ${arg_SOURCES})
  pixelexact_precompile(${name} <gtest/gtest.h> ${arg_PRECOMPILE})

  set(launcher)
  if(arg_XVFB)
    set(launcher "${PIXELEXACT_WITH_DISPLAY}")
  endif()
  math(EXPR last "${PIXELEXACT_TEST_PROCESSES} - 1")
  foreach(shard RANGE ${last})
    add_test(NAME ${name}.${shard}
      COMMAND ${launcher} $<TARGET_FILE:${name}>
        "--gtest_output=json:${PIXELEXACT_TEST_RESULTS}/${name}.${shard}.json")
    set_tests_properties(${name}.${shard} PROPERTIES
      LABELS "${arg_LABELS}"
      TIMEOUT 600
      ENVIRONMENT "GTEST_TOTAL_SHARDS=${PIXELEXACT_TEST_PROCESSES};GTEST_SHARD_INDEX=${shard}")
  endforeach()
endfunction()

# pixelexact_add_python_tests(PREFIX LABELS ... [XVFB] [ENVIRONMENT ...] SCRIPTS ...)
#
# Each script is one test. It finds the command-line tool in $PIXELEXACT_TOOL, the data in
# $PIXELEXACT_DATA_DIR and $PIXELEXACT_SHARED_DATA_DIR, and may import pixelexact.
function(pixelexact_add_python_tests prefix)
  cmake_parse_arguments(PARSE_ARGV 1 arg "XVFB" "" "SCRIPTS;LABELS")
  set(launcher)
  # Without XVFB there is no display at all, not even the developer's own.
  set(display "DISPLAY=unset:")
  if(arg_XVFB)
    set(launcher "${PIXELEXACT_WITH_DISPLAY}")
    set(display)
  endif()
  foreach(script IN LISTS arg_SCRIPTS)
    get_filename_component(test "${script}" NAME_WE)
    add_test(NAME ${prefix}.${test} COMMAND ${launcher} "${Python3_EXECUTABLE}" "${script}")
    set_tests_properties(${prefix}.${test} PROPERTIES
      LABELS "${arg_LABELS}"
      TIMEOUT 600
      ENVIRONMENT "PIXELEXACT_TOOL=$<TARGET_FILE:pixelexact>;PIXELEXACT_DATA_DIR=${PIXELEXACT_DATA_DIR};PIXELEXACT_SHARED_DATA_DIR=${PIXELEXACT_SHARED_DATA_DIR};PYTHONDONTWRITEBYTECODE=1"
      ENVIRONMENT_MODIFICATION "PYTHONPATH=path_list_prepend:${PROJECT_BINARY_DIR}/${PIXELEXACT_PYTHON_DESTINATION};${display}")
  endforeach()
endfunction()
