# SPDX-License-Identifier: GPL-3.0-or-later
# Install rules. One export file per component, so that find_package(hdconj COMPONENTS core) asks for nothing that
# core does not need.
include(CMakePackageConfigHelpers)
set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/hdconj")

install(DIRECTORY "${PROJECT_SOURCE_DIR}/include/" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}"
        FILES_MATCHING PATTERN "*.hpp")
foreach(component scene core region physics solve accuracy io files all)
  install(TARGETS hdconj_${component} EXPORT hdconj-${component})
  install(EXPORT hdconj-${component} NAMESPACE hdconj:: DESTINATION "${package_dir}")
endforeach()
if(TARGET hdconj)
  install(TARGETS hdconj)
  install(FILES "${PROJECT_SOURCE_DIR}/data/completion/hdconj.bash"
          DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions" RENAME hdconj)
  # The manual pages are the program's own help, so they are made where the program runs.
  find_program(HDCONJ_HELP2MAN help2man)
  mark_as_advanced(HDCONJ_HELP2MAN)
  if(HDCONJ_HELP2MAN AND NOT CMAKE_CROSSCOMPILING)
    install(CODE "execute_process(COMMAND \"${CMAKE_COMMAND}\" \"-DPROGRAM=$<TARGET_FILE:hdconj>\"
      \"-DHELP2MAN=${HDCONJ_HELP2MAN}\" \"-DFOLDER=${PROJECT_BINARY_DIR}/man\"
      -P \"${PROJECT_SOURCE_DIR}/cmake/ManPages.cmake\" COMMAND_ERROR_IS_FATAL ANY)")
    install(DIRECTORY "${PROJECT_BINARY_DIR}/man/" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1")
  endif()
endif()
install(DIRECTORY "${PROJECT_SOURCE_DIR}/data/scenes" DESTINATION "${CMAKE_INSTALL_DATADIR}/hdconj"
        FILES_MATCHING PATTERN "*.toml")

configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/hdconjConfig.cmake.in"
  "${PROJECT_BINARY_DIR}/hdconjConfig.cmake" INSTALL_DESTINATION "${package_dir}" NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file("${PROJECT_BINARY_DIR}/hdconjConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/hdconjConfig.cmake" "${PROJECT_BINARY_DIR}/hdconjConfigVersion.cmake"
        DESTINATION "${package_dir}")
