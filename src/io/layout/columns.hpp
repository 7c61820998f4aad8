// SPDX-License-Identifier: GPL-3.0-or-later
// Records as columns of a table, and figures as attributes.
#pragma once

#include <type_traits>
#include <vector>

#include "figures/figure_of.hpp"
#include "writer.hpp"

namespace hdconj::io::layout {

/// Values of @p take over all records.
template <class Records, class Take>
auto column(Records const& records, Take take)
{
    using Value = std::decay_t<decltype(std::invoke(take, *records.begin()))>;
    std::vector<std::conditional_t<std::is_same_v<Value, bool>, int, Value>> values;
    values.reserve(records.size());
    for (auto const& record : records)
        values.push_back(std::invoke(take, record));
    return values;
}

/// What a reader is told of the error of a figure.
template <class Record>
About about_error(figures::FigureOf<Record> const& figure, std::string const& prefix, char const* dim)
{
    return {figure.unit.stored, "estimated error of " + prefix + figure.name, {dim}};
}

/// A column of the values or of the errors: doubles, or integers for counts and flags; its former name is a link to it.
template <class Record>
void write_column(Writer const& place, char const* dim, figures::FigureOf<Record> const& figure,
                  std::vector<Record> const& records, std::string const& prefix, bool of_errors)
{
    auto const name_of = [&](auto const& row) { return prefix + (of_errors ? row.column_of_error() : row.name); };
    auto const read = of_errors ? figure.error : figure.value;
    std::string const name = name_of(figure);
    About const about = of_errors ? about_error(figure, prefix, dim) : About{figure.unit.stored, figure.meaning, {dim}};
    if (figure.kind == figures::Kind::number) {
        place.numbers(name, column(records, read), about);
    } else {
        place.integers(name, column(records, [&](Record const& record) { return static_cast<int>(read(record)); }),
                       about);
    }
    if (figure.former != nullptr)
        place.link(name, name_of(figure.under_former_name()));
}

/// Says where value and error of a figure stand: a column's error beside it, or else in the group `error`, if anywhere.
/// @param suffix  of both names
template <class Record>
void write_figure(Writer const& place, figures::FigureOf<Record> const& figure, std::string const& prefix,
                  std::string const& suffix, bool is_attribute, bool estimated = true)
{
    std::string error;
    if (estimated && is_attribute && figure.is_in(figures::hdf5_error))
        error = prefix + std::string(figure.name) + "_error" + suffix;
    else if (estimated && figure.is_in(figures::hdf5_error) && !figure.apart)
        error = prefix + figure.column_of_error();
    else if (estimated && figure.error != nullptr)
        error = "error/" + prefix + figure.name;
    place.figure(
        {prefix + figure.name, prefix + figure.name + suffix, error, figure.unit.stored, figure.meaning, is_attribute});
}

/// Columns of the errors of all figures.
template <class Record>
void write_error_columns(Writer const& place, char const* dim, figures::Rows<Record> const& rows,
                         std::vector<Record> const& records)
{
    for (auto const& figure : rows)
        if (figure.is_in(figures::hdf5_error))
            write_column(place, dim, figure, records, "", true);
}

/// Columns of all figures and of their errors, unless these stand apart. @param dim  that all columns have
/// @param estimated  false: errors, and what follows from them, are left out
template <class Record>
void write_columns(Writer const& place, char const* dim, figures::Rows<Record> const& rows,
                   std::vector<Record> const& records, std::string const& prefix = "", bool estimated = true)
{
    for (auto const& figure : rows) {
        if (figure.is_in(figures::hdf5_value) && (estimated || !figure.bound)) {
            write_column(place, dim, figure, records, prefix, false);
            write_figure(place, figure, prefix, "", false, estimated);
        }
        if (estimated && figure.is_in(figures::hdf5_error) && !figure.apart)
            write_column(place, dim, figure, records, prefix, true);
    }
}

/// Attributes of one record, whose names end in the unit. @param estimated  false: errors are 0
template <class Record>
void write_attributes(Writer const& place, figures::Rows<Record> const& rows, Record const& record,
                      bool estimated = true)
{
    rows.for_each_name([&](auto const& figure) {
        std::string const suffix = figure.unit.attribute_suffix();
        if (figure.is_in(figures::hdf5_value) && figure.kind == figures::Kind::number)
            place.attribute(figure.name + suffix, figure.value(record));
        else if (figure.is_in(figures::hdf5_value))
            place.attribute(figure.name, static_cast<int>(figure.value(record)));
        if (figure.is_in(figures::hdf5_error))
            place.attribute(std::string(figure.name) + "_error" + suffix, estimated ? figure.error(record) : 0.0);
    });
    for (auto const& figure : rows)
        if (figure.is_in(figures::hdf5_value))
            write_figure(place, figure, "", figure.kind == figures::Kind::number ? figure.unit.attribute_suffix() : "",
                         true);
}

/// A dataset made by @p write, which takes its name; its former name is a link to it.
template <class Write>
void write_named(Writer const& place, figures::Name const& name, Write write)
{
    write(name.now);
    if (name.former != nullptr)
        place.link(name.now, name.former);
}

}  // namespace hdconj::io::layout
