# Settings shared by every target: build type, language, where things go, warnings, sanitizers.

get_property(multi_config GLOBAL PROPERTY GENERATOR_IS_MULTI_CONFIG)
if(NOT multi_config AND NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(BUILD_SHARED_LIBS ON)

# Before 1.0 each minor version may break what is linked with it.
set(PIXELEXACT_SOVERSION "${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}")

# The same layout in the build and in the install tree, on every distribution.
set(CMAKE_INSTALL_LIBDIR lib CACHE PATH "Where libraries go below the prefix")
include(GNUInstallDirs)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/${CMAKE_INSTALL_BINDIR}")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
set(PIXELEXACT_INCLUDE_DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/PixelExact")
set(PIXELEXACT_CMAKE_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/PixelExact")
set(PIXELEXACT_PYTHON_DESTINATION "${CMAKE_INSTALL_LIBDIR}/python3/dist-packages")

# What is installed is of one of these components, as VTK's own rules name them: runtime, development,
# python. Debian's packages (PixelExactPackage.cmake) are made of them.
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME runtime)

# An installed tree may be moved: libraries find each other relative to themselves.
file(RELATIVE_PATH bin_to_lib "/${CMAKE_INSTALL_BINDIR}" "/${CMAKE_INSTALL_LIBDIR}")
set(CMAKE_INSTALL_RPATH "$ORIGIN" "$ORIGIN/${bin_to_lib}")

# Flags of our own sources. An interface target and not global flags, because the wrapping code
# that VTK generates does not compile without warnings.
add_library(PixelExactWarnings INTERFACE)
target_compile_options(PixelExactWarnings INTERFACE
  -Wall -Wextra -Wshadow -Wnon-virtual-dtor
  $<$<BOOL:${PIXELEXACT_WARNINGS_AS_ERRORS}>:-Werror>)

# pixelexact_build_quickly(TARGET)
#
# What PIXELEXACT_QUICK_BUILD does, for targets that read and write. Filters are none of them: compare
# times the linear pipeline there beside exact pictures.
function(pixelexact_build_quickly name)
  if(PIXELEXACT_QUICK_BUILD)
    target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()
endfunction()

# pixelexact_precompile(TARGET HEADERS...)
#
# Parses what most sources of a target include once, where each is compiled alone. Sources still
# include what they use: clang-tidy reads them without. Of libraries under the sanitizers alone: gcc forgets that what it precompiled are
# system headers, so that some of its warnings about std::string are false and must be off.
function(pixelexact_precompile name)
  if(PIXELEXACT_PRECOMPILE_HEADERS AND NOT PIXELEXACT_JOINED_BUILD)
    target_precompile_headers(${name} PRIVATE
      <algorithm> <array> <cmath> <cstdint> <functional> <limits> <memory> <optional> <span> <string>
      <vector> ${ARGN})
    target_compile_options(${name} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds
      -Wno-restrict -Wno-stringop-overflow -Wno-stringop-overread>)
  endif()
endfunction()

if(PIXELEXACT_SANITIZE)
  # Kernels are compiled for one instruction set, the widest that is common; see
  # pixelexact_use_lanes. For all sources, because Eigen's inline functions must not differ.
  include(CheckCXXSourceRuns)
  set(CMAKE_REQUIRED_FLAGS "-march=haswell -maes")
  check_cxx_source_runs(
    "int main() { return __builtin_cpu_supports(\"avx2\") && __builtin_cpu_supports(\"fma\") ? 0 : 1; }"
    PIXELEXACT_HAS_AVX2)
  unset(CMAKE_REQUIRED_FLAGS)
  if(PIXELEXACT_HAS_AVX2)
    add_compile_options(-march=haswell -maes)
  endif()

  # The address sanitizer finds what null and object-size look for; without them the kernels compile
  # in two thirds of the time.
  add_compile_options(-fsanitize=address,undefined -fno-sanitize=null,object-size
    -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
endif()
