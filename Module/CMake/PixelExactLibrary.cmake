# pixelexact_add_library(NAME INCLUDE_ROOT DIR SUBDIR DIR SOURCES ...)
#
# A VTK-free shared library: exported with the VTK modules, its headers installed so that the same
# #include "SUBDIR/..." works against the build and the install tree.
function(pixelexact_add_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "INCLUDE_ROOT;SUBDIR" "SOURCES")

  add_library(${name} SHARED ${arg_SOURCES})
  add_library(PixelExact::${name} ALIAS ${name})
  target_compile_features(${name} PUBLIC cxx_std_20)
  target_include_directories(${name} PUBLIC
    $<BUILD_INTERFACE:${arg_INCLUDE_ROOT}>
    $<INSTALL_INTERFACE:${PIXELEXACT_INCLUDE_DESTINATION}>)
  # Proofs by rounding need every operation rounded as written. PUBLIC: the headers hold some.
  target_compile_options(${name} PUBLIC -ffp-contract=off)
  target_link_libraries(${name} PRIVATE $<BUILD_INTERFACE:PixelExactWarnings>)

  install(TARGETS ${name} EXPORT PixelExact)
  install(DIRECTORY "${arg_INCLUDE_ROOT}/${arg_SUBDIR}/"
    DESTINATION "${PIXELEXACT_INCLUDE_DESTINATION}/${arg_SUBDIR}"
    FILES_MATCHING PATTERN "*.h")
endfunction()

# Highway compiles a kernel once per instruction set and picks one at run time. Each set costs minutes
# to compile: between the baseline and AVX2 lie only processors from before 2013, and AVX3_DL adds
# nothing that is used here. Under the sanitizers one set beside the baseline and few orders are enough.
function(pixelexact_use_lanes name)
  set(disabled_targets "HWY_SSSE3|HWY_SSE4|HWY_AVX3_DL")
  if(PIXELEXACT_SANITIZE)
    string(APPEND disabled_targets "|HWY_AVX3")
    target_compile_definitions(${name} PRIVATE PIXELEXACT_FEW_ORDERS)
  endif()
  target_link_libraries(${name} PRIVATE hwy::hwy)
  target_compile_definitions(${name} PRIVATE "HWY_DISABLED_TARGETS=(${disabled_targets})")
endfunction()
