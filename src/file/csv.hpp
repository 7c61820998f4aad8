// SPDX-License-Identifier: GPL-3.0-or-later
// Reads tables of numbers with a header: the lines of a CSV file, its fields, and the units in its headings.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hdconj::file {

/// Why a CSV file is not read.
enum class Unreadable
{
    is_folder,
    not_opened,
    endless,  ///< a device or a pipe, which has no size
    too_large
};

/// Passes every line of a text file to @p take, with its number from 1. A byte order mark at the beginning is removed.
/// Reading stops where @p take returns false.
/// @param largest  size above which the file is refused unread [bytes]
/// @returns nothing where the file was read
std::optional<Unreadable> read_lines(std::filesystem::path const& file, std::uintmax_t largest,
                                     std::function<bool(std::string_view line, int number)> const& take);

/// The same of every line that is neither blank nor a comment (first character '#').
std::optional<Unreadable> read_csv(std::filesystem::path const& file, std::uintmax_t largest,
                                   std::function<bool(std::string_view line, int number)> const& take);

/// The same of @p content, which @p file held; null: it is read.
std::optional<Unreadable> read_csv(std::filesystem::path const& file, std::string const* content,
                                   std::uintmax_t largest,
                                   std::function<bool(std::string_view line, int number)> const& take);

/// All that @p file holds; null where read_lines() would not read it.
[[nodiscard]] std::shared_ptr<std::string const> whole_text(std::filesystem::path const& file, std::uintmax_t largest);

/// @p text without @p blanks at either end.
[[nodiscard]] std::string_view trimmed(std::string_view text, std::string_view blanks = " \t\r\n\"");

/// @p text with the letters A to Z in lower case, without the characters @p without.
[[nodiscard]] std::string lower_case(std::string_view text, std::string_view without = "");

/// What separates the fields of a line: the semicolon or the tab where it has one, else the comma.
[[nodiscard]] char separator_of(std::string_view line);

/// Fields between separators, trimmed; one more than there are separators.
[[nodiscard]] std::vector<std::string_view> fields_of(std::string_view line, char separator);

/// The finite number that a whole field is; a plus sign is allowed.
[[nodiscard]] std::optional<double> number_in(std::string_view field);

/// A heading such as "torque [N m]" or "x (mm)".
struct Heading
{
    std::string_view name;                 ///< what stands before the bracket, trimmed
    std::optional<std::string_view> unit;  ///< what stands within the brackets
};
[[nodiscard]] Heading heading_of(std::string_view text);

/// A unit and what its numbers are multiplied by.
struct ColumnUnit
{
    std::string_view name;  ///< in lower case
    double factor;
};

/// The factor of the unit @p name, in lower case; nothing where @p units lacks it.
[[nodiscard]] std::optional<double> factor_of(std::span<ColumnUnit const> units, std::string_view name);

}  // namespace hdconj::file
