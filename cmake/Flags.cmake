# SPDX-License-Identifier: GPL-3.0-or-later
# Flags for everything below the top folder; nothing here reaches a consumer of the library.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_CXX_FLAGS_RELEASE "-O3 -DNDEBUG" CACHE STRING "Flags of Release")
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_INSTALL_RPATH "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")

# No fused multiply-add: results must not depend on which products a compiler chooses to fuse.
add_compile_options(-ffp-contract=off)

add_compile_options(-Wall -Wextra -Wpedantic -Wshadow -Wconversion)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC 12 sees overlaps and overflows in std::string's operator+ that are not there. The sanitizers see real ones.
  add_compile_options(-Wno-restrict -Wno-stringop-overflow -Wno-array-bounds)
  if(HDCONJ_RARE_COLLECTION)  # no effect on what is compiled
    add_compile_options("SHELL:--param ggc-min-expand=300" "SHELL:--param ggc-min-heapsize=1000000")
  endif()
endif()
if(HDCONJ_WERROR)
  add_compile_options(-Werror)
endif()

if(HDCONJ_SANITIZE)
  add_compile_options(-fsanitize=${HDCONJ_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${HDCONJ_SANITIZE})
endif()

if(HDCONJ_BUILD_FUZZ)
  add_compile_options(-fsanitize=fuzzer-no-link)  # libFuzzer is led by which lines of the libraries an input reaches
endif()
