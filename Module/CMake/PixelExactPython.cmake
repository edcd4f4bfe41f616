# The Python package `pixelexact`: one extension module per VTK module, and an __init__.py that
# offers all of their classes after a look at the VTK that is there.

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
foreach(module IN LISTS wrapped_modules)
  string(REPLACE "PixelExact::" "" name "${module}")
  string(APPEND PIXELEXACT_PYTHON_IMPORTS "from .${name} import *\n")
endforeach()
set(package_folder "${PROJECT_BINARY_DIR}/${PIXELEXACT_PYTHON_DESTINATION}/pixelexact")
configure_file("${CMAKE_CURRENT_LIST_DIR}/__init__.py.in" "${package_folder}/__init__.py" @ONLY)
configure_file("${CMAKE_CURRENT_LIST_DIR}/_functions.py" "${package_folder}/_functions.py" COPYONLY)
configure_file("${CMAKE_CURRENT_LIST_DIR}/_vtk.py.in" "${PROJECT_BINARY_DIR}/_vtk.py.in" @ONLY)
file(GENERATE OUTPUT "${package_folder}/_vtk.py" INPUT "${PROJECT_BINARY_DIR}/_vtk.py.in")
install(FILES "${package_folder}/__init__.py" "${package_folder}/_functions.py"
  "${package_folder}/_vtk.py"
  DESTINATION "${PIXELEXACT_PYTHON_DESTINATION}/pixelexact")
