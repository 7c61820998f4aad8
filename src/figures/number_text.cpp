// SPDX-License-Identifier: GPL-3.0-or-later
#include "number_text.hpp"

#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>

#include "figure_of.hpp"
#include "hdconj/units.hpp"

namespace hdconj::figures {

std::string fixed(double value, int decimals)
{
    if (std::isnan(value))
        return "-";
    std::string text = fmt::format("{:.{}f}", value, decimals);
    return text.find_first_not_of("-0.") == std::string::npos && text.front() == '-' ? text.substr(1) : text;
}

std::string whole(double value)
{
    return fmt::format("{:.0f}", value);
}

std::string two_digits(double error)
{
    constexpr double whole_from = 99.5;
    return error >= whole_from ? whole(error) : significant<2>(error);
}

std::string table_number(double value)
{
    constexpr double hundred = 100, ten = 10;
    double const size = std::abs(value);
    return fixed(value, size >= hundred ? 0 : size >= ten ? 1 : 2);
}

std::string scientific(double value)
{
    return std::isnan(value) ? "-" : exponential<2>(value);
}

std::string duration(double seconds)
{
    constexpr double us_per_s = 1e6;
    if (seconds < 1 / per_ms)
        return significant<3>(seconds * us_per_s) + " us";
    return seconds < 1 ? significant<3>(seconds * per_ms) + " ms" : significant<3>(seconds) + " s";
}

std::string knob_text(double value)
{
    constexpr double whole_below = 1e9;  // a count as a count
    return value == std::floor(value) && std::abs(value) < whole_below ? whole(value) : significant<6>(value);
}

std::string um_text(double value_mm, char const* sign)
{
    return sign + significant<3>(value_mm * per_um) + " um";
}

double degrees_of(double angle)
{
    double const degrees = angle * per_deg;
    if (!std::isfinite(degrees))
        return degrees;
    for (int digits = 0; digits < std::numeric_limits<double>::digits10; ++digits) {
        std::string const text = fmt::format("{:.{}e}", degrees, digits);
        double given = 0;
        std::from_chars(text.data(), text.data() + text.size(), given);
        if (given * deg == angle)
            return given;
    }
    return degrees;
}

std::string Unit::attribute_suffix() const
{
    std::string suffix;
    for (char const c : std::string_view(stored))
        if (c != ' ' && c != '1')
            suffix += c;
    return suffix.empty() ? suffix : "_" + suffix;
}

}  // namespace hdconj::figures
