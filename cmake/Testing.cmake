# SPDX-License-Identifier: GPL-3.0-or-later
#   hdconj_tests(<folder> [PARALLEL] [RUNS_PROGRAM] TIMEOUT <seconds> SOURCES <files>)
# One Catch2 program; each test case becomes a test with the folder's name as label. With HDCONJ_UNITY the files of a
# room (<folder>/<room>/...), or else eight at a time, are compiled together: their names must be unique.
# PARALLEL: the folder has test cases with the Catch tag [parallel]. They run together as one test that carries the
# label `parallel` too, for the thread sanitizer: ctest -L parallel.
# RUNS_PROGRAM: the tests mostly run the program; they are compiled without optimisation, in two thirds of the time.
find_package(Catch2 REQUIRED)
include(Catch)
set(HDCONJ_TIMEOUT_FACTOR 1 CACHE STRING "Test timeouts times this; sanitizers are slow")
set(hdconj_timeout_factor ${HDCONJ_TIMEOUT_FACTOR})
if(DEFINED ENV{HDCONJ_FULL})  # all drives and points that there are, and every kill twenty times
  math(EXPR hdconj_timeout_factor "24 * ${HDCONJ_TIMEOUT_FACTOR}")
endif()

# A python that can read our files: users often have another python first in their path.
function(hdconj_reads_results result candidate)
  execute_process(COMMAND "${candidate}" -c "import h5py, ezdxf" RESULT_VARIABLE failed OUTPUT_QUIET ERROR_QUIET)
  if(failed)
    set(${result} FALSE PARENT_SCOPE)
  endif()
endfunction()
find_program(HDCONJ_PYTHON NAMES python3 python VALIDATOR hdconj_reads_results
             DOC "A python that has h5py and ezdxf")
if(NOT HDCONJ_PYTHON)
  message(WARNING "No python with h5py and ezdxf: tests that read results with other programs will be skipped")
endif()

# What every test may use: the libraries, the private headers, where things are.
add_library(hdconj_test_setup INTERFACE)
target_link_libraries(hdconj_test_setup INTERFACE hdconj::hdconj Catch2::Catch2 hdconj_hdf5 Boost::headers
                      nlohmann_json::nlohmann_json)
target_include_directories(hdconj_test_setup INTERFACE "${PROJECT_SOURCE_DIR}/tests" "${PROJECT_SOURCE_DIR}/src")
target_compile_definitions(hdconj_test_setup INTERFACE
  HDCONJ_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
  HDCONJ_PROGRAM="$<$<BOOL:${HDCONJ_BUILD_PROGRAM}>:${PROJECT_BINARY_DIR}/bin/hdconj>"
  HDCONJ_PYTHON="$<$<BOOL:${HDCONJ_PYTHON}>:${HDCONJ_PYTHON}>")

# Catch2's macros take long to optimise, and what has to be fast is compiled with the libraries.
set(hdconj_test_options $<$<NOT:$<CONFIG:Debug>>:-O1>)

# Said by tests that lack a program (tests/support/not_tried.hpp): ctest reports them as skipped.
set(hdconj_not_tried SKIP_REGULAR_EXPRESSION "NOT TRIED: ")

# main(), once for all programs, and the precompiled Catch2 for those that are optimised.
add_library(hdconj_test_main OBJECT ${main})
target_link_libraries(hdconj_test_main PRIVATE hdconj_test_setup)
target_compile_options(hdconj_test_main PRIVATE ${hdconj_test_options})
target_precompile_headers(hdconj_test_main PRIVATE support/catch.hpp)
set_source_files_properties(support/catch_main.cpp PROPERTIES SKIP_PRECOMPILE_HEADERS ON)

# Tests run side by side: a thread that waits for its next loop must not keep the processor from another test
# (apps/hdconj/threads.cpp).
set(hdconj_test_spin "GOMP_SPINCOUNT=3000")
set(HDCONJ_TEST_ENVIRONMENT "${hdconj_test_spin}")
# libomp tells the thread sanitizer what it synchronises, but its own locks look like races.
if(HDCONJ_SANITIZE STREQUAL "thread")
  list(APPEND HDCONJ_TEST_ENVIRONMENT "TSAN_OPTIONS=ignore_noninstrumented_modules=1")
endif()

# What `ctest -L parallel` needs, without the rest: for a build that runs nothing else.
add_custom_target(parallel_tests)
if(TARGET hdconj)
  add_dependencies(parallel_tests hdconj)
endif()

# Which test files are compiled together.
function(hdconj_group_tests program)
  set_target_properties(${program} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  set(number 0)
  foreach(source IN LISTS ARGN)
    if(source MATCHES "^[^/]+/([^/]+)/")
      set(group ${CMAKE_MATCH_1})
    else()
      math(EXPR group "${number} / 8")
      math(EXPR number "${number} + 1")
    endif()
    set_property(SOURCE ${source} PROPERTY UNITY_GROUP ${group})
  endforeach()
endfunction()

function(hdconj_tests folder)
  cmake_parse_arguments(PARSE_ARGV 1 arg "PARALLEL;RUNS_PROGRAM" "TIMEOUT" "SOURCES")
  math(EXPR timeout "${arg_TIMEOUT} * ${hdconj_timeout_factor}")
  set(program ${folder}_tests)
  add_executable(${program} ${arg_SOURCES} $<TARGET_OBJECTS:hdconj_test_main>)
  target_link_libraries(${program} PRIVATE hdconj_test_setup)
  if(arg_RUNS_PROGRAM)
    target_compile_options(${program} PRIVATE $<$<NOT:$<CONFIG:Debug>>:-O0>)
    target_precompile_headers(${program} PRIVATE support/catch.hpp)
  else()
    target_compile_options(${program} PRIVATE ${hdconj_test_options})
    target_precompile_headers(${program} REUSE_FROM hdconj_test_main)
  endif()
  if(TARGET hdconj)  # to run, not to compile: the compiler need not wait for it
    set_property(TARGET ${program} PROPERTY LINK_DEPENDS "$<TARGET_FILE:hdconj>")
  endif()
  if(HDCONJ_UNITY)
    hdconj_group_tests(${program} ${arg_SOURCES})
  endif()

  set(which "~[.]")  # hidden test cases, such as timings, are run by hand
  # A name that CMake cuts in two runs nothing, which must not pass.
  set(strict "")
  if(Catch2_VERSION VERSION_LESS 3)
    set(strict --warn NoTests)  # version 3 refuses to run nothing without being told
  endif()
  if(arg_PARALLEL)
    add_dependencies(parallel_tests ${program})
    set(which "~[.]~[parallel]")
    add_test(NAME ${folder}.parallel COMMAND ${program} "[parallel]" ${strict})
    set_tests_properties(${folder}.parallel PROPERTIES LABELS "${folder};parallel" TIMEOUT ${timeout}
                                                              ENVIRONMENT "${HDCONJ_TEST_ENVIRONMENT}"
                                                              ${hdconj_not_tried})
  endif()
  catch_discover_tests(${program} TEST_SPEC "${which}" TEST_PREFIX "${folder}." EXTRA_ARGS ${strict}
                       PROPERTIES LABELS ${folder} TIMEOUT ${timeout} ENVIRONMENT ${hdconj_test_spin}
                                  ${hdconj_not_tried})
endfunction()
