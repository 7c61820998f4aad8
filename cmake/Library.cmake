# SPDX-License-Identifier: GPL-3.0-or-later
#   hdconj_library(<name> SOURCES <files> PUBLIC <libraries> PRIVATE <libraries> [PARTS <number>]
#                  [OPTIONS <of the compiler>] [PRECOMPILED <headers>] [PRECOMPILED_AS <library>])
# Adds hdconj_<name> with the alias hdconj::<name>, the name that an installed package uses too. A unity build
# (HDCONJ_UNITY) compiles the sources in that many parts (1) and precompiles the headers, or uses those of another
# library with the same flags; an ordinary build does not, so that it finds each missing #include.
function(hdconj_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "PARTS;PRECOMPILED_AS" "SOURCES;PUBLIC;PRIVATE;OPTIONS;PRECOMPILED")
  set(target hdconj_${name})
  add_library(${target} ${arg_SOURCES})
  add_library(hdconj::${name} ALIAS ${target})
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_include_directories(${target}
    PUBLIC "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>" "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>"
    PRIVATE "${PROJECT_SOURCE_DIR}/src")
  target_link_libraries(${target} PUBLIC ${arg_PUBLIC} PRIVATE ${arg_PRIVATE})
  target_compile_options(${target} PRIVATE ${arg_OPTIONS})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} VERSION ${PROJECT_VERSION} SOVERSION 0
                        POSITION_INDEPENDENT_CODE ON
                        UNITY_BUILD ${HDCONJ_UNITY} UNITY_BUILD_MODE GROUP)
  hdconj_unity_parts("${arg_PARTS}" ${arg_SOURCES})
  if(HDCONJ_UNITY AND arg_PRECOMPILED)
    target_precompile_headers(${target} PRIVATE ${arg_PRECOMPILED})
  elseif(HDCONJ_UNITY AND arg_PRECOMPILED_AS)
    target_precompile_headers(${target} REUSE_FROM hdconj_${arg_PRECOMPILED_AS})
  endif()
endfunction()

# Groups the sources of this folder in parts of about the same size, in their order: neighbours share headers and the
# templates that they instantiate, which is most of a compilation. Generated ones stay alone.
function(hdconj_unity_parts parts)
  if(NOT parts)
    set(parts 1)
  endif()
  set(total 0)
  foreach(source IN LISTS ARGN)
    if(NOT IS_ABSOLUTE "${source}")
      file(SIZE "${CMAKE_CURRENT_SOURCE_DIR}/${source}" size)
      math(EXPR total "${total} + ${size}")
      list(APPEND sources "${source}")
      list(APPEND ends "${total}")
    endif()
  endforeach()
  foreach(source end IN ZIP_LISTS sources ends)
    math(EXPR part "(${end} - 1) * ${parts} / ${total}")
    set_source_files_properties("${source}" PROPERTIES UNITY_GROUP "${part}")
  endforeach()
endfunction()
