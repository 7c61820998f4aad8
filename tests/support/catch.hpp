// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Catch2, whichever of its two layouts is installed: version 3, or Debian's 2.13.
#pragma once

#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
using Catch::Approx;
using Catch::Matchers::ContainsSubstring;
#else
#include <catch2/catch.hpp>
using Catch::Matchers::Contains;

/// The name that version 3 gave to its matcher for text.
inline auto ContainsSubstring(std::string const& part)
{
    return Contains(part);
}
#endif
