// SPDX-License-Identifier: GPL-3.0-or-later
// The JSON summary as an object that a verb adds to.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>

#include "figures/figure_of.hpp"
#include "hdconj/result_files.hpp"

namespace hdconj::report {

using Json = nlohmann::ordered_json;

/// JSON has no NaN and no infinity.
[[nodiscard]] Json number(double value);

/// The value of a figure as JSON holds it.
template <class Record>
[[nodiscard]] Json value_of(figures::FigureOf<Record> const& figure, Record const& record)
{
    double const value = figure.value(record);
    if (figure.kind == figures::Kind::flag)
        return value != 0;
    return figure.kind == figures::Kind::count ? Json(static_cast<std::int64_t>(value))
                                               : number(figure.unit.shown(value));
}

/// Its error likewise.
template <class Record>
[[nodiscard]] Json error_of(figures::FigureOf<Record> const& figure, Record const& record)
{
    double const error = figure.error(record);
    return figure.kind == figures::Kind::count ? Json(static_cast<std::int64_t>(error))
                                               : number(figure.unit.shown_error(error));
}

/// Every value of @p record under its key, but not the errors.
template <class Record>
void add_values(Json& object, figures::Rows<Record> const& rows, Record const& record)
{
    rows.for_each_name([&](auto const& figure) {
        if (figure.is_in(figures::json_value))
            object[figure.json_key()] = value_of(figure, record);
    });
}

/// Every figure of @p record under its key, with its error beside it unless errors stand apart.
/// @param estimated  false: errors, and what follows from them, are null
template <class Record>
void add_figures(Json& object, figures::Rows<Record> const& rows, Record const& record, bool estimated = true)
{
    rows.for_each_name([&](auto const& figure) {
        if (figure.is_in(figures::json_value))
            object[figure.json_key()] = estimated || !figure.bound ? value_of(figure, record) : Json(nullptr);
        if (figure.is_in(figures::json_error) && !figure.apart)
            object[figure.json_key_of_error()] = estimated ? error_of(figure, record) : Json(nullptr);
    });
}

template <class Record>
[[nodiscard]] Json figures_object(figures::Rows<Record> const& rows, Record const& record, bool estimated = true)
{
    Json object = Json::object();
    add_figures(object, rows, record, estimated);
    return object;
}

/// Every error of @p record under its key, as an object.
template <class Record>
[[nodiscard]] Json errors_object(figures::Rows<Record> const& rows, Record const& record)
{
    Json object = Json::object();
    rows.for_each_name([&](auto const& figure) {
        if (figure.is_in(figures::json_error))
            object[figure.json_key_of_error()] = error_of(figure, record);
    });
    return object;
}

/// Adds @p value under its name and under its former one.
inline void add(Json& object, figures::Name const& name, Json const& value)
{
    object[name.now] = value;
    if (name.former != nullptr)
        object[name.former] = value;
}

/// @p make of each of @p items.
template <class Items, class Make>
[[nodiscard]] Json list_of(Items const& items, Make make)
{
    Json list = Json::array();
    for (auto const& item : items)
        list.push_back(make(item));
    return list;
}

/// What every summary begins with: its format, and the program.
[[nodiscard]] Json format_heading(char const* format, int version);

/// Stages with their times.
[[nodiscard]] Json stages_object(std::vector<StageTime> const& timing);

/// An array with one object a note on a design.
[[nodiscard]] Json notes_object(Notes const& notes);

/// Files by their kind, each with its path and time.
[[nodiscard]] Json files_object(std::vector<WrittenFile> const& written);

/// Everything that is known of @p solution, without "timing" and "files", which stand last.
[[nodiscard]] Json summary_object(Solution const& solution);

/// Adds "timing" and "files" and prints it.
[[nodiscard]] std::string finished(Json summary, Solution const& solution, std::vector<WrittenFile> const& written);

/// The object as text, without and with a line end; bytes of file names that are not UTF-8 are replaced.
[[nodiscard]] std::string indented(Json const& object);
[[nodiscard]] std::string printed(Json const& summary);

}  // namespace hdconj::report
