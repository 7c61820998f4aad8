// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What is fuzzed. A target takes any bytes, runs a part of the program on them and throws Find when the program does
/// what it must not do; a crash, another exception or more than 10 s is a find as well.
///
/// The same functions run under libFuzzer (entry.cpp) and over the stored inputs in the tests (replay.cpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace hdconj::fuzz {

using Bytes = std::span<std::uint8_t const>;

/// Something the program must not do.
struct Find : std::logic_error
{
    using std::logic_error::logic_error;
};

/// A scene as text: read, judged, planned. Lines after the first NUL byte are --set overrides.
void scene_text(Bytes input);

/// A file of points, for each family of teeth and wave generators that reads one: a first line "FAMILY key=word ..."
/// and then the file. The family is built, nothing is solved.
void csv_profile(Bytes input);

/// Wishes of a designer, a line "wish value" each: judged, and without a fault made into a scene that is read back.
/// Nothing is searched or solved.
void design_wishes(Bytes input);

/// A file of measured points, as CSV and as DXF: read, and laid on the built-in flexspline by each registration.
void point_file(Bytes input);

/// A drive (drive_text.hpp) through `solve`.
void scene_solve(Bytes input);

[[nodiscard]] inline std::string_view text_of(Bytes input)
{
    return {reinterpret_cast<char const*>(input.data()), input.size()};
}

}  // namespace hdconj::fuzz
