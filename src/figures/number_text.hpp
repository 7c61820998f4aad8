// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as the printed summaries show them.
#pragma once

#include <fmt/format.h>

#include <string>

namespace hdconj::figures {

/// Fixed decimals, and never "-0.00".
[[nodiscard]] std::string fixed(double value, int decimals);

template <int decimals>
std::string fixed(double value)
{
    return fixed(value, decimals);
}

/// At most so many digits that count.
template <int digits>
std::string significant(double value)
{
    return fmt::format("{:.{}g}", value, digits);
}

/// Always with an exponent.
template <int decimals>
std::string exponential(double value)
{
    return fmt::format("{:.{}e}", value, decimals);
}

/// Fixed decimals.
template <int decimals_shown>
std::string decimals(double value)
{
    return fmt::format("{:.{}f}", value, decimals_shown);
}

/// Fixed decimals, always with a sign.
template <int decimals_shown>
std::string signed_decimals(double value)
{
    return fmt::format("{:+.{}f}", value, decimals_shown);
}

/// Without decimals.
[[nodiscard]] std::string whole(double value);
/// An error to two digits, whole numbers without an exponent.
[[nodiscard]] std::string two_digits(double error);
/// Three or four digits that count, as a length of text that suits a table.
[[nodiscard]] std::string table_number(double value);
/// "1.2e-07", "-" where there is none.
[[nodiscard]] std::string scientific(double value);
/// "12.3 ms".
[[nodiscard]] std::string duration(double seconds);
/// A knob's value as a user writes it: "1e-06", "64", "1048576".
[[nodiscard]] std::string knob_text(double value);
/// "-78.1 um"
[[nodiscard]] std::string um_text(double value_mm, char const* sign = "");

}  // namespace hdconj::figures
