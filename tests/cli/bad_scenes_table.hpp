// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Scenes that must be refused, and what must be said about them: one row per way to get a scene wrong.
#pragma once

#include <string>
#include <vector>

namespace hdconj::test {

/// One bad scene: the built-in one with an edit, or a text of its own.
struct BadScene
{
    std::string name;
    std::string from;    ///< text of the built-in scene that is replaced; empty: `to` is added at the end
    std::string to;      ///< what stands there instead
    std::string path;    ///< of the fault looked for
    std::string reason;  ///< part of its reason
    std::string remedy;  ///< part of its remedy
    int faults = 1;      ///< number of faults in all; 0: any number
};

/// Wrong values and names, each in the built-in scene.
[[nodiscard]] std::vector<BadScene> const& wrong_values();

/// Wrong tables, effects and combinations.
[[nodiscard]] std::vector<BadScene> const& wrong_tables();

/// Values that make no tooth or no pair.
[[nodiscard]] std::vector<BadScene> const& wrong_geometry();

/// What is no scene at all: `to` is the whole text, `from` is not used.
[[nodiscard]] std::vector<BadScene> const& wrong_texts();

/// @p text with the edit of @p row. @throws std::runtime_error where it has nothing to edit
[[nodiscard]] std::string edited(std::string text, BadScene const& row);

/// The scene of a row of the first three tables.
[[nodiscard]] std::string edited(BadScene const& row);

}  // namespace hdconj::test
