// SPDX-License-Identifier: GPL-3.0-or-later
#include "arguments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "hdconj/base/suggest.hpp"
#include "hdconj/scene/schema.hpp"

namespace hdconj::cli {
namespace {

std::optional<double> number_of(std::string const& given)
{
    char* end = nullptr;
    double const value = std::strtod(given.c_str(), &end);
    return end != given.c_str() && *end == '\0' ? std::optional(value) : std::nullopt;
}

std::vector<std::string> items_of(std::string_view list)
{
    std::vector<std::string> items;
    for (auto comma = list.find(','); comma != std::string_view::npos; comma = list.find(',')) {
        items.emplace_back(list.substr(0, comma));
        list.remove_prefix(comma + 1);
    }
    items.emplace_back(list);
    return items;
}

}  // namespace

std::string is_name(std::string const& given)
{
    return given.empty() ? "an empty name (write a name, or leave the option out)" : "";
}

Check finite_number(std::string const& remedy)
{
    return [remedy](std::string const& given) {
        auto const value = number_of(given);
        return value && std::isfinite(*value) ? "" : fmt::format("'{}' is no finite number ({})", given, remedy);
    };
}

Check positive_number(std::string const& remedy)
{
    return [remedy, finite = finite_number(remedy)](std::string const& given) {
        std::string const fault = finite(given);
        return fault.empty() && !(*number_of(given) > 0) ? fmt::format("'{}' is not above 0 ({})", given, remedy)
                                                         : fault;
    };
}

Check angle(std::string const& remedy)
{
    return [remedy](std::string const& given) {
        return number_of(given) ? "" : fmt::format("'{}' is no angle (write {})", given, remedy);
    };
}

CLI::Validator whole_number(int least, int most)
{
    std::string const range = fmt::format("{} to {}", least, most);
    auto const check = [=](std::string const& given) {
        auto const value = number_of(given);
        bool const fits = value && *value >= least && *value <= most && std::floor(*value) == *value;
        if (fits && given.find_first_of(".eE") != std::string::npos)
            return fmt::format("'{}' is not written as a whole number (write {:.0f})", given, *value);
        return fits ? "" : fmt::format("'{}' is no whole number from {}", given, range);
    };
    return {check, range};
}

Check one_of(std::vector<std::string_view> words)
{
    return [words = std::move(words)](std::string const& given) -> std::string {
        if (std::find(words.begin(), words.end(), given) != words.end())
            return {};
        auto const meant = nearest(given, words);
        return fmt::format("unknown word '{}' ({}known: {})", given, meant ? fmt::format("write {}; ", *meant) : "",
                           fmt::join(words, ", "));
    };
}

void add_name(CLI::App& verb, std::string const& name, std::string& value, std::string const& meaning,
              std::string const& type)
{
    add_option(verb, name, value, meaning, type, is_name);
}

void add_list(CLI::App& verb, std::string const& name, std::vector<std::string>& items, std::string const& meaning,
              std::string const& type, Check const& check)
{
    auto const take = [&items](std::vector<std::string> const& lists) {
        for (auto const& list : lists) {
            auto const more = items_of(list);
            items.insert(items.end(), more.begin(), more.end());
        }
    };
    auto const check_items = [check](std::string const& list) -> std::string {
        auto const given = items_of(list);
        for (auto const& item : given) {
            if (item.empty() && given.size() > 1)
                return "an item of '" + list + "' is empty (write one comma between two items, and none at the ends)";
            if (std::string fault = check ? check(item) : ""; !fault.empty())
                return fault;
        }
        return {};
    };
    // one word each time: what stands behind it is the scene
    verb.add_option_function<std::vector<std::string>>(name, take, meaning)
        ->check(check_items)
        ->allow_extra_args(false)
        ->type_name(type);
}

void add_case_options(CLI::App& verb, CaseArguments& cases, std::string const& meaning_of_tilt)
{
    add_list(verb, "--tilt", cases.tilts_deg, meaning_of_tilt, "DEG,...", angle("angles in degrees such as 0,0.1,0.2"));
    add_list(verb, "--surface", cases.surfaces,
             "how the teeth of the circular spline are made: tilted, ruled, per-slice [the scene's, or tilted]",
             "WORD,...", one_of<ToothSurface>());
    add_list(
        verb, "--kind", cases.kinds,
        "what tilt means: radial, outline moved along its radii, or draft, along its normal [the scene's, or radial]",
        "WORD,...", one_of<TiltKind>());
}

}  // namespace hdconj::cli
