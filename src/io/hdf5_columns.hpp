// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Records as columns of a table; private to src/io.
#pragma once

#include <span>
#include <type_traits>
#include <vector>

#include "figure_of.hpp"
#include "hdf5_writer.hpp"

namespace hdconj::hdf5 {

/// Values of @p take over all records.
template <class Record, class Take>
auto column(std::vector<Record> const& records, Take take)
{
    std::vector<std::decay_t<decltype(take(records.front()))>> values;
    values.reserve(records.size());
    for (auto const& record : records) {
        values.push_back(take(record));
    }
    return values;
}

/// One dataset per figure that has a column.
template <class Record>
void write_columns(Writer const& place, std::span<FigureOf<Record> const> figures, std::vector<Record> const& records)
{
    for (auto const& figure : figures) {
        if (figure.column != nullptr) {
            place.numbers(figure.column, column(records, figure.value), figure.units);
        }
    }
}

}  // namespace hdconj::hdf5
