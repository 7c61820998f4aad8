# SPDX-License-Identifier: GPL-3.0-or-later
# Script of the test `consumer`.
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE "${SCRATCH}")
run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${SCRATCH}/installed")

set(configure "${CMAKE_COMMAND}" -G "${GENERATOR}" "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_C_COMPILER=${C_COMPILER}"
    "-DCMAKE_BUILD_TYPE=${TYPE}" "-DCMAKE_PREFIX_PATH=${SCRATCH}/installed")

# A project that wants core only must not need CGAL or HDF5: here it cannot find them.
run(${configure} -S "${SOURCE}/core_only" -B "${SCRATCH}/core_only"
    -DCMAKE_DISABLE_FIND_PACKAGE_CGAL=ON -DCMAKE_DISABLE_FIND_PACKAGE_HDF5=ON)
run("${CMAKE_COMMAND}" --build "${SCRATCH}/core_only")
run("${SCRATCH}/core_only/core_only")

run(${configure} -S "${SOURCE}/whole" -B "${SCRATCH}/whole")
run("${CMAKE_COMMAND}" --build "${SCRATCH}/whole")
run("${SCRATCH}/whole/whole")

# The switch used above does hide HDF5: without it io must be refused, and say so.
execute_process(COMMAND ${configure} -S "${SOURCE}/whole" -B "${SCRATCH}/refused" -DCMAKE_DISABLE_FIND_PACKAGE_HDF5=ON
                RESULT_VARIABLE failed OUTPUT_VARIABLE said ERROR_VARIABLE said)
if(NOT failed OR NOT said MATCHES "HDF5")
  message(FATAL_ERROR "hdconj::io was found without HDF5:\n${said}")
endif()
