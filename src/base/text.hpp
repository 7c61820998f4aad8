// SPDX-License-Identifier: GPL-3.0-or-later
// Small texts for messages: numbers as short as exact, user's text made safe to print.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hdconj {

/// Shortest decimal text that reads back as @p value; with an exponent only when very small or large.
[[nodiscard]] std::string number_text(double value);

/// @p value with at most @p digits significant digits.
[[nodiscard]] std::string short_number(double value, int digits = 6);

/// A number of at most six digits that is no smaller than @p bound, for "write at least ...".
[[nodiscard]] std::string at_least_text(double bound);
/// A number of at most six digits that is no larger than @p bound, for "write at most ...".
[[nodiscard]] std::string at_most_text(double bound);

/// To how much lengths are told in advice: ten thousandths of a millimetre [1/mm].
inline constexpr double told_per_mm = 1e4;
/// A length [mm] that is no smaller than @p bound, for "write ...".
[[nodiscard]] std::string length_at_least(double bound);

/// @p text in double quotes.
[[nodiscard]] std::string in_quotes(std::string_view text);

/// @p text for a message: control characters as \xNN, cut with "..." after @p most bytes, never inside
/// a UTF-8 sequence.
[[nodiscard]] std::string printable(std::string_view text, std::size_t most = 80);

/// The number that a text begins with, and what follows it.
struct NumberInText
{
    double value;
    std::string rest;  ///< without the blanks before it: "" of "0.7", "mm" of "0.7 mm"
};

/// The finite number at the beginning of @p text, if any; a decimal comma counts as a point.
[[nodiscard]] std::optional<NumberInText> leading_number(std::string text);

/// `"a", "b" or "c"`.
[[nodiscard]] std::string quoted_list(std::vector<std::string_view> const& words);

/// `a, b, c`.
[[nodiscard]] std::string plain_list(std::vector<std::string_view> const& words);

}  // namespace hdconj
