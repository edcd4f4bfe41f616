# Debian's package: `cpack -G DEB` in the build folder. One package with program, libraries, headers
# and Python; what it needs to run is found by dpkg-shlibdeps.

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME pixelexact)
set(CPACK_PACKAGE_CONTACT "The PixelExact authors <pixelexact@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
"Cuts through the solutions of spectral/hp and other high-order finite-element
solvers are traced ray by ray, and every pixel is the solver's own polynomial.
Program, VTK classes for C++ and Python, and libraries that need no VTK.")
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_PACKAGING_INSTALL_PREFIX "/usr")
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}")
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA "${CMAKE_CURRENT_LIST_DIR}/Debian/triggers")
if(PIXELEXACT_BUILD_PYTHON)
  list(APPEND CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA
    "${CMAKE_CURRENT_LIST_DIR}/Debian/postinst" "${CMAKE_CURRENT_LIST_DIR}/Debian/prerm")
  # Extension modules are for one minor version.
  math(EXPR next_minor "${Python3_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PACKAGE_DEPENDS
    "python3 (>= 3.${Python3_VERSION_MINOR}), python3 (<< 3.${next_minor}), python3-numpy, python3-vtk9")
endif()
# Videos; and what programs are built with that link the libraries.
set(CPACK_DEBIAN_PACKAGE_SUGGESTS
  "ffmpeg, libembree-dev, libglm-dev, libhwy-dev, libtbb-dev, libvtk9-dev")
include(CPack)

# Where Debian looks for them.
set(doc "${CMAKE_INSTALL_DATAROOTDIR}/doc/pixelexact")
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${doc}" RENAME copyright)
install(FILES "${PROJECT_SOURCE_DIR}/CHANGELOG.md" DESTINATION "${doc}")
