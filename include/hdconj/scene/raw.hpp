// SPDX-License-Identifier: GPL-3.0-or-later
// A scene before it is validated: what stands where in the file, whatever the file's language.
#pragma once

#include <string>
#include <vector>

namespace hdconj::scene {

struct RawEntry;

/// One value as it was found.
struct RawValue
{
    enum class Kind
    {
        boolean,
        integer,
        number,
        text,
        date,  ///< date, time or both
        array,
        table
    };

    Kind kind = Kind::table;
    double number = 0;              ///< of integer and number
    std::string text;               ///< of text
    std::string written;            ///< as the user wrote it, for messages; empty for a table
    std::vector<RawEntry> entries;  ///< of table
    std::vector<RawValue> items;    ///< of array, each with its line and without `written`
    int line = 0;                   ///< of an item
};

/// One key of a table with its value.
struct RawEntry
{
    std::string key;
    RawValue value;
    int line = 0;        ///< of the key, 1-based; 0 when not from a file
    std::string origin;  ///< "--set" when it comes from the command line
};

}  // namespace hdconj::scene
