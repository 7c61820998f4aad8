// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Catch2, whichever of its two layouts is installed: version 3, or Debian's 2.13.
#pragma once

#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
using Catch::Approx;
using Catch::Matchers::Contains;
#else
#include <catch2/catch.hpp>
#endif
