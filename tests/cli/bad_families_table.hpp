// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Parameters of tooth families that must be refused: rows of the form of bad_scenes_table, each an edit of the
/// family's own scene in data/scenes.
#pragma once

#include "bad_scenes_table.hpp"

namespace hdconj::test {

/// One bad scene of a family: `row.from` stands in data/scenes/<scene>.toml.
struct BadFamily
{
    std::string scene;
    BadScene row;
};

[[nodiscard]] std::vector<BadFamily> const& bad_families();

}  // namespace hdconj::test
