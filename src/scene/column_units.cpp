// SPDX-License-Identifier: GPL-3.0-or-later
#include "column_units.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

namespace hdconj::detail {
namespace {

struct Unit
{
    std::string_view name;
    double factor;
};

constexpr double mm_per_inch = 25.4;
constexpr double mm_per_um = 1.0 / 1000;
constexpr double mm_per_nm = mm_per_um / 1000;
constexpr double mm_per_m = 1000;
constexpr double deg_per_rad = 180 / std::numbers::pi;
constexpr std::array lengths = {Unit{"mm", 1}, Unit{"um", mm_per_um}, Unit{"\xc2\xb5m", mm_per_um}, Unit{"\xce\xbcm", mm_per_um}, Unit{"nm", mm_per_nm}, Unit{"cm", 10}, Unit{"m", mm_per_m},
                                Unit{"inch", mm_per_inch}, Unit{"in", mm_per_inch}, Unit{"mil", mm_per_inch / 1000}};
constexpr std::array angles = {Unit{"deg", 1}, Unit{"\xc2\xb0", 1}, Unit{"degree", 1}, Unit{"degrees", 1}, Unit{"arcmin", 1.0 / 60}, Unit{"arcsec", 1.0 / 3600},
                               Unit{"rad", deg_per_rad}, Unit{"mrad", deg_per_rad / 1000}};

std::span<Unit const> units_of(ColumnQuantity quantity)
{
    return quantity == ColumnQuantity::length ? std::span<Unit const>(lengths) : std::span<Unit const>(angles);
}

std::string_view known_units(ColumnQuantity quantity)
{
    return quantity == ColumnQuantity::length ? "[mm], [um], [nm], [cm], [m], [inch] or [mil]" : "[deg], [arcmin], [arcsec], [rad] or [mrad]";
}

std::optional<double> factor_of(std::string_view unit, ColumnQuantity quantity)
{
    std::string small;
    for (char const c : unit)
        small += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    for (Unit const& each : units_of(quantity))
        if (each.name == small)
            return each.factor;
    return std::nullopt;
}

bool is_unit(std::string_view text)
{
    return factor_of(text, ColumnQuantity::length) || factor_of(text, ColumnQuantity::angle);
}

std::string_view trimmed(std::string_view text)
{
    constexpr std::string_view blanks = " \t\r\"'";
    auto const begin = text.find_first_not_of(blanks);
    return begin == std::string_view::npos ? std::string_view() : text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

/// What stands in brackets; nothing where there are none.
std::optional<std::string_view> bracketed(std::string_view text)
{
    auto const open = text.find_first_of("[(");
    auto const close = text.find_first_of("])", open == std::string_view::npos ? 0 : open);
    if (open == std::string_view::npos || close == std::string_view::npos)
        return std::nullopt;
    return trimmed(text.substr(open + 1, close - open - 1));
}

/// Headings between commas, semicolons or tabs; where there are none, between blanks, a bracket with the word before it.
std::vector<std::string_view> headings_of(std::string_view header)
{
    std::vector<std::string_view> headings;
    bool const marked = header.find_first_of(",;\t") != std::string_view::npos;
    std::size_t begin = 0;
    for (std::size_t at = 0; at <= header.size(); ++at)
    {
        bool const bracket_follows = !marked && header.substr(std::min(at + 1, header.size())).find_first_of("[(") == 0;
        if (at < header.size() && (std::string_view(marked ? ",;\t" : " ").find(header[at]) == std::string_view::npos || bracket_follows))
            continue;
        std::string_view const heading = trimmed(header.substr(begin, at - begin));
        if (marked || !heading.empty())
            headings.push_back(heading);
        begin = at + 1;
    }
    return headings;
}

/// The unit that a heading names, whether it is known or not; nothing where it names none.
std::optional<std::string_view> unit_in(std::string_view heading)
{
    if (auto const inside = bracketed(heading))
        return inside;
    auto const before = heading.find_last_of("_ ");
    std::string_view const last = before == std::string_view::npos ? heading : heading.substr(before + 1);
    return is_unit(last) ? std::optional(last) : std::nullopt;
}

}  // namespace

ColumnUnits column_units(std::string_view header, std::array<ColumnQuantity, 2> const& columns)
{
    ColumnUnits found;
    auto const headings = headings_of(trimmed(header));
    auto const write = [&](std::size_t k) { return "write " + std::string(columns[k] == ColumnQuantity::length ? "a length" : "an angle") + " in " + std::string(known_units(columns[k])); };
    if (headings.size() != columns.size())
    {
        // a title is no header, but one with a unit may be meant for the columns
        if (auto const unit = bracketed(header); unit && is_unit(*unit))
        {
            found.reason = "names the unit [" + std::string(*unit) + "], and not of which of two columns";
            found.remedy = columns[0] == ColumnQuantity::length ? "write the header x [mm],y [mm], or remove it" : "write the header angle [deg],displacement [mm], or remove it";
        }
        return found;
    }
    for (std::size_t k = 0; k < columns.size(); ++k)
    {
        auto const unit = unit_in(headings[k]);
        if (!unit)
            continue;
        auto const factor = factor_of(*unit, columns[k]);
        if (!factor)
        {
            found.reason = "column " + std::to_string(k + 1) + ", " + std::string(headings[k]) + ": the unit is not known";
            found.remedy = write(k);
            return found;
        }
        found.factor[k] = *factor;
    }
    return found;
}

}  // namespace hdconj::detail
