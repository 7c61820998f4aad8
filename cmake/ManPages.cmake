# SPDX-License-Identifier: GPL-3.0-or-later
# Script that writes the manual pages, one of the program and one of each verb:
#   cmake -DPROGRAM=<hdconj> -DHELP2MAN=<help2man> -DFOLDER=<folder> -P ManPages.cmake
execute_process(COMMAND "${PROGRAM}" --help OUTPUT_VARIABLE help COMMAND_ERROR_IS_FATAL ANY)
string(REGEX REPLACE "^.*\nSubcommands:\n" "" list "${help}")
string(REGEX REPLACE "\n\n.*$" "" list "${list}")
string(REPLACE ";" "," list "${list}")
string(REPLACE "\n" ";" list "${list}")
file(MAKE_DIRECTORY "${FOLDER}")

# man_page(<file> <what> <option that prints the help>)
function(man_page page what help_option)
  execute_process(COMMAND "${HELP2MAN}" --no-info "--name=${what}" "--help-option=${help_option}"
                          --version-option=--version "--output=${FOLDER}/${page}.1" "${PROGRAM}"
                  COMMAND_ERROR_IS_FATAL ANY)
endfunction()

man_page(hdconj "conjugate tooth profiles of harmonic drives" --help)
foreach(line IN LISTS list)
  if(line MATCHES "^  ([a-z]+) +(.+)$")
    man_page("hdconj-${CMAKE_MATCH_1}" "${CMAKE_MATCH_2}" "${CMAKE_MATCH_1} --help")
  endif()
endforeach()
