// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "base/toml_string.hpp"
#include "hdconj/check.hpp"
#include "hdconj/profile/registry.hpp"
#include "hdconj/scene/reading.hpp"
#include "hdconj/wavegen/registry.hpp"
#include "sheet.hpp"

namespace hdconj::design {
namespace {

using scene::RawEntry;
using scene::RawValue;
using Kind = RawValue::Kind;

RawValue raw_number(double value)
{
    RawValue raw;
    raw.kind = value == std::floor(value) ? Kind::integer : Kind::number;
    raw.number = value;
    raw.written = number_text(value);
    return raw;
}

RawValue raw_list(scene::NumberRows const& rows)
{
    RawValue raw;
    raw.kind = Kind::array;
    for (auto const& row : rows) {
        RawValue inner;
        inner.kind = Kind::array;
        for (double const value : row)
            inner.items.push_back(raw_number(value));
        raw.items.push_back(std::move(inner));
    }
    return raw;
}

RawValue raw_of(scene::ParameterValue const& value)
{
    if (auto const* const number = std::get_if<double>(&value))
        return raw_number(*number);
    if (auto const* const rows = std::get_if<scene::NumberRows>(&value))
        return raw_list(*rows);
    RawValue raw;
    raw.kind = Kind::text;
    raw.text = std::get<std::string>(value);
    raw.written = toml_string(raw.text);
    return raw;
}

/// Puts @p value under @p path into @p table, whose sub-tables it makes.
void put(RawValue& table, std::string_view path, RawValue value)
{
    std::size_t const dot = path.find('.');
    std::string const key(path.substr(0, dot));
    auto found = std::find_if(table.entries.begin(), table.entries.end(),
                              [&](RawEntry const& entry) { return entry.key == key; });
    if (found == table.entries.end())
        found = table.entries.insert(table.entries.end(), {key, {}, 0, ""});
    if (dot == std::string_view::npos)
        found->value = std::move(value);
    else
        put(found->value, path.substr(dot + 1), std::move(value));
}

}  // namespace

double rounded(double value, int digits)
{
    return std::stod(short_number(value, digits));
}

double rounded_up(double value, int digits)
{
    double const near = rounded(value, digits);
    if (near >= value)
        return near;
    return rounded(near + std::pow(10.0, std::floor(std::log10(near)) + 1 - digits), digits);
}

double rounded_down(double value, int digits)
{
    double const near = rounded(value, digits);
    if (near <= value)
        return near;
    return rounded(near - std::pow(10.0, std::floor(std::log10(near)) + 1 - digits), digits);
}

double Sheet::operator[](std::string_view symbol) const
{
    for (auto const& row : rows_)
        if (row.symbol == symbol)
            return row.number();
    throw std::logic_error("no dimension is called " + std::string(symbol));
}

Scene scene_of(std::vector<DesignRow> const& rows, std::vector<DesignRow> const& changes)
{
    RawValue root;
    for (auto const* const list : {&rows, &changes})
        for (auto const& row : *list)
            if (!row.key.empty())
                put(root, row.key, raw_of(row.value));
    auto reading = scene::validate_scene(root, {profile::profile_families(), wavegen::wave_generator_families()});
    if (reading.faults.empty())
        reading.faults = check_scene(reading.scene);
    throw_if_any(std::move(reading.faults));
    return std::move(reading.scene);
}

}  // namespace hdconj::design
