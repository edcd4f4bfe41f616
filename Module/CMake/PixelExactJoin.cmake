# What PIXELEXACT_JOINED_BUILD does: sources of a folder are compiled as one, so that what they include
# is parsed once. Names in unnamed namespaces must therefore be unique within a folder, and within
# folders that pixelexact_join_folders names together.

# pixelexact_join_folders(UNIT FOLDERS...)
#
# Compiles the sources of these folders, relative to the current one, as one unit. It is called before
# the targets of the sources are added.
function(pixelexact_join_folders unit)
  foreach(folder IN LISTS ARGN)
    pixelexact_get_folder("${folder}/any.cxx" identifier is_kernel)
    set_property(GLOBAL PROPERTY "PIXELEXACT_UNIT_OF_${identifier}" "${unit}")
  endforeach()
endfunction()

# The folder of a source, as an identifier, and whether the source holds kernels.
function(pixelexact_get_folder source folder_variable is_kernel_variable)
  cmake_path(ABSOLUTE_PATH source NORMALIZE OUTPUT_VARIABLE path)
  set(kernel)
  if(EXISTS "${path}")
    file(STRINGS "${path}" kernel REGEX "hwy/foreach_target.h" LIMIT_COUNT 1)
  endif()
  cmake_path(RELATIVE_PATH path BASE_DIRECTORY "${PROJECT_SOURCE_DIR}" OUTPUT_VARIABLE folder)
  cmake_path(GET folder PARENT_PATH folder)
  string(MAKE_C_IDENTIFIER "${folder}" folder)
  set(${folder_variable} "${folder}" PARENT_SCOPE)
  if(kernel)
    set(${is_kernel_variable} TRUE PARENT_SCOPE)
  else()
    set(${is_kernel_variable} FALSE PARENT_SCOPE)
  endif()
endfunction()

# A folder with more sources than this is compiled as several units, so that processors share it and
# no compiler needs more than about 1.5 GB.
set(PIXELEXACT_MAX_JOINED_SOURCES 28)

# pixelexact_join(TARGET SOURCES...)
#
# Joins the target's sources, except kernels and sources with options of their own.
function(pixelexact_join name)
  if(NOT PIXELEXACT_JOINED_BUILD)
    return()
  endif()
  set_target_properties(${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  # gcc spares types of the main source, which here is the one that CMake writes.
  target_compile_options(${name} PRIVATE
    $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  set(folders)
  foreach(source IN LISTS ARGN)
    pixelexact_get_folder("${source}" folder is_kernel)
    if(is_kernel)
      continue()
    endif()
    get_property(unit GLOBAL PROPERTY "PIXELEXACT_UNIT_OF_${folder}")
    if(unit)
      set_source_files_properties("${source}" PROPERTIES UNITY_GROUP "${unit}")
    else()
      list(APPEND folders ${folder})
      list(APPEND sources_${folder} "${source}")
    endif()
  endforeach()
  list(REMOVE_DUPLICATES folders)
  foreach(folder IN LISTS folders)
    # Units of a folder have equal numbers of sources, up to one. The first has the folder's name.
    list(LENGTH sources_${folder} count)
    math(EXPR units "1 + (${count} - 1) / ${PIXELEXACT_MAX_JOINED_SOURCES}")
    set(index 0)
    foreach(source IN LISTS sources_${folder})
      math(EXPR unit "${index} * ${units} / ${count}")
      string(REGEX REPLACE "_0$" "" group "${folder}_${unit}")
      set_source_files_properties("${source}" PROPERTIES UNITY_GROUP "${group}")
      math(EXPR index "${index} + 1")
    endforeach()
  endforeach()
endfunction()

# pixelexact_join_kernels(TARGET EXCEPT...)
#
# Joins the target's kernels. Highway's foreach_target.h includes HWY_TARGET_INCLUDE once for each
# instruction set; each kernel's source sets that name to itself, so the joined source sets it back.
function(pixelexact_join_kernels name)
  if(NOT PIXELEXACT_JOINED_BUILD)
    return()
  endif()
  get_target_property(sources ${name} SOURCES)
  list(TRANSFORM ARGN PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/" OUTPUT_VARIABLE apart)
  list(REMOVE_ITEM sources ${apart})
  set(folders)
  foreach(source IN LISTS sources)
    pixelexact_get_folder("${source}" folder is_kernel)
    if(is_kernel)
      list(APPEND folders ${folder})
      list(APPEND kernels_${folder} "${source}")
    endif()
  endforeach()
  list(REMOVE_DUPLICATES folders)
  foreach(folder IN LISTS folders)
    set(joined "${CMAKE_CURRENT_BINARY_DIR}/joined/${folder}_kernels.cxx")
    set(own_name "#undef HWY_TARGET_INCLUDE\n#define HWY_TARGET_INCLUDE \"${joined}\"\n")
    set(text "${own_name}#include <hwy/foreach_target.h>\n")
    foreach(source IN LISTS kernels_${folder})
      string(APPEND text "#include \"${source}\"\n")
    endforeach()
    file(CONFIGURE OUTPUT "${joined}" CONTENT "${text}${own_name}" @ONLY)
    set_source_files_properties(${kernels_${folder}} PROPERTIES HEADER_FILE_ONLY ON)
    target_sources(${name} PRIVATE "${joined}")
  endforeach()
endfunction()
