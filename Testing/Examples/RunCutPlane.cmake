# cmake -D BUILD=<build tree> -D SOURCE=<Examples/CutPlane> -D WORK=<scratch folder> -D MESH=<file>
#       [-D GENERATOR=...] [-D CXX=...] -P RunCutPlane.cmake

function(run)
  execute_process(
    COMMAND "${CMAKE_COMMAND}" -E env --unset=LD_LIBRARY_PATH ${ARGV}
    COMMAND_ECHO STDOUT
    COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE "${WORK}")
run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${WORK}/prefix")
run("${CMAKE_COMMAND}" -S "${SOURCE}" -B "${WORK}/build" -G "${GENERATOR}"
  "-DCMAKE_CXX_COMPILER=${CXX}" "-DCMAKE_PREFIX_PATH=${WORK}/prefix" -DCMAKE_BUILD_TYPE=Release)
run("${CMAKE_COMMAND}" --build "${WORK}/build")

run("${CMAKE_CURRENT_LIST_DIR}/../Scripts/with-display.sh"
  "${WORK}/build/CutPlane" "${MESH}" u "${WORK}/cut.png")
if(NOT EXISTS "${WORK}/cut.png")
  message(FATAL_ERROR "no picture")
endif()
