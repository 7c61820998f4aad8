# SPDX-License-Identifier: GPL-3.0-or-later
# ccache and a fast linker: shorter builds, the same program.
if(NOT HDCONJ_FAST_TOOLS)
  return()
endif()

find_program(HDCONJ_CCACHE ccache)
if(HDCONJ_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # Without this sloppiness ccache passes by every file that uses a precompiled header (the tests).
  set(CMAKE_CXX_COMPILER_LAUNCHER
      "${CMAKE_COMMAND}" -E env "CCACHE_SLOPPINESS=pch_defines,time_macros" "${HDCONJ_CCACHE}")
endif()

find_program(HDCONJ_LINKER NAMES mold ld.lld)
if(HDCONJ_LINKER MATCHES "mold$")
  add_link_options(-fuse-ld=mold)
elseif(HDCONJ_LINKER)
  add_link_options(-fuse-ld=lld)
endif()
