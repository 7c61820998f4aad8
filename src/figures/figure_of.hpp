// SPDX-License-Identifier: GPL-3.0-or-later
// One row of a table of figures: everything that HDF5, JSON and text say of a number of a result.
#pragma once

#include <cmath>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

#include "hdconj/units.hpp"

namespace hdconj::figures {

// Units: what a number counts in HDF5, in JSON and in the printed summary.

/// An angle [rad] in degrees: where a decimal number of at most 15 digits is this very angle, as a scene's or an
/// option's 1.15 is, that number, without the roundings of there and back; else the product.
[[nodiscard]] double degrees_of(double angle);

struct Unit
{
    char const* stored;           ///< of the number in HDF5
    char const* key;              ///< end of the key in JSON; empty: a pure number
    char const* text;             ///< in the printed summary
    double shown_per_stored = 1;  ///< from the number in HDF5 to that in JSON and text
    bool is_given = false;        ///< an angle that a user may have given in degrees

    [[nodiscard]] double shown(double value) const { return is_given ? degrees_of(value) : value * shown_per_stored; }
    /// An error, which no user has given.
    [[nodiscard]] double shown_error(double error) const { return error * shown_per_stored; }
    /// What a key in JSON ends in, "_mm".
    [[nodiscard]] std::string suffix() const { return *key == '\0' ? "" : std::string("_") + key; }
    /// What the name of an attribute in HDF5 ends in, "_Nmm".
    [[nodiscard]] std::string attribute_suffix() const;
};

namespace unit {

// The same in HDF5 and JSON.
inline constexpr Unit one{"1", "", ""};
inline constexpr Unit mm{"mm", "mm", "mm"};
inline constexpr Unit mm2{"mm^2", "mm2", "mm^2"};
inline constexpr Unit second{"s", "s", "s"};
inline constexpr Unit newton{"N", "N", "N"};
inline constexpr Unit newton_per_mm{"N/mm", "N_per_mm", "N/mm"};
inline constexpr Unit newton_per_mm_to_3_2{"N/mm^(3/2)", "N_per_mm3_2", "N/mm^1.5"};
inline constexpr Unit megapascal{"MPa", "MPa", "MPa"};
inline constexpr Unit megabyte{"MB", "mb", "MB"};
inline constexpr Unit mm_per_rad{"mm/rad", "mm_per_rad", "mm/rad"};
// Others in JSON.
inline constexpr Unit um{"mm", "um", "um", per_um};
inline constexpr Unit degree{"rad", "deg", "deg", per_deg};
/// Of an angle that a user may have given in degrees.
inline constexpr Unit given_degree{"rad", "deg", "deg", per_deg, true};
inline constexpr Unit arcmin{"rad", "arcmin", "arcmin", per_arcmin};
inline constexpr Unit newton_metre{"N mm", "Nm", "N m", per_newton_metre};
inline constexpr Unit newton_metre_per_rad{"N mm/rad", "Nm_per_rad", "N m/rad", per_newton_metre};
inline constexpr Unit newton_metre_per_degree{"N mm/rad", "Nm_per_deg", "N m/deg", per_newton_metre_per_deg};
// In the text only.
inline constexpr Unit percent{"1", "", "%", per_percent};
inline constexpr Unit millisecond{"s", "", "ms", per_ms};

}  // namespace unit

/// A name in the files that is no figure's, and what the format before called it.
struct Name
{
    char const* now;
    char const* former = nullptr;  ///< null: the same
};

/// How the files hold a figure: as a floating-point number, as an integer, or as true and false (in HDF5 1 and 0).
enum class Kind
{
    number,
    count,
    flag
};

/// Places that a figure is absent from; combined with |.
enum Absent : unsigned
{
    hdf5_value = 1,
    hdf5_error = 2,
    json_value = 4,
    json_error = 8,
    hdf5 = hdf5_value | hdf5_error,
    json = json_value | json_error
};

/// How the printed summary shows a figure; without formats it does not.
struct Text
{
    char const* label = "";
    std::string (*value)(double) = nullptr;
    std::string (*error)(double) = nullptr;
    Unit const* unit = nullptr;        ///< null: that of JSON
    Unit const* error_unit = nullptr;  ///< null: that of the value in the text
};

namespace path {

template <class Member, class Class>
Class owner_of(Member Class::*);  // for decltype()

/// The value at the end of a path of members: read<&LoadCase::stages, &StiffnessStages::first>.
template <auto first, auto... rest>
auto read(decltype(owner_of(first)) const& record)
{
    if constexpr (sizeof...(rest) == 0)
        return std::invoke(first, record);
    else
        return read<rest...>(std::invoke(first, record));
}

template <auto first, auto... rest>
double number(decltype(owner_of(first)) const& record)
{
    return static_cast<double>(read<first, rest...>(record));
}

}  // namespace path

/// One number of a @p Record: a column or an attribute in HDF5, a key in JSON, a figure in the text.
///
/// The name of its error is NAME_error, in JSON before the unit. Estimates that stand apart, in a group or object of
/// their own, have the names of the values.
template <class Record>
struct FigureOf
{
    using Read = double (*)(Record const&);

    char const* name;     ///< in HDF5
    Unit unit;            ///< in HDF5 and in JSON
    char const* meaning;  ///< in one line
    Read value;
    Kind kind = Kind::number;
    Read error = nullptr;              ///< null: the figure is exact or has no estimate
    bool apart = false;                ///< the errors stand in a group or object of their own
    char const* key = nullptr;         ///< in JSON, before the unit; null: the name
    char const* error_name = nullptr;  ///< of the error, before the unit; null: by the rule above
    char const* former = nullptr;      ///< what the format before called it: its key where it has one, else its name
    unsigned absent = 0;
    bool as_length = false;  ///< JSON also gives the angle as a length at the pitch circle
    bool bound = false;      ///< a bound that follows from errors: without their estimates it means nothing
    Text text = {};

    template <auto... members>
    [[nodiscard]] constexpr FigureOf with_error() const
    {
        return with_error(path::number<members...>);
    }
    [[nodiscard]] constexpr FigureOf with_error(Read read) const { return with(&FigureOf::error, read); }
    /// The errors stand apart, read by @p read.
    [[nodiscard]] constexpr FigureOf with_error_apart(Read read) const
    {
        return with_error(read).with(&FigureOf::apart, true);
    }
    /// The errors stand apart: the same member of another record, which holds the errors.
    [[nodiscard]] constexpr FigureOf with_error_apart() const { return with_error_apart(value); }
    [[nodiscard]] constexpr FigureOf keyed(char const* stem, char const* error_stem = nullptr) const
    {
        return with(&FigureOf::key, stem).with(&FigureOf::error_name, error_stem);
    }
    /// Under its former name too, until the next format version drops that. Its error follows.
    [[nodiscard]] constexpr FigureOf formerly(char const* stem) const { return with(&FigureOf::former, stem); }
    [[nodiscard]] constexpr FigureOf without(unsigned places) const { return with(&FigureOf::absent, absent | places); }
    [[nodiscard]] constexpr FigureOf and_as_length() const { return with(&FigureOf::as_length, true); }
    [[nodiscard]] constexpr FigureOf from_errors() const { return with(&FigureOf::bound, true); }
    [[nodiscard]] constexpr FigureOf printed(Text const& how) const { return with(&FigureOf::text, how); }

    /// The same figure as the format before called it. @pre former != nullptr
    [[nodiscard]] constexpr FigureOf under_former_name() const
    {
        return with(key != nullptr ? &FigureOf::key : &FigureOf::name, former).with(&FigureOf::former, nullptr);
    }

    [[nodiscard]] bool is_in(Absent place) const
    {
        bool const of_error = place == hdf5_error || place == json_error;
        return (absent & place) == 0 && (!of_error || error != nullptr);
    }
    [[nodiscard]] std::string key_stem() const { return key != nullptr ? key : name; }
    [[nodiscard]] std::string column_of_error() const
    {
        return apart ? name : error_name != nullptr ? error_name : std::string(name) + "_error";
    }
    [[nodiscard]] std::string json_key() const { return key_stem() + unit.suffix(); }
    [[nodiscard]] std::string json_key_of_error() const
    {
        return (apart ? key_stem() : error_name != nullptr ? error_name : key_stem() + "_error") + unit.suffix();
    }

    /// Units of value and error in the printed summary.
    [[nodiscard]] Unit const& text_unit() const { return text.unit != nullptr ? *text.unit : unit; }
    [[nodiscard]] Unit const& text_unit_of_error() const
    {
        return text.error_unit != nullptr ? *text.error_unit : text_unit();
    }
    /// Value and error as the printed summary shows them, without a unit.
    [[nodiscard]] std::string value_text(Record const& record) const
    {
        return text.value(text_unit().shown(value(record)));
    }
    [[nodiscard]] std::string error_text(Record const& record) const
    {
        return text.error(text_unit_of_error().shown(error(record)));
    }
    /// "24.347000 mm"
    [[nodiscard]] std::string value_with_unit(Record const& record) const
    {
        return value_text(record) + " " + text_unit().text;
    }
    /// "+- 0.0032 um"
    [[nodiscard]] std::string error_with_unit(Record const& record) const
    {
        return "+- " + error_text(record) + " " + text_unit_of_error().text;
    }

  private:
    /// A copy whose @p member is @p changed.
    template <class Member>
    [[nodiscard]] constexpr FigureOf with(Member FigureOf::*member, std::type_identity_t<Member> const& changed) const
    {
        FigureOf row = *this;
        row.*member = changed;
        return row;
    }
};

/// The figure at the end of a path of members; its kind is that of the member's type.
template <auto first, auto... rest>
[[nodiscard]] constexpr auto figure(char const* name, Unit const& unit, char const* meaning, Text const& text = {})
{
    using Record = decltype(path::owner_of(first));
    using Value = decltype(path::read<first, rest...>(std::declval<Record const&>()));
    constexpr Kind kind = std::is_same_v<Value, bool> ? Kind::flag
                          : std::is_integral_v<Value> ? Kind::count
                                                      : Kind::number;
    return FigureOf<Record>{name, unit, meaning, path::number<first, rest...>, kind}.printed(text);
}

/// A figure and its error, both members of the record.
template <auto value, auto error>
[[nodiscard]] constexpr auto pair(char const* name, Unit const& unit, char const* meaning, Text const& text = {})
{
    return figure<value>(name, unit, meaning, text).template with_error<error>();
}

/// Whether the error of a figure says that it is not known: it exceeds a third of it, or is NaN.
[[nodiscard]] inline bool is_unconverged(double value, double error)
{
    return !std::isnan(value) && !(3 * error <= std::abs(value));
}

/// The same of a row. @param errors  record that holds its error: @p record, unless errors stand apart
template <class Record>
[[nodiscard]] bool is_unconverged(FigureOf<Record> const& row, Record const& record, Record const& errors)
{
    return row.error != nullptr && is_unconverged(row.value(record), row.error(errors));
}

/// A table: all figures of a @p Record, in their order in JSON.
template <class Record>
struct Rows : std::span<FigureOf<Record> const>
{
    using std::span<FigureOf<Record> const>::span;

    /// Calls @p act with every row and, where a row has one, with the row under its former name.
    template <class Act>
    void for_each_name(Act act) const
    {
        for (auto const& row : *this) {
            act(row);
            if (row.former != nullptr)
                act(row.under_former_name());
        }
    }

    /// The first row called @p name. @throws std::logic_error where there is none
    [[nodiscard]] FigureOf<Record> const& operator[](std::string_view name) const
    {
        for (auto const& row : *this)
            if (name == row.name)
                return row;
        throw std::logic_error("no figure is called " + std::string(name));
    }
};

}  // namespace hdconj::figures
