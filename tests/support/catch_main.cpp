// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// main() of the test programs. Catch2 2 makes it here; Catch2 3 brings its own, and this file stays empty.
#if !__has_include(<catch2/catch_all.hpp>)
#define CATCH_CONFIG_MAIN
#include <catch2/catch.hpp>
#endif
