// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A result file as the beginning of another verb's work.
#pragma once

#include <filesystem>
#include <string>

#include "hdconj/pipeline/solution.hpp"

namespace hdconj {

/// What later work needs of a result file.
struct StoredOutline
{
    std::string scene;              ///< text of the scene that was solved, after --set
    CircularSplineOutline outline;  ///< bit for bit as it was written
};

/// Reads what write_hdf5 wrote of the circular spline, of `solve` and of `contact`.
/// @throws InputError where @p file is none of our results, or its parts contradict each other
[[nodiscard]] StoredOutline read_outline(std::filesystem::path const& file);

}  // namespace hdconj
