# pixelexact_add_library(NAME INCLUDE_ROOT DIR SUBDIR DIR SOURCES ...)
#
# A VTK-free shared library: exported with the VTK modules, its headers installed so that the same
# #include "SUBDIR/..." works against the build and the install tree.
function(pixelexact_add_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "INCLUDE_ROOT;SUBDIR" "SOURCES")

  add_library(${name} SHARED ${arg_SOURCES})
  add_library(PixelExact::${name} ALIAS ${name})
  set_target_properties(${name} PROPERTIES
    VERSION "${PROJECT_VERSION}"
    SOVERSION "${PIXELEXACT_SOVERSION}")
  target_compile_features(${name} PUBLIC cxx_std_20)
  target_include_directories(${name} PUBLIC
    $<BUILD_INTERFACE:${arg_INCLUDE_ROOT}>
    $<INSTALL_INTERFACE:${PIXELEXACT_INCLUDE_DESTINATION}>)
  # Proofs by rounding need every operation rounded as written. PUBLIC: the headers hold some.
  target_compile_options(${name} PUBLIC -ffp-contract=off)
  target_link_libraries(${name} PRIVATE $<BUILD_INTERFACE:PixelExactWarnings>)
  pixelexact_join(${name} ${arg_SOURCES})
  if(PIXELEXACT_SANITIZE)
    pixelexact_precompile(${name} <glm/mat3x3.hpp> <glm/vec3.hpp>)
  endif()

  install(TARGETS ${name} EXPORT PixelExact
    LIBRARY COMPONENT runtime NAMELINK_COMPONENT development)
  install(DIRECTORY "${arg_INCLUDE_ROOT}/${arg_SUBDIR}/"
    DESTINATION "${PIXELEXACT_INCLUDE_DESTINATION}/${arg_SUBDIR}"
    COMPONENT development
    FILES_MATCHING PATTERN "*.h")
endfunction()

# pixelexact_use_lanes(NAME [NARROW SOURCES ...] [APART SOURCES ...])
#
# Highway compiles a kernel once per instruction set and picks one at run time. Each set costs minutes
# to compile: between the baseline and AVX2 lie only processors from before 2013, and AVX3_DL adds
# nothing that is used here. The widest set is left out for NARROW sources, which do not run in every
# frame, and without PIXELEXACT_AVX512 for all. Under the sanitizers one set (PixelExactSettings.cmake)
# and few orders are enough: that all sets give the same bits is tested in the plain build. A joined
# build joins the kernels of a folder, except NARROW and APART sources: those have options of their
# own, these take long to compile.
function(pixelexact_use_lanes name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "NARROW;APART")
  target_link_libraries(${name} PRIVATE hwy::hwy)
  pixelexact_join_kernels(${name} ${arg_NARROW} ${arg_APART})
  if(PIXELEXACT_SANITIZE)
    target_compile_definitions(${name} PRIVATE HWY_COMPILE_ONLY_STATIC PIXELEXACT_FEW_ORDERS)
    return()
  endif()
  set(narrow "HWY_SSSE3|HWY_SSE4|HWY_AVX3_DL|HWY_AVX3")
  set(disabled "HWY_SSSE3|HWY_SSE4|HWY_AVX3_DL")
  if(NOT PIXELEXACT_AVX512)
    set(disabled "${narrow}")
  endif()
  target_compile_definitions(${name} PRIVATE "HWY_DISABLED_TARGETS=(${disabled})")
  if(arg_NARROW AND PIXELEXACT_AVX512)
    set_source_files_properties(${arg_NARROW} PROPERTIES COMPILE_OPTIONS
      "-UHWY_DISABLED_TARGETS;-DHWY_DISABLED_TARGETS=(${narrow})")
  endif()
endfunction()
