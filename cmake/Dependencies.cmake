# SPDX-License-Identifier: GPL-3.0-or-later
# Every library that hdconj uses. Debian's names are in debian-packages.txt.
set(CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE ON)  # our own build types are no news to CGAL

find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(OpenMP REQUIRED COMPONENTS CXX)
find_package(GSL REQUIRED)
find_package(Boost 1.74 REQUIRED)
find_package(fmt REQUIRED)
find_package(CGAL 5.5 REQUIRED)
find_package(HDF5 REQUIRED COMPONENTS C)
find_package(tomlplusplus REQUIRED)
find_package(nlohmann_json REQUIRED)
if(HDCONJ_BUILD_PROGRAM)
  find_package(CLI11 REQUIRED)
endif()
