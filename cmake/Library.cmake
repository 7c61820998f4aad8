# SPDX-License-Identifier: GPL-3.0-or-later
#   hdconj_library(<name> SOURCES <files> PUBLIC <libraries> PRIVATE <libraries>)
# Adds hdconj_<name> with the alias hdconj::<name>, the name that an installed package uses too.
function(hdconj_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;PUBLIC;PRIVATE")
  set(target hdconj_${name})
  add_library(${target} ${arg_SOURCES})
  add_library(hdconj::${name} ALIAS ${target})
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_include_directories(${target}
    PUBLIC "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>" "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>"
    PRIVATE "${PROJECT_SOURCE_DIR}/src")
  target_link_libraries(${target} PUBLIC ${arg_PUBLIC} PRIVATE ${arg_PRIVATE})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} VERSION ${PROJECT_VERSION} SOVERSION 0
                        POSITION_INDEPENDENT_CODE ON)
endfunction()
