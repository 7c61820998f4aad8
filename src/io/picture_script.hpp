// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The picture of a solution as a gnuplot script; private to src/io.
#pragma once

#include <string>

#include "hdconj/pipeline/solution.hpp"

namespace hdconj {

enum class PictureFormat
{
    svg,
    png
};

/// Script with all its data, drawing to standard output.
[[nodiscard]] std::string picture_script(Solution const& solution, PictureFormat format);

}  // namespace hdconj
