// SPDX-License-Identifier: GPL-3.0-or-later
#include "column_units.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "file/csv.hpp"
#include "hdconj/units.hpp"

namespace hdconj::scene {
namespace {

using file::ColumnUnit;

constexpr double inch = 25.4;
constexpr std::array lengths = {ColumnUnit{"mm", 1},           ColumnUnit{"um", um},        ColumnUnit{"\xc2\xb5m", um},
                                ColumnUnit{"\xce\xbcm", um},   ColumnUnit{"nm", um / 1000}, ColumnUnit{"cm", 10},
                                ColumnUnit{"m", 1000},         ColumnUnit{"inch", inch},    ColumnUnit{"in", inch},
                                ColumnUnit{"mil", inch / 1000}};
constexpr std::array angles = {ColumnUnit{"deg", 1},           ColumnUnit{"\xc2\xb0", 1},
                               ColumnUnit{"degree", 1},        ColumnUnit{"degrees", 1},
                               ColumnUnit{"arcmin", 1.0 / 60}, ColumnUnit{"arcsec", 1.0 / 3600},
                               ColumnUnit{"rad", per_deg},     ColumnUnit{"mrad", per_deg / 1000}};

std::span<ColumnUnit const> units_of(ColumnQuantity quantity)
{
    return quantity == ColumnQuantity::length ? std::span<ColumnUnit const>(lengths)
                                              : std::span<ColumnUnit const>(angles);
}

std::string_view known_units(ColumnQuantity quantity)
{
    return quantity == ColumnQuantity::length ? "[mm], [um], [nm], [cm], [m], [inch] or [mil]"
                                              : "[deg], [arcmin], [arcsec], [rad] or [mrad]";
}

std::optional<double> factor_of(std::string_view unit, ColumnQuantity quantity)
{
    return file::factor_of(units_of(quantity), file::lower_case(unit));
}

bool is_unit(std::string_view text)
{
    return factor_of(text, ColumnQuantity::length) || factor_of(text, ColumnQuantity::angle);
}

std::string_view without_blanks(std::string_view text)
{
    return file::trimmed(text, " \t\r\"'");
}

/// The unit that stands in brackets; nothing where there are none.
std::optional<std::string_view> bracketed(std::string_view text)
{
    auto const unit = file::heading_of(text).unit;
    return unit ? std::optional(without_blanks(*unit)) : std::nullopt;
}

/// Headings between commas, semicolons or tabs; where there are none, between blanks, a bracket with the word before
/// it.
std::vector<std::string_view> headings_of(std::string_view header)
{
    std::vector<std::string_view> headings;
    bool const marked = header.find_first_of(",;\t") != std::string_view::npos;
    std::size_t begin = 0;
    for (std::size_t at = 0; at <= header.size(); ++at) {
        bool const bracket_follows = !marked && header.substr(std::min(at + 1, header.size())).find_first_of("[(") == 0;
        if (at < header.size() &&
            (std::string_view(marked ? ",;\t" : " ").find(header[at]) == std::string_view::npos || bracket_follows))
            continue;
        std::string_view const heading = without_blanks(header.substr(begin, at - begin));
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
    auto const headings = headings_of(without_blanks(header));
    auto const write = [&](std::size_t k) {
        return "write " + std::string(columns[k] == ColumnQuantity::length ? "a length" : "an angle") + " in " +
               std::string(known_units(columns[k]));
    };
    if (headings.size() != columns.size()) {
        // a title is no header, but one with a unit may be meant for the columns
        if (auto const unit = bracketed(header); unit && is_unit(*unit)) {
            found.reason = "names the unit [" + std::string(*unit) + "], and not of which of two columns";
            found.remedy = columns[0] == ColumnQuantity::length
                               ? "write the header x [mm],y [mm], or remove it"
                               : "write the header angle [deg],displacement [mm], or remove it";
        }
        return found;
    }
    for (std::size_t k = 0; k < columns.size(); ++k) {
        auto const unit = unit_in(headings[k]);
        if (!unit)
            continue;
        auto const factor = factor_of(*unit, columns[k]);
        if (!factor) {
            found.reason =
                "column " + std::to_string(k + 1) + ", " + std::string(headings[k]) + ": the unit is not known";
            found.remedy = write(k);
            return found;
        }
        found.factor[k] = *factor;
    }
    return found;
}

}  // namespace hdconj::scene
