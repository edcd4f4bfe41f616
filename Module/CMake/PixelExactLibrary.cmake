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

# Highway compiles a kernel once per instruction set and picks one at run time. Each set costs minutes
# to compile: between the baseline and AVX2 lie only processors from before 2013, and AVX3_DL adds
# nothing that is used here. The widest set is left out for NARROW sources, which do not run in every
# frame. Under the sanitizers one set (PixelExactSettings.cmake) and few orders are enough: that all
# sets give the same bits is tested in the plain build.
function(pixelexact_use_lanes name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "NARROW")
  target_link_libraries(${name} PRIVATE hwy::hwy)
  if(PIXELEXACT_SANITIZE)
    target_compile_definitions(${name} PRIVATE HWY_COMPILE_ONLY_STATIC PIXELEXACT_FEW_ORDERS)
    return()
  endif()
  set(disabled "HWY_SSSE3|HWY_SSE4|HWY_AVX3_DL")
  target_compile_definitions(${name} PRIVATE "HWY_DISABLED_TARGETS=(${disabled})")
  if(arg_NARROW)
    set_source_files_properties(${arg_NARROW} PROPERTIES COMPILE_OPTIONS
      "-UHWY_DISABLED_TARGETS;-DHWY_DISABLED_TARGETS=(${disabled}|HWY_AVX3)")
  endif()
endfunction()
