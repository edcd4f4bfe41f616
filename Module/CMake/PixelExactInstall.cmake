# The CMake package; headers, libraries and the Python package are installed where they are made.
# PixelExact-targets.cmake, which vtk_module_build writes, covers Core and Trace too: they belong to
# the same export set.

include(CMakePackageConfigHelpers)

string(REPLACE ";" " " PIXELEXACT_VTK_COMPONENTS "${PIXELEXACT_VTK_COMPONENTS}")
string(REGEX MATCH "^[0-9]+" embree_VERSION_MAJOR "${embree_VERSION}")
configure_package_config_file(
  "${CMAKE_CURRENT_LIST_DIR}/PixelExactConfig.cmake.in"
  "${PROJECT_BINARY_DIR}/${PIXELEXACT_CMAKE_DESTINATION}/PixelExactConfig.cmake"
  INSTALL_DESTINATION "${PIXELEXACT_CMAKE_DESTINATION}")
write_basic_package_version_file(
  "${PROJECT_BINARY_DIR}/${PIXELEXACT_CMAKE_DESTINATION}/PixelExactConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(
  FILES
    "${PROJECT_BINARY_DIR}/${PIXELEXACT_CMAKE_DESTINATION}/PixelExactConfig.cmake"
    "${PROJECT_BINARY_DIR}/${PIXELEXACT_CMAKE_DESTINATION}/PixelExactConfigVersion.cmake"
  DESTINATION "${PIXELEXACT_CMAKE_DESTINATION}"
  COMPONENT development)
# In no package of Debian's, which have it elsewhere.
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" "${PROJECT_SOURCE_DIR}/Rendering/Settings/LICENSE-colormaps"
  DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/licenses/PixelExact"
  COMPONENT license)

include(PixelExactPackage)
