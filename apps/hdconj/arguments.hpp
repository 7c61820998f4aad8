// SPDX-License-Identifier: GPL-3.0-or-later
// Options of verbs, and what is checked of their values while the command line is parsed.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "hdconj/scene_words.hpp"
#include "hdconj/units.hpp"

namespace hdconj::cli {

/// What is wrong with a value on the command line, or nothing.
using Check = std::function<std::string(std::string const&)>;

/// A name of a file or folder. An empty one, as from an unset shell variable, must not quietly mean the default.
[[nodiscard]] std::string is_name(std::string const& given);
/// A finite number, or one above 0. @param remedy  "write a ratio such as --ratio 100"
[[nodiscard]] Check finite_number(std::string const& remedy);
[[nodiscard]] Check positive_number(std::string const& remedy);
/// An angle in degrees. @param remedy  "an angle in degrees such as 0.2"
[[nodiscard]] Check angle(std::string const& remedy);
/// A whole number in a range, which the help names. CLI11's own speaks otherwise from version to version.
[[nodiscard]] CLI::Validator whole_number(int least, int most);
[[nodiscard]] Check one_of(std::vector<std::string_view> words);

/// One of the words of an enumeration.
template <Worded Enumeration>
[[nodiscard]] Check one_of()
{
    return one_of({words_of<Enumeration>.begin(), words_of<Enumeration>.end()});
}

/// The values that @p words stand for, which have been checked.
template <Worded Enumeration>
[[nodiscard]] std::vector<Enumeration> values_of(std::vector<std::string> const& words)
{
    std::vector<Enumeration> values;
    for (auto const& word : words)
        values.push_back(from_word<Enumeration>(word).value());
    return values;
}

/// Adds an option with one value.
/// @param type  how the help calls the value
template <class Value, class ValueCheck>
void add_option(CLI::App& verb, std::string const& name, Value& value, std::string const& meaning,
                std::string const& type, ValueCheck const& check)
{
    verb.add_option(name, value, meaning)->check(check)->type_name(type);
}

/// Adds an option whose value is the name of a file or folder.
void add_name(CLI::App& verb, std::string const& name, std::string& value, std::string const& meaning,
              std::string const& type = "TEXT");

/// Adds an option whose value is a list with commas, such as `--dialect dxf,csv`. The parser's own lists would drop
/// empty items without a word; here they are refused.
/// @param check  of each item; null: any will do
void add_list(CLI::App& verb, std::string const& name, std::vector<std::string>& items, std::string const& meaning,
              std::string const& type, Check const& check = {});

/// Which tilts, surfaces and kinds of tilt `contact` and `load` are asked for; each empty: the scene's.
struct CaseArguments
{
    std::vector<std::string> tilts_deg;
    std::vector<std::string> surfaces;
    std::vector<std::string> kinds;

    /// Enters them into the options of a study, tilts in rad.
    void enter(auto& options) const
    {
        for (auto const& tilt : tilts_deg)
            options.tilts.push_back(std::strtod(tilt.c_str(), nullptr) * deg);
        options.surfaces = values_of<ToothSurface>(surfaces);
        options.kinds = values_of<TiltKind>(kinds);
    }
};

/// Adds --tilt, --surface and --kind.
void add_case_options(CLI::App& verb, CaseArguments& cases, std::string const& meaning_of_tilt);

}  // namespace hdconj::cli
