# How tests are added. Labels: core (no VTK), vtk (VTK without OpenGL), image (needs a display),
# slow (minutes).

include(GoogleTest)

find_program(PIXELEXACT_XVFB_RUN xvfb-run)
mark_as_advanced(PIXELEXACT_XVFB_RUN)
# -noreset: without it the X server dies with the first of two windows of one process.
set(xvfb_command)
if(PIXELEXACT_XVFB_RUN)
  set(xvfb_command "${PIXELEXACT_XVFB_RUN}" -a -s "-screen 0 1280x1024x24 -noreset")
endif()

# Solver output that is too large for Data/; tests that want it skip where it is absent.
set(PIXELEXACT_DATA_DIR "${PROJECT_SOURCE_DIR}/Data")
set(PIXELEXACT_SHARED_DATA_DIR "${PROJECT_SOURCE_DIR}/../shared/data")

# Builds the test programs and what they need, but not the rest.
add_custom_target(PixelExactTests)

# pixelexact_add_test(NAME SOURCES ... LINK ... LABELS ... [XVFB])
#
# One GoogleTest executable, each of its tests known to ctest. XVFB: the tests draw with OpenGL and
# run under a virtual display; they are left out of a sanitizer build, because the OpenGL driver is
# not ours to sanitize.
function(pixelexact_add_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "XVFB" "" "SOURCES;LINK;LABELS")
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
  if(arg_XVFB)
    set_target_properties(${name} PROPERTIES CROSSCOMPILING_EMULATOR "${xvfb_command}")
  endif()

  gtest_discover_tests(${name}
    TEST_PREFIX "${name}."
    TEST_LIST ${name}_TESTS
    NO_PRETTY_VALUES
    DISCOVERY_MODE PRE_TEST
    DISCOVERY_TIMEOUT 60
    PROPERTIES TIMEOUT 600)
  # Its PROPERTIES cannot hold a list, so ctest reads the labels from a script of our own.
  set(labels_script "${CMAKE_CURRENT_BINARY_DIR}/${name}_labels.cmake")
  file(CONFIGURE OUTPUT "${labels_script}" @ONLY
    CONTENT "set_tests_properties(\${@name@_TESTS} PROPERTIES LABELS \"@arg_LABELS@\")\n")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES "${labels_script}")
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
    set(launcher ${xvfb_command})
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
