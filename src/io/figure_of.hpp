// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A number of a record under the names that it has in HDF5 and JSON; private to src/io.
#pragma once

namespace hdconj {

/// One number of a @p Record: a column in HDF5, a key in JSON.
template <class Record>
struct FigureOf
{
    char const* column;      ///< name in HDF5; null: in JSON only
    char const* units;       ///< there
    char const* key;         ///< in JSON, ending in its unit
    double json_per_stored;  ///< from the unit in HDF5 to that in JSON
    double (*value)(Record const&);
};

}  // namespace hdconj
