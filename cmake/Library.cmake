# SPDX-License-Identifier: GPL-3.0-or-later
#   hdconj_room(<name> [PARTS <number>] SOURCES <files>...)
# The sources of a room, in the variable of that name. A unity build (HDCONJ_UNITY) compiles them together, those of a
# large room in several parts of about the same length, so that no single compilation outlasts the others.
function(hdconj_room name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "PARTS" "SOURCES")
  set(${name} ${arg_SOURCES} PARENT_SCOPE)
  if(NOT arg_PARTS)
    set(arg_PARTS 1)
  endif()
  list(LENGTH arg_SOURCES count)
  set(index 0)
  foreach(source IN LISTS arg_SOURCES)
    math(EXPR part "${index} * ${arg_PARTS} / ${count}")
    set_source_files_properties("${source}" PROPERTIES UNITY_GROUP "${name}_${part}")
    math(EXPR index "${index} + 1")
  endforeach()
endfunction()

#   hdconj_library(<name> SOURCES <files> PUBLIC <libraries> PRIVATE <libraries> [PRECOMPILED <headers>]
#                  [PRECOMPILED_AS <library>])
# Adds hdconj_<name> with the alias hdconj::<name>, the name that an installed package uses too. A unity build
# precompiles the headers, or uses those of another library with the same flags; an ordinary build does not, so that it
# finds each missing #include.
function(hdconj_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "PRECOMPILED_AS" "SOURCES;PUBLIC;PRIVATE;PRECOMPILED")
  set(target hdconj_${name})
  add_library(${target} ${arg_SOURCES})
  add_library(hdconj::${name} ALIAS ${target})
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_include_directories(${target}
    PUBLIC "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>" "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>"
    PRIVATE "${PROJECT_SOURCE_DIR}/src")
  target_link_libraries(${target} PUBLIC ${arg_PUBLIC} PRIVATE ${arg_PRIVATE})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} VERSION ${PROJECT_VERSION} SOVERSION 0
                        POSITION_INDEPENDENT_CODE ON
                        UNITY_BUILD ${HDCONJ_UNITY} UNITY_BUILD_MODE GROUP)
  if(HDCONJ_UNITY AND arg_PRECOMPILED)
    target_precompile_headers(${target} PRIVATE ${arg_PRECOMPILED})
  elseif(HDCONJ_UNITY AND arg_PRECOMPILED_AS)
    target_precompile_headers(${target} REUSE_FROM hdconj_${arg_PRECOMPILED_AS})
  endif()
endfunction()
