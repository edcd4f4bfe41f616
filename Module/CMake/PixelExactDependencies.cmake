# Everything found outside the project. PixelExactConfig.cmake.in repeats what users of the
# installed libraries need.

# VTK's Python wrapping is built for the distribution's interpreter, which another python3 that
# comes first on the PATH would hide.
if(NOT DEFINED Python3_EXECUTABLE AND EXISTS "/usr/bin/python3")
  set(Python3_EXECUTABLE "/usr/bin/python3" CACHE FILEPATH "The Python that VTK is built for")
endif()
# VTK's own package looks for Python once more and must find the same one.
set(Python3_FIND_STRATEGY LOCATION)
if(PIXELEXACT_BUILD_PYTHON)
  find_package(Python3 REQUIRED COMPONENTS Interpreter Development.Module)
else()
  find_package(Python3 REQUIRED COMPONENTS Interpreter)
endif()

find_package(TBB REQUIRED)
find_package(glm REQUIRED)
find_package(hwy REQUIRED)
find_package(Eigen3 REQUIRED NO_MODULE)
find_package(ZLIB REQUIRED)
find_package(pugixml REQUIRED)
find_package(pegtl REQUIRED)
# For the HDF5 files of Nektar++; without it they are refused.
find_package(HDF5 COMPONENTS C)

# Debian's xxHash has no CMake package.
find_path(XXHASH_INCLUDE_DIR xxhash.h REQUIRED)
find_library(XXHASH_LIBRARY xxhash REQUIRED)
add_library(xxHash::xxHash UNKNOWN IMPORTED)
set_target_properties(xxHash::xxHash PROPERTIES
  IMPORTED_LOCATION "${XXHASH_LIBRARY}"
  INTERFACE_INCLUDE_DIRECTORIES "${XXHASH_INCLUDE_DIR}")

# Embree 3 and 4 differ in their headers; the sources ask for both with __has_include.
find_package(embree 4 QUIET)
if(NOT embree_FOUND)
  find_package(embree 3 REQUIRED)
endif()

# By name: a find_package(VTK) without components demands Qt. The first list is what the modules
# depend on, hence what users of the installed package need too.
set(PIXELEXACT_VTK_COMPONENTS
  CommonCore
  CommonDataModel
  CommonExecutionModel
  CommonMath
  CommonMisc
  CommonTransforms
  FiltersCore
  IOLegacy
  IOXML
  ParallelCore
  RenderingCore
  RenderingFreeType
  RenderingOpenGL2)
set(vtk_build_components FiltersGeneral FiltersParallel IOCore IOGeometry IOImage)
if(PIXELEXACT_BUILD_VIEW)
  list(APPEND vtk_build_components FiltersSources InteractionStyle)
endif()
if(PIXELEXACT_BUILD_PYTHON)
  list(APPEND vtk_build_components Python WrappingPythonCore)
endif()
if(PIXELEXACT_BUILD_TESTING OR PIXELEXACT_BUILD_BENCHMARKS)
  list(APPEND vtk_build_components
    FiltersExtraction
    FiltersGeometry
    FiltersSources
    InteractionStyle
    RenderingAnnotation
    TestingRendering)
endif()
if(PIXELEXACT_BUILD_PARAVIEW)
  find_package(nlohmann_json REQUIRED)
  include(PixelExactParaViewPackage)
  return()
endif()
# Without these the program refuses CGNS by name, and several processes.
find_package(VTK 9.1 REQUIRED COMPONENTS ${PIXELEXACT_VTK_COMPONENTS} ${vtk_build_components}
  OPTIONAL_COMPONENTS IOCGNSReader cgns mpi ParallelMPI)

find_package(CLI11 REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(Freetype REQUIRED)
# cairo has no CMake package.
find_package(PkgConfig REQUIRED)
pkg_check_modules(CAIRO REQUIRED IMPORTED_TARGET cairo-ft cairo-pdf cairo-svg fontconfig)
# Without it the program refuses serve by name.
if(PIXELEXACT_BUILD_SERVE)
  pkg_check_modules(WEBSOCKETS QUIET IMPORTED_TARGET libwebsockets>=4.0)
  if(NOT WEBSOCKETS_FOUND)
    message(STATUS "No command serve: libwebsockets is missing (libwebsockets-dev)")
    set(PIXELEXACT_BUILD_SERVE OFF)
  endif()
endif()
find_package(PNG REQUIRED)
find_package(TIFF REQUIRED)
# The component CXX of CMake 3.25 forgets where it is.
find_library(TIFF_STREAM_LIBRARY tiffxx REQUIRED)

if(PIXELEXACT_BUILD_TESTING)
  find_package(GTest REQUIRED)
endif()
if(PIXELEXACT_BUILD_BENCHMARKS)
  find_package(benchmark REQUIRED)
endif()
