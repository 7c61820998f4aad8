// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <string>

#include "hdconj/scene/reading.hpp"
#include "validation.hpp"

namespace hdconj::scene {

bool is_length(Quantity quantity)
{
    return quantity == Quantity::length || quantity == Quantity::positive_length ||
           quantity == Quantity::nonnegative_length || quantity == Quantity::length_or_word;
}

std::string_view unit_of_number(ParameterSpec const& spec)
{
    constexpr std::array<std::string_view, 5> units{"N m/rad", "N m", "MPa", "mm^2/s", "N/mm^2"};
    for (std::string_view const unit : units)
        if (spec.meaning.find("in " + std::string(unit)) != std::string_view::npos)
            return unit;
    return "";
}

std::optional<KeyDescription> describe_key(std::string_view path, SceneFamilies const& families)
{
    std::size_t const dot = path.rfind('.');
    TableSpec const* const table = find_table(path.substr(0, dot));
    if (!table || dot == std::string_view::npos)
        return std::nullopt;
    auto const keys = keys_of(*table, families);
    auto const found = std::ranges::find(keys, path.substr(dot + 1), &ParameterSpec::key);
    if (found == keys.end())
        return std::nullopt;
    ParameterSpec const& spec = **found;
    std::string_view const unit = is_length(spec.quantity)               ? "mm"
                                  : spec.quantity == Quantity::angle_deg ? "deg"
                                                                         : unit_of_number(spec);
    return KeyDescription{spec.quantity, unit, expectation(spec)};
}

}  // namespace hdconj::scene
