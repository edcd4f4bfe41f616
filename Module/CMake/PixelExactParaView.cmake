# The ParaView plugin: the three VTK modules and that of the representation, built against ParaView's
# VTK and wrapped for its server manager.

set(PIXELEXACT_PARAVIEW_MODULES
  PixelExact::PixelExactParaViewReaders
  PixelExact::PixelExactParaViewFilters
  PixelExact::PixelExactParaView)

# pixelexact_generate_settings(WHAT FILES...)
#
# Writes a file by Rendering/Settings/generate.py, when the build folder is configured and again
# where the table or a template changes.
function(pixelexact_generate_settings what)
  set(settings "${PROJECT_SOURCE_DIR}/Rendering/Settings")
  list(POP_BACK ARGN out)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS
    ${PIXELEXACT_SETTING_FILES} ${ARGN})
  execute_process(
    COMMAND "${Python3_EXECUTABLE}" -B "${settings}/generate.py" ${what} ${ARGN} "${out}"
    COMMAND_ERROR_IS_FATAL ANY)
endfunction()

paraview_plugin_scan(
  PLUGIN_FILES "${PROJECT_SOURCE_DIR}/ParaView/paraview.plugin"
  PROVIDES_PLUGINS plugins
  REQUIRES_MODULES required_modules
  ENABLE_BY_DEFAULT ON)
foreach(module IN LISTS required_modules)
  if(NOT TARGET "${module}")
    message(FATAL_ERROR "PIXELEXACT_BUILD_PARAVIEW: ParaView ${ParaView_VERSION} lacks ${module}")
  endif()
endforeach()

paraview_plugin_build(
  PLUGINS ${plugins}
  PLUGINS_FILE_NAME "pixelexact.plugins.xml"
  HEADERS_DESTINATION "${PIXELEXACT_INCLUDE_DESTINATION}"
  RUNTIME_DESTINATION "${CMAKE_INSTALL_BINDIR}"
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  LIBRARY_SUBDIRECTORY "${PARAVIEW_PLUGIN_SUBDIR}"
  INSTALL_HEADERS OFF)

# What ParaView generates for each class parses the same headers.
if(PIXELEXACT_JOINED_BUILD)
  foreach(module IN LISTS PIXELEXACT_MODULES PIXELEXACT_PARAVIEW_MODULES)
    string(REGEX REPLACE ".*::" "" target "${module}CS")
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 32)
  endforeach()
endif()

# An unpacked ParaView finds its libraries and Python modules through this script only.
get_target_property(paraview_library ParaView::RemotingCore LOCATION)
cmake_path(GET paraview_library PARENT_PATH paraview_libdir)
file(RELATIVE_PATH paraview_libdir "${ParaView_PREFIX_PATH}" "${paraview_libdir}")
configure_file("${PROJECT_SOURCE_DIR}/ParaView/with-paraview.sh.in"
  "${PROJECT_BINARY_DIR}/with-paraview.sh" @ONLY)

if(PIXELEXACT_BUILD_TESTING)
  add_subdirectory("${PROJECT_SOURCE_DIR}/ParaView/Testing" "${PROJECT_BINARY_DIR}/Testing")
endif()
