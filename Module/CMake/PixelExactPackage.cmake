# Debian's packages: `cpack -G DEB` in the build folder. One for each component (PixelExactSettings.cmake);
# what they need to run is found by dpkg-shlibdeps.

set(PIXELEXACT_PACKAGE_CONTACT "PixelExact developers <noreply@pixelexact.invalid>" CACHE STRING
  "Who answers for Debian's packages: name and address")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME pixelexact)
set(CPACK_PACKAGE_CONTACT "${PIXELEXACT_PACKAGE_CONTACT}")
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_PACKAGING_INSTALL_PREFIX "/usr")
set(CPACK_STRIP_FILES ON)
# Whatever the umask of who packs.
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL runtime development)
if(PIXELEXACT_BUILD_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_COMPONENT_DEVELOPMENT_DEPENDS runtime)
set(CPACK_COMPONENT_PYTHON_DEPENDS runtime)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}")
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(debian "${CMAKE_CURRENT_LIST_DIR}/Debian")
# Manual pages and changelogs are compressed there.
set(CPACK_PRE_BUILD_SCRIPTS "${debian}/compress.cmake")
set(about "Cuts through the solutions of spectral/hp and other high-order finite-element
solvers are traced ray by ray, and every pixel is the solver's own polynomial.
")

set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME pixelexact)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION science)
set(CPACK_DEBIAN_RUNTIME_DESCRIPTION
  "${about}Program, window and libraries.")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA "${debian}/triggers")
# Videos.
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SUGGESTS "ffmpeg")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libpixelexact-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION
  "${about}What programs in C++ are built with, by CMake's find_package(PixelExact).")
# What PixelExactConfig.cmake looks for.
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  "libembree-dev, libglm-dev, libhwy-dev, libtbb-dev, libvtk9-dev")

if(PIXELEXACT_BUILD_PYTHON)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-pixelexact)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_DESCRIPTION
    "${about}The VTK classes, and in short what most scripts want.")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA "${debian}/postinst" "${debian}/prerm")
  # Extension modules are for one minor version.
  math(EXPR next_minor "${Python3_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "python3 (>= 3.${Python3_VERSION_MINOR}), python3 (<< 3.${next_minor}), python3-numpy, python3-vtk9")
endif()
include(CPack)

# Where Debian looks for them; of the first also below other prefixes. What changed is in CHANGELOG.md.
string(TIMESTAMP PIXELEXACT_PACKAGE_DATE "%a, %d %b %Y %H:%M:%S +0000" UTC)
configure_file("${debian}/changelog.in" "${PROJECT_BINARY_DIR}/debian/changelog" @ONLY)
set(elsewhere)
foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER "${component}" variable)
  set(doc "${CMAKE_INSTALL_DATAROOTDIR}/doc/${CPACK_DEBIAN_${variable}_PACKAGE_NAME}")
  install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${doc}" RENAME copyright
    COMPONENT ${component} ${elsewhere})
  install(FILES
    "${PROJECT_BINARY_DIR}/debian/changelog" "${PROJECT_SOURCE_DIR}/Rendering/Settings/LICENSE-colormaps"
    DESTINATION "${doc}"
    COMPONENT ${component} EXCLUDE_FROM_ALL)
  set(elsewhere EXCLUDE_FROM_ALL)
endforeach()
install(FILES "${PROJECT_SOURCE_DIR}/CHANGELOG.md"
  DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/doc/pixelexact")
