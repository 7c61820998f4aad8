# SPDX-License-Identifier: GPL-3.0-or-later
#   hdconj_version_source(<C++ file> <dependencies>...)
# Writes version, git revision and compiler into a C++ source at build time. The revision is read again whenever
# HEAD moves or one of the dependencies (the program's other parts) is rebuilt, so that "-dirty" tells the truth
# without a step that runs in every build.
# This file is also the script that the build step runs.
if(CMAKE_SCRIPT_MODE_FILE)
  set(GIT_REVISION unknown)
  if(GIT)
    # Sources unpacked inside somebody else's checkout must not report that checkout's revision.
    execute_process(COMMAND "${GIT}" rev-parse --show-prefix WORKING_DIRECTORY "${SOURCE_DIR}"
                    OUTPUT_VARIABLE prefix OUTPUT_STRIP_TRAILING_WHITESPACE RESULT_VARIABLE failed ERROR_QUIET)
    if(NOT failed AND prefix STREQUAL "")
      execute_process(COMMAND "${GIT}" describe --always --dirty --tags WORKING_DIRECTORY "${SOURCE_DIR}"
                      OUTPUT_VARIABLE described OUTPUT_STRIP_TRAILING_WHITESPACE RESULT_VARIABLE failed ERROR_QUIET)
      if(NOT failed)
        set(GIT_REVISION "${described}")
      endif()
    endif()
  endif()
  configure_file("${TEMPLATE}" "${SOURCE}" @ONLY)
  return()
endif()

set(HDCONJ_VERSION_SCRIPT "${CMAKE_CURRENT_LIST_FILE}")
set(HDCONJ_VERSION_TEMPLATE "${CMAKE_CURRENT_LIST_DIR}/version.cpp.in")

function(hdconj_version_source source)
  find_program(HDCONJ_GIT git)
  set(git "")
  set(head "")
  if(HDCONJ_GIT)
    set(git "${HDCONJ_GIT}")
    # The log of HEAD changes with every commit and checkout; also right in a linked work tree.
    execute_process(COMMAND "${git}" rev-parse --git-path logs/HEAD WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}"
                    OUTPUT_VARIABLE head OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    if(head)
      file(REAL_PATH "${head}" head BASE_DIRECTORY "${PROJECT_SOURCE_DIR}")
    endif()
    if(NOT EXISTS "${head}")
      set(head "")
    endif()
  endif()

  string(TOUPPER "${CMAKE_BUILD_TYPE}" type)
  get_directory_property(options COMPILE_OPTIONS)
  list(FILTER options EXCLUDE REGEX "^-W|^SHELL:--param ggc")  # neither changes what is compiled
  list(JOIN options " " options)
  set(build "${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}, ${CMAKE_BUILD_TYPE}, \
${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${type}} ${options}")
  string(REGEX REPLACE " +" " " build "${build}")

  add_custom_command(
    OUTPUT "${source}"
    COMMAND "${CMAKE_COMMAND}" -D "GIT=${git}" -D "SOURCE_DIR=${PROJECT_SOURCE_DIR}"
            -D "TEMPLATE=${HDCONJ_VERSION_TEMPLATE}" -D "SOURCE=${source}" -D "VERSION=${PROJECT_VERSION}"
            -D "BUILD=${build}" -P "${HDCONJ_VERSION_SCRIPT}"
    DEPENDS "${HDCONJ_VERSION_SCRIPT}" "${HDCONJ_VERSION_TEMPLATE}" ${head} ${ARGN}
    COMMENT "Reading the revision"
    VERBATIM)
endfunction()
