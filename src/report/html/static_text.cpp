// SPDX-License-Identifier: GPL-3.0-or-later
#include "static_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <vector>

#include "figures/figure_of.hpp"

namespace hdconj::report {
namespace {

/// @p value with its error, marked where that is more than a third of it; NaN: an error that was not determined.
std::string value_text(double value, std::optional<double> error)
{
    if (!std::isfinite(value))
        return "-";
    std::string const text = fmt::format("{:.9g}", value);
    if (!error)
        return text;
    return std::isfinite(*error)
               ? fmt::format("{} +- {:.2g}{}", text, *error, figures::is_unconverged(value, *error) ? "?" : "")
               : text + " +- not determined";
}

std::vector<double> column_at(Json const& group, std::string const& path)
{
    std::size_t const slash = path.find('/');
    return slash == std::string::npos
               ? column_of(group, path.c_str(), 1)
               : column_of(group_at(group, {path.substr(0, slash)}), path.substr(slash + 1).c_str(), 1);
}

std::optional<double> attribute_at(Json const& group, std::string const& name)
{
    Json const attributes = group.value("attributes", Json::object());
    if (!attributes.contains(name) || !attributes.at(name).is_number())
        return std::nullopt;
    return attributes.at(name).get<double>();
}

std::string line_of(std::string const& name, std::string const& values, std::string const& unit)
{
    return fmt::format("{:<32} {}{}\n", name, values, unit == "1" ? "" : ' ' + unit);
}

/// What @p group says beside its figures: of which case they are.
std::string words_of(Json const& group)
{
    std::set<std::string> figures;
    for (Json const& figure : group.at("figures"))
        figures.insert({figure[1].get<std::string>(), figure[2].get<std::string>()});
    std::string text;
    for (auto const& [name, value] : group.at("attributes").items())
        if (!figures.contains(name))
            text += line_of(name, value.is_string() ? value.get<std::string>() : value.dump(), "1");
    return text;
}

/// The figures of @p group that are one value each, and with @p columns those that are one for each case.
std::string figures_text(Json const& group, bool columns)
{
    std::string text;
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    bool const estimated = !(attribute_at(group, "estimated") == 0.0);
    std::vector<double> const estimated_cases = column_at(group, "error/estimated");
    for (Json const& figure : group.value("figures", Json::array())) {
        auto const name = figure[0].get<std::string>(), at = figure[1].get<std::string>(),
                   error = figure[2].get<std::string>(), unit = figure[3].get<std::string>();
        if (figure[5].get<bool>()) {
            auto const value = attribute_at(group, at);
            if (value && !error.empty() && !estimated)
                text += line_of(name, value_text(*value, unknown), unit);
            else if (value)
                text += line_of(name, value_text(*value, attribute_at(group, error)), unit);
        } else if (columns) {
            std::vector<double> const values = column_at(group, at), errors = column_at(group, error);
            std::string cases;
            for (std::size_t k = 0; k < values.size(); ++k) {
                bool const known = estimated && !(k < estimated_cases.size() && estimated_cases[k] == 0);
                std::optional<double> const own = k < errors.size() ? std::optional(errors[k]) : std::nullopt;
                cases += (k > 0 ? " | " : "") + value_text(values[k], own && !known ? unknown : own);
            }
            text += line_of(name, cases, unit);
        }
    }
    return text;
}

}  // namespace

std::string stored_text(Json const& parts)
{
    std::string text;
    for (auto const& [part, root] : parts.items())
        for (auto const& [name, group] : root.at("groups").items()) {
            bool const is_solved = part == "solve";
            if (is_solved && name != "summary")
                continue;
            text += fmt::format("{}{}\n", text.empty() ? "" : "\n", part);
            text += figures_text(group, !is_solved);
            Json const inner = group.value("groups", Json::object());
            for (auto const& [place, each] : inner.items())
                if (std::string const figures = figures_text(each, false); !figures.empty())
                    text += fmt::format("\n{}, {}\n{}{}", part, place, words_of(each), figures);
        }
    if (text.find('?') != std::string::npos)
        text += "\n?: the error is more than a third of the figure\n";
    return text;
}

std::vector<std::string> noted(Json const& drive)
{
    std::vector<std::string> lines;
    for (Json const& note : drive.at("judgement"))
        lines.push_back(fmt::format("{} {} at {}: {}; {}", note.at("severity").get<std::string>(),
                                    note.at("code").get<std::string>(), note.at("place").get<std::string>(),
                                    note.at("cause").get<std::string>(), note.at("advice").get<std::string>()));
    for (Json const& note : drive.at("notes"))
        lines.push_back(note.get<std::string>());
    return lines;
}

std::vector<std::string> parts_left_out(Json const& drive)
{
    std::vector<std::string> lines;
    for (Json const& part : drive.at("left_out"))
        lines.push_back(fmt::format("{}: {}", part.at("part").get<std::string>(), part.at("why").get<std::string>()));
    return lines;
}

}  // namespace hdconj::report
