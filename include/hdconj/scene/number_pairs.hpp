// SPDX-License-Identifier: GPL-3.0-or-later
// Two-column CSV files that families read: points of a tooth, tables of a cam.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "hdconj/error.hpp"
#include "hdconj/scene/parameters.hpp"

namespace hdconj::scene {

/// The work grows with each row: 10 000 points of a flank take some seconds.
inline constexpr std::size_t most_number_pairs = 10000;
/// A larger file is no such table; it is refused before it is read. [bytes]
inline constexpr std::size_t largest_number_file = std::size_t{16} << 20;

/// What a column holds, and so which units its heading may name.
enum class ColumnQuantity
{
    length,  ///< read in mm
    angle    ///< read in degrees
};

/// A pair of numbers and the line of the file it stands on.
struct NumberPair
{
    std::array<double, 2> value{};
    int line = 0;
};

/// A file of number pairs as far as it could be read.
struct NumberPairs
{
    std::string file;  ///< as opened
    std::vector<NumberPair> rows;
};

/// The file that @p choice names under @p key. @param folder  where a relative name starts
[[nodiscard]] std::filesystem::path number_file(FamilyChoice const& choice, std::string_view key,
                                                std::filesystem::path const& folder);

/// Reads the CSV file that @p choice names under @p key, or what it held when the scene was read. A line holds two
/// finite numbers, separated by comma, semicolon, tab or blanks. A '#' starts a comment. One header line is allowed,
/// and may name units: "x [inch]". Without units the columns are in mm and degrees. The file is regular and has at most
/// most_number_pairs rows. Nothing is read when there are faults.
/// @param folder  where a relative name starts
/// @param columns what the two hold; they are returned in mm and degrees
/// @param what    the columns, for messages: "x,y in mm"
[[nodiscard]] NumberPairs read_number_pairs(FamilyChoice const& choice, std::string_view key, std::string const& folder,
                                            std::array<ColumnQuantity, 2> const& columns, std::string_view what,
                                            Faults& faults);

}  // namespace hdconj::scene
