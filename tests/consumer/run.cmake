# SPDX-License-Identifier: GPL-3.0-or-later
# Script of the test `consumer`.
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

get_filename_component(ROOT "${SOURCE}/../.." ABSOLUTE)
file(REMOVE_RECURSE "${SCRATCH}")
run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${SCRATCH}/installed")

set(configure "${CMAKE_COMMAND}" -G "${GENERATOR}" "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_C_COMPILER=${C_COMPILER}"
    "-DCMAKE_BUILD_TYPE=${TYPE}" "-DCMAKE_PREFIX_PATH=${SCRATCH}/installed")

# A project that wants core only must not need CGAL or HDF5: here it cannot find them.
run(${configure} -S "${SOURCE}/core_only" -B "${SCRATCH}/core_only"
    -DCMAKE_DISABLE_FIND_PACKAGE_CGAL=ON -DCMAKE_DISABLE_FIND_PACKAGE_HDF5=ON)
run("${CMAKE_COMMAND}" --build "${SCRATCH}/core_only")
run("${SCRATCH}/core_only/core_only")

# page_program(PAGE OUTPUT ARGUMENT...): the program that a page shows, as it stands there, prints OUTPUT. The page that
# shows CMakeLists.txt comes first.
function(page_program page output)
  file(READ "${ROOT}/docs/how-to/${page}.md" text)
  foreach(name CMakeLists.txt main.cpp)
    if(text MATCHES "```[a-z]+ file=${name}\n([^`]+)```")
      file(WRITE "${SCRATCH}/page/${name}" "${CMAKE_MATCH_1}")
    endif()
  endforeach()
  run(${configure} -S "${SCRATCH}/page" -B "${SCRATCH}/page/build")
  run("${CMAKE_COMMAND}" --build "${SCRATCH}/page/build")
  execute_process(COMMAND "${SCRATCH}/page/build/my_program" ${ARGN} OUTPUT_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
  if(NOT said MATCHES "${output}")
    message(FATAL_ERROR "the program of ${page} printed:\n${said}")
  endif()
endfunction()
page_program(library-from-cmake "^-?[0-9]+\\.[0-9]+ [0-9]+\\.[0-9]+\n")
page_program(measured-curve "^backlash 5\\.185 arcmin\n" "${ROOT}/data/measured/torque-twist.csv")

# The switch used above does hide HDF5: without it io must be refused, and say so.
execute_process(COMMAND ${configure} -S "${SCRATCH}/page" -B "${SCRATCH}/refused" -DCMAKE_DISABLE_FIND_PACKAGE_HDF5=ON
                RESULT_VARIABLE failed OUTPUT_VARIABLE said ERROR_VARIABLE said)
if(NOT failed OR NOT said MATCHES "HDF5")
  message(FATAL_ERROR "hdconj::io was found without HDF5:\n${said}")
endif()
