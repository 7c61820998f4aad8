# SPDX-License-Identifier: GPL-3.0-or-later
# Turns a text file into a C++ source that defines it as a string_view.
#   hdconj_embed_text(<text file> <C++ file> <header that declares it> <namespace> <name>)
# The C++ file is made at build time and made again when the text is edited.
# This file is also the script that the build step runs.
if(CMAKE_SCRIPT_MODE_FILE)
  file(READ "${TEXT}" text)
  if(text MATCHES "\\)embedded\"")
    message(FATAL_ERROR "${TEXT} contains the mark that ends the embedded text")
  endif()
  file(WRITE "${SOURCE}"
"// Generated from ${LABEL}; edit that file.
#include \"${HEADER}\"
namespace ${NAMESPACE} {
constinit std::string_view const ${NAME} = R\"embedded(${text})embedded\";
}  // namespace ${NAMESPACE}
")
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
