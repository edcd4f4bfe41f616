# The three VTK modules: each is the folder of its vtk.module file.

# pixelexact_add_vtk_module(NAME [FOLDERS ...] [NOWRAP_HEADERS ...])
#
# Adds a module from the sources beside the calling CMakeLists.txt: vtk*.cxx are its public classes,
# wrapped and installed; sources of other names, and those in FOLDERS, are its own affair.
# NOWRAP_HEADERS: headers among those that users in C++ need.
function(pixelexact_add_vtk_module name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "FOLDERS;NOWRAP_HEADERS")
  file(GLOB classes CONFIGURE_DEPENDS RELATIVE "${CMAKE_CURRENT_SOURCE_DIR}" "vtk*.cxx")
  list(TRANSFORM classes REPLACE "\\.cxx$" "")
  set(sources)
  set(private_headers)
  foreach(place "" ${arg_FOLDERS})
    string(REGEX REPLACE "(.)$" "\\1/" place "${place}")
    file(GLOB found CONFIGURE_DEPENDS RELATIVE "${CMAKE_CURRENT_SOURCE_DIR}" "${place}[A-Z]*.cxx")
    list(APPEND sources ${found})
    file(GLOB found CONFIGURE_DEPENDS RELATIVE "${CMAKE_CURRENT_SOURCE_DIR}" "${place}[A-Z]*.h")
    list(APPEND private_headers ${found})
  endforeach()
  list(REMOVE_ITEM private_headers ${arg_NOWRAP_HEADERS})
  vtk_module_add_module(${name}
    CLASSES ${classes}
    SOURCES ${sources}
    PRIVATE_HEADERS ${private_headers}
    NOWRAP_HEADERS ${arg_NOWRAP_HEADERS})
  string(REGEX REPLACE ".*::" "" target "${name}")
  list(TRANSFORM classes APPEND ".cxx" OUTPUT_VARIABLE class_sources)
  pixelexact_join(${target} ${class_sources} ${sources})
  if(PIXELEXACT_SANITIZE)
    pixelexact_precompile(${target}
      <vtkCellData.h> <vtkNew.h> <vtkObjectFactory.h> <vtkPointData.h> <vtkUnstructuredGrid.h>)
  endif()
endfunction()

set(PIXELEXACT_MODULES
  PixelExact::PixelExactDataModel
  PixelExact::PixelExactFilters
  PixelExact::PixelExactRendering)

set(PIXELEXACT_MODULE_FILES
  "${PROJECT_SOURCE_DIR}/Module/vtk.module"
  "${PROJECT_SOURCE_DIR}/Filters/vtk.module"
  "${PROJECT_SOURCE_DIR}/Rendering/vtk.module")

# Builds them against VTK; for ParaView's VTK the plugin does (PixelExactParaView.cmake). A macro, since
# the wrapping in Python looks for what it sets.
macro(pixelexact_build_vtk_modules)
  vtk_module_scan(
    MODULE_FILES ${PIXELEXACT_MODULE_FILES}
    PROVIDES_MODULES modules
    WANT_BY_DEFAULT ON
    ENABLE_TESTS OFF)

  vtk_module_build(
    MODULES ${modules}
    PACKAGE PixelExact
    INSTALL_EXPORT PixelExact
    UTILITY_TARGET PixelExactWarnings
    VERSION "${PROJECT_VERSION}"
    SOVERSION "${PIXELEXACT_SOVERSION}"
    ENABLE_WRAPPING ${PIXELEXACT_BUILD_PYTHON}
    HEADERS_DESTINATION "${PIXELEXACT_INCLUDE_DESTINATION}"
    CMAKE_DESTINATION "${PIXELEXACT_CMAKE_DESTINATION}"
    TEST_DIRECTORY_NAME NONE)
endmacro()
