# cmake -D BUILD=<build tree> -D SOURCE=<project root> -D WORK=<scratch folder> -D GENERATOR=...
#       -D CXX=<compiler> [-D PYTHON=<interpreter> -D PYTHON_DESTINATION=<folder>]
#       -P RunConsumer.cmake
#
# Installs the build tree below WORK, builds the consumer and the C++ example against that, runs the
# consumer, and imports the installed Python package.

function(run)
  # Without the variable no build tree can lend its libraries to the installed ones.
  execute_process(
    COMMAND "${CMAKE_COMMAND}" -E env --unset=LD_LIBRARY_PATH ${ARGV}
    COMMAND_ECHO STDOUT
    COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE "${WORK}")
run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${WORK}/first")
# An installed tree may be moved.
file(RENAME "${WORK}/first" "${WORK}/prefix")

foreach(project Testing/Consumer Examples/CutPlane)
  run("${CMAKE_COMMAND}" -S "${SOURCE}/${project}" -B "${WORK}/${project}" -G "${GENERATOR}"
    "-DCMAKE_CXX_COMPILER=${CXX}" "-DCMAKE_PREFIX_PATH=${WORK}/prefix" -DCMAKE_BUILD_TYPE=Release)
  run("${CMAKE_COMMAND}" --build "${WORK}/${project}")
endforeach()
run("${WORK}/Testing/Consumer/CoreConsumer")
run("${WORK}/Testing/Consumer/VTKConsumer")
run("${WORK}/prefix/bin/pixelexact" --version)

if(PYTHON)
  run("PYTHONPATH=${WORK}/prefix/${PYTHON_DESTINATION}" "${PYTHON}" -c
    "print(__import__('pixelexact').vtkHighOrderGrid())")
endif()
