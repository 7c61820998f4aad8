# SPDX-License-Identifier: GPL-3.0-or-later
# Targets that build no program and need tools that only developers have:
#   docs   the reference of the public headers, in docs/html of the build; a warning is an error
#   tidy   clang-tidy over all sources, for builds by HDCONJ_UNITY=OFF: clang does not read headers that g++ has
#          precompiled; HDCONJ_TIDY=<regular expression> chooses among them
set(HDCONJ_TIDY "." CACHE STRING "Sources that the target tidy checks")

# hdconj_tool_target(<target> <tool> <command>...): fails with a word of help where the tool is missing
function(hdconj_tool_target target tool)
  string(MAKE_C_IDENTIFIER "HDCONJ_${target}_TOOL" variable)
  find_program(${variable} NAMES ${tool} ${tool}-14)
  mark_as_advanced(${variable})
  if(${variable})
    add_custom_target(${target} COMMAND "${${variable}}" ${ARGN} VERBATIM USES_TERMINAL)
  else()
    add_custom_target(${target} COMMAND "${CMAKE_COMMAND}" -E echo
                              "${tool} is missing: cmake/debian-packages.txt, [docs]"
                      COMMAND "${CMAKE_COMMAND}" -E false VERBATIM)
  endif()
endfunction()

configure_file("${PROJECT_SOURCE_DIR}/docs/Doxyfile.in" "${PROJECT_BINARY_DIR}/docs/Doxyfile" @ONLY)
hdconj_tool_target(docs doxygen "${PROJECT_BINARY_DIR}/docs/Doxyfile")
hdconj_tool_target(tidy run-clang-tidy -quiet -p "${PROJECT_BINARY_DIR}" -extra-arg=-Wno-unknown-warning-option
                   "${HDCONJ_TIDY}")
