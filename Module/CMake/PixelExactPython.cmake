# The Python package `pixelexact`: one extension module per VTK module, one for long work, and an
# __init__.py that offers all of it after a look at the VTK that is there.

vtk_module_wrap_python(
  MODULES ${PIXELEXACT_MODULES}
  TARGET PixelExact::PixelExactPython
  WRAPPED_MODULES wrapped_modules
  PYTHON_PACKAGE pixelexact
  MODULE_DESTINATION "${PIXELEXACT_PYTHON_DESTINATION}"
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  CMAKE_DESTINATION "${PIXELEXACT_CMAKE_DESTINATION}"
  BUILD_STATIC OFF)

set(PIXELEXACT_PYTHON_IMPORTS "")
set(stubbed_modules)
foreach(module IN LISTS wrapped_modules)
  string(REPLACE "PixelExact::" "" name "${module}")
  string(APPEND PIXELEXACT_PYTHON_IMPORTS "from .${name} import *\n")
  list(APPEND stubbed_modules "${name}")
endforeach()
set(package_source "${PROJECT_SOURCE_DIR}/Rendering/Python/pixelexact")
set(package_folder "${PROJECT_BINARY_DIR}/${PIXELEXACT_PYTHON_DESTINATION}/pixelexact")
configure_file("${package_source}/__init__.py.in" "${package_folder}/__init__.py" @ONLY)
configure_file("${package_source}/_vtk.py.in" "${PROJECT_BINARY_DIR}/_vtk.py.in" @ONLY)
file(GENERATE OUTPUT "${package_folder}/_vtk.py" INPUT "${PROJECT_BINARY_DIR}/_vtk.py.in")
set(package_files "${package_folder}/__init__.py" "${package_folder}/_vtk.py")
file(GLOB sources CONFIGURE_DEPENDS RELATIVE "${package_source}"
  "${package_source}/*.py" "${package_source}/*.pyi" "${package_source}/py.typed")
foreach(source IN LISTS sources)
  add_custom_command(
    OUTPUT "${package_folder}/${source}"
    COMMAND "${CMAKE_COMMAND}" -E copy "${package_source}/${source}" "${package_folder}/${source}"
    DEPENDS "${package_source}/${source}"
    VERBATIM)
  list(APPEND package_files "${package_folder}/${source}")
endforeach()

# Texts of keywords and of file formats.
foreach(table IN ITEMS "python:_setting_rows.py" "python-formats:_format_rows.py")
  string(REGEX MATCH "(.*):(.*)" table "${table}")
  add_custom_command(
    OUTPUT "${package_folder}/${CMAKE_MATCH_2}"
    COMMAND "${Python3_EXECUTABLE}" -B "${PROJECT_SOURCE_DIR}/Rendering/Settings/generate.py"
      "${CMAKE_MATCH_1}" "${package_folder}/${CMAKE_MATCH_2}"
    DEPENDS ${PIXELEXACT_SETTING_FILES}
    VERBATIM)
  list(APPEND package_files "${package_folder}/${CMAKE_MATCH_2}")
endforeach()

Python3_add_library(PixelExactRun MODULE "${PROJECT_SOURCE_DIR}/Rendering/Python/Run.cxx")
set_target_properties(PixelExactRun PROPERTIES
  OUTPUT_NAME _run
  LIBRARY_OUTPUT_DIRECTORY "${package_folder}")
target_link_libraries(PixelExactRun PRIVATE
  PixelExactInput PixelExactWarnings TBB::tbb VTK::CommonExecutionModel VTK::WrappingPythonCore)
install(TARGETS PixelExactRun
  DESTINATION "${PIXELEXACT_PYTHON_DESTINATION}/pixelexact"
  COMPONENT python)

# Types of the wrapped classes, as their texts of help say them.
set(stubs)
foreach(name IN LISTS stubbed_modules)
  list(APPEND stubs "${package_folder}/${name}.pyi")
endforeach()
list(TRANSFORM stubbed_modules APPEND Python OUTPUT_VARIABLE wrapped_targets)
# What VTK generates for each class parses the same headers.
if(PIXELEXACT_JOINED_BUILD)
  set_target_properties(${wrapped_targets} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 32)
endif()
add_custom_command(
  OUTPUT ${stubs}
  COMMAND "${CMAKE_COMMAND}" -E env
    "PYTHONPATH=${PROJECT_BINARY_DIR}/${PIXELEXACT_PYTHON_DESTINATION}"
    "${Python3_EXECUTABLE}" "${PROJECT_SOURCE_DIR}/Rendering/Python/stubs.py" "${package_folder}"
    ${stubbed_modules}
  DEPENDS ${wrapped_targets} PixelExactRun ${package_files}
    "${PROJECT_SOURCE_DIR}/Rendering/Python/stubs.py"
  VERBATIM)
add_custom_target(PixelExactStubs ALL DEPENDS ${stubs})

install(FILES ${package_files} ${stubs}
  DESTINATION "${PIXELEXACT_PYTHON_DESTINATION}/pixelexact"
  COMPONENT python)
