# SPDX-License-Identifier: GPL-3.0-or-later
# Every library that hdconj uses. Debian's names are in debian-packages.txt.
set(CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE ON)  # our own build types are no news to CGAL
if(POLICY CMP0167)  # Boost's own configuration, for CGAL too: newer CMakes have no module for it
  cmake_policy(SET CMP0167 NEW)
  set(CMAKE_POLICY_DEFAULT_CMP0167 NEW)
endif()

find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(OpenMP REQUIRED COMPONENTS CXX)
find_package(GSL REQUIRED)
find_package(Boost 1.74 REQUIRED)
find_package(fmt REQUIRED)
find_package(CGAL 5.5 REQUIRED)
find_package(HDF5 REQUIRED COMPONENTS C)
find_package(ZLIB REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(nlohmann_json REQUIRED)
if(HDCONJ_BUILD_PROGRAM)
  find_package(CLI11 REQUIRED)
endif()

# Debian's shared HDF5 brings forty libraries with it, for a file system over the network that nothing here uses;
# loading them takes longer than most of what `solve` does. Its archive, from the same package, needs two of them.
option(HDCONJ_HDF5_ARCHIVE "Link HDF5 from its archive where there is one" ON)
add_library(hdconj_hdf5 INTERFACE)
set(hdconj_hdf5_archive_works NO)
if(HDCONJ_HDF5_ARCHIVE AND NOT BUILD_SHARED_LIBS)  # it is not compiled for shared libraries
  find_library(HDCONJ_HDF5_FILE NAMES libhdf5_serial.a libhdf5.a)
  find_library(HDCONJ_SZ sz)
  find_library(HDCONJ_Z z)
  mark_as_advanced(HDCONJ_HDF5_FILE HDCONJ_SZ HDCONJ_Z)
  if(HDCONJ_HDF5_FILE AND HDCONJ_SZ AND HDCONJ_Z)
    include(CheckCSourceCompiles)
    set(CMAKE_REQUIRED_INCLUDES ${HDF5_C_INCLUDE_DIRS})
    set(CMAKE_REQUIRED_LIBRARIES "${HDCONJ_HDF5_FILE}" "${HDCONJ_SZ}" "${HDCONJ_Z}" m ${CMAKE_DL_LIBS})
    check_c_source_compiles("#include <hdf5.h>\nint main(void) { return H5open() < 0; }" HDCONJ_HDF5_ARCHIVE_LINKS)
    unset(CMAKE_REQUIRED_INCLUDES)
    unset(CMAKE_REQUIRED_LIBRARIES)
    set(hdconj_hdf5_archive_works ${HDCONJ_HDF5_ARCHIVE_LINKS})
  endif()
endif()
if(hdconj_hdf5_archive_works)
  target_include_directories(hdconj_hdf5 SYSTEM INTERFACE ${HDF5_C_INCLUDE_DIRS})
  target_compile_definitions(hdconj_hdf5 INTERFACE ${HDF5_C_DEFINITIONS})
  target_link_libraries(hdconj_hdf5 INTERFACE "${HDCONJ_HDF5_FILE}" "${HDCONJ_SZ}" "${HDCONJ_Z}" m ${CMAKE_DL_LIBS})
else()
  target_link_libraries(hdconj_hdf5 INTERFACE HDF5::HDF5)
endif()

# GNU's OpenMP reads how long its threads spin when it is loaded, which is before a program that shares it can say
# anything (apps/hdconj/threads.cpp). Its archive comes with the compiler.
option(HDCONJ_OPENMP_ARCHIVE "Link GNU's OpenMP from its archive where there is one" ON)
add_library(hdconj_openmp INTERFACE)
# Eigen's products would take threads of their own, whatever the scene says, and how they are cut, hence their last
# bits, depends on how many.
target_compile_definitions(hdconj_openmp INTERFACE EIGEN_DONT_PARALLELIZE)
set(hdconj_openmp_file "")
if(HDCONJ_OPENMP_ARCHIVE AND NOT BUILD_SHARED_LIBS AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  execute_process(COMMAND "${CMAKE_CXX_COMPILER}" -print-file-name=libgomp.a
                  OUTPUT_VARIABLE hdconj_openmp_file OUTPUT_STRIP_TRAILING_WHITESPACE)
endif()
if(IS_ABSOLUTE "${hdconj_openmp_file}" AND EXISTS "${hdconj_openmp_file}")
  find_package(Threads REQUIRED)
  target_compile_options(hdconj_openmp INTERFACE ${OpenMP_CXX_FLAGS})
  # A module that Python loads cannot take the archive, whose code is that of programs.
  target_link_libraries(hdconj_openmp INTERFACE
    "$<IF:$<STREQUAL:$<TARGET_PROPERTY:TYPE>,MODULE_LIBRARY>,gomp,${hdconj_openmp_file}>"
    Threads::Threads ${CMAKE_DL_LIBS})
else()
  target_link_libraries(hdconj_openmp INTERFACE OpenMP::OpenMP_CXX)
endif()
