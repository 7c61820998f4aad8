// SPDX-License-Identifier: GPL-3.0-or-later
#include "column_units.hpp"

#include <array>
#include <cstdlib>
#include <span>

#include "base/text.hpp"
#include "file/csv.hpp"
#include "hdconj/units.hpp"

namespace hdconj::scene {
namespace {

using file::ColumnUnit;

constexpr double inch = 25.4;
constexpr std::array lengths = {ColumnUnit{"mm", 1},         ColumnUnit{"um", um},      ColumnUnit{"\xc2\xb5m", um},
                                ColumnUnit{"micron", um},    ColumnUnit{"microns", um}, ColumnUnit{"\xce\xbcm", um},
                                ColumnUnit{"nm", um / 1000}, ColumnUnit{"cm", 10},      ColumnUnit{"m", 1000},
                                ColumnUnit{"inch", inch},    ColumnUnit{"in", inch},    ColumnUnit{"mil", inch / 1000}};
constexpr std::array angles = {ColumnUnit{"deg", 1},           ColumnUnit{"\xc2\xb0", 1},
                               ColumnUnit{"degree", 1},        ColumnUnit{"degrees", 1},
                               ColumnUnit{"arcmin", 1.0 / 60}, ColumnUnit{"arcsec", 1.0 / 3600},
                               ColumnUnit{"rad", per_deg},     ColumnUnit{"mrad", per_deg / 1000}};

}  // namespace

std::optional<double> factor_of_unit(std::string_view unit, ColumnQuantity quantity)
{
    auto const units =
        quantity == ColumnQuantity::length ? std::span<ColumnUnit const>(lengths) : std::span<ColumnUnit const>(angles);
    std::string const plain = file::lower_case(unit, " ");
    if (plain == "nm" && unit.find('N') != std::string_view::npos)
        return std::nullopt;  // of a torque
    return file::factor_of(units, plain);
}

double in_other_unit(double value, double factor)
{
    constexpr int digits = 12;
    return factor == 1 ? value : std::strtod(short_number(value * factor, digits).c_str(), nullptr);
}

bool is_unit(std::string_view text)
{
    return factor_of_unit(text, ColumnQuantity::length) || factor_of_unit(text, ColumnQuantity::angle);
}

std::string_view without_blanks(std::string_view text)
{
    return file::trimmed(text, " \t\r\"'");
}

std::optional<std::string_view> unit_in_brackets(std::string_view text)
{
    auto const unit = file::heading_of(text).unit;
    return unit ? std::optional(without_blanks(*unit)) : std::nullopt;
}

std::optional<std::string_view> unit_in(std::string_view heading)
{
    if (auto const inside = unit_in_brackets(heading))
        return inside;
    auto const before = heading.find_last_of("_ ");
    std::string_view const last = before == std::string_view::npos ? heading : heading.substr(before + 1);
    return is_unit(last) ? std::optional(last) : std::nullopt;
}

char const* known_units(ColumnQuantity quantity)
{
    return quantity == ColumnQuantity::length ? "[mm], [um], [nm], [cm], [m], [inch] or [mil]"
                                              : "[deg], [arcmin], [arcsec], [rad] or [mrad]";
}

std::string write_known_unit(ColumnQuantity quantity)
{
    return std::string(quantity == ColumnQuantity::length ? "write a length in " : "write an angle in ") +
           known_units(quantity);
}

}  // namespace hdconj::scene
