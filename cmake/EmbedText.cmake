# SPDX-License-Identifier: GPL-3.0-or-later
# Turns text files into C++ sources that define them as string_views.
#   hdconj_embed_text(<text file> <C++ file> <header that declares it> <namespace> <name>)
#   hdconj_embed_table(<C++ file> <header that declares it> <namespace> <row type> <name> <text files>...)
# The second one defines a span <name> of rows {file name without ending, text}.
# The C++ file is made at build time and made again when a text is edited.
# This file is also the script that the build step runs.
if(CMAKE_SCRIPT_MODE_FILE)
  function(read_literal file result)
    file(READ "${file}" text)
    if(text MATCHES "\\)embedded\"")
      message(FATAL_ERROR "${file} contains the mark that ends the embedded text")
    endif()
    set(${result} "R\"embedded(${text})embedded\"" PARENT_SCOPE)
  endfunction()

  set(head "// Generated from ${LABEL}; edit that.
#include \"${HEADER}\"
namespace ${NAMESPACE} {
")
  set(tail "}  // namespace ${NAMESPACE}
")
  if(ROW)
    string(REPLACE "|" ";" files "${TEXT}")
    foreach(file IN LISTS files)
      get_filename_component(stem "${file}" NAME_WLE)
      read_literal("${file}" literal)
      string(APPEND rows "    {\"${stem}\", ${literal}},\n")
    endforeach()
    file(WRITE "${SOURCE}" "${head}static constexpr ${ROW} ${NAME}_rows[] = {
${rows}};
constinit std::span<${ROW} const> const ${NAME}{${NAME}_rows};
${tail}")
  else()
    read_literal("${TEXT}" literal)
    file(WRITE "${SOURCE}" "${head}constinit std::string_view const ${NAME} = ${literal};
${tail}")
  endif()
  return()
endif()

set(HDCONJ_EMBED_TEXT "${CMAKE_CURRENT_LIST_FILE}")

function(hdconj_embed_text text source header namespace name)
  file(RELATIVE_PATH label "${PROJECT_SOURCE_DIR}" "${text}")
  add_custom_command(
    OUTPUT "${source}"
    COMMAND "${CMAKE_COMMAND}" -D "TEXT=${text}" -D "SOURCE=${source}" -D "HEADER=${header}"
            -D "NAMESPACE=${namespace}" -D "NAME=${name}" -D "LABEL=${label}" -P "${HDCONJ_EMBED_TEXT}"
    DEPENDS "${text}" "${HDCONJ_EMBED_TEXT}"
    COMMENT "Embedding ${label}"
    VERBATIM)
endfunction()

function(hdconj_embed_table source header namespace row name)
  list(GET ARGN 0 first)
  get_filename_component(folder "${first}" DIRECTORY)
  file(RELATIVE_PATH label "${PROJECT_SOURCE_DIR}" "${folder}")
  list(JOIN ARGN "|" texts)
  add_custom_command(
    OUTPUT "${source}"
    COMMAND "${CMAKE_COMMAND}" -D "TEXT=${texts}" -D "SOURCE=${source}" -D "HEADER=${header}"
            -D "NAMESPACE=${namespace}" -D "ROW=${row}" -D "NAME=${name}" -D "LABEL=${label}"
            -P "${HDCONJ_EMBED_TEXT}"
    DEPENDS ${ARGN} "${HDCONJ_EMBED_TEXT}"
    COMMENT "Embedding texts of ${label}"
    VERBATIM)
endfunction()
