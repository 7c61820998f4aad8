// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The JSON summary as an object that a verb adds to; private to src/io.
#pragma once

#include <nlohmann/json.hpp>
#include <span>

#include "figure_of.hpp"
#include "hdconj/io/result_files.hpp"
#include "summary_figures.hpp"

namespace hdconj {

using Json = nlohmann::ordered_json;

/// JSON has no NaN and no infinity.
[[nodiscard]] Json number(double value);

/// Every figure of @p record under its key.
template <class Record>
void add_figures(Json& object, std::span<FigureOf<Record> const> figures, Record const& record)
{
    for (auto const& figure : figures) {
        double const stored = figure.value(record);
        object[figure.key] = number(figure.json_per_stored == degree_per_radian ? degrees_of(stored) : stored * figure.json_per_stored);
    }
}

/// Everything that is known of @p solution, without "timing" and "files", which stand last.
[[nodiscard]] Json summary_object(Solution const& solution);

/// Adds "timing" and "files" and prints it.
[[nodiscard]] std::string finished(Json summary, Solution const& solution, std::vector<WrittenFile> const& written);

}  // namespace hdconj
