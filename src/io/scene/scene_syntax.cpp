// SPDX-License-Identifier: GPL-3.0-or-later
// What to say where TOML itself is broken: mostly a unit, a decimal comma or forgotten quotes.
#include <algorithm>
#include <array>

#include "base/text.hpp"
#include "file/csv.hpp"
#include "scene/column_units.hpp"
#include "scene_document.hpp"
#include "scene_text.hpp"

namespace hdconj::io {
namespace {

constexpr std::string_view blanks = " \t\r";

bool is_word_of_letters(std::string_view text)
{
    return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' || c == '_';
    });
}

/// The remedy for a number with its unit behind it; empty where that is none. Lengths and angles are told apart by the
/// name of their key.
std::string remedy_for_unit(std::string_view key, NumberInText const& number)
{
    auto const quantity = key.ends_with("_deg") ? scene::ColumnQuantity::angle : scene::ColumnQuantity::length;
    auto const factor = scene::factor_of_unit(number.rest, quantity);
    if (!factor && !is_word_of_letters(number.rest))
        return "";
    return (factor ? "write " + number_text(scene::in_other_unit(number.value, *factor)) : "write a number") +
           " without a unit: lengths are in mm, angles in degrees";
}

/// The remedy for the value of a line "key = value"; empty when the value looks right.
std::string remedy_for_value(std::string_view key, std::string_view value)
{
    if (value.empty())
        return "write a value after the = sign";
    if (is_word_of_letters(value))
        return "write " + std::string(key) + " = " + in_quotes(value) + ", text needs quotes";
    auto const number = leading_number(std::string(value));
    bool const has_comma = number && value.find(',') != std::string_view::npos;
    if (has_comma && number->rest.empty())
        return "write " + number_text(number->value) + ", with a decimal point";
    if (number && !number->rest.empty())
        return remedy_for_unit(key, *number);
    return "";
}

/// A line "key = value", comment cut off; empty parts when it is no such line.
struct KeyLine
{
    std::string_view key;
    std::string_view value;
};

KeyLine key_line(std::string_view line)
{
    std::string_view const code = file::trimmed(line.substr(0, line.find('#')), blanks);
    std::size_t const equals = code.find('=');
    if (equals == std::string_view::npos)
        return {};
    auto const key = file::trimmed(code.substr(0, equals), blanks);
    bool const is_plain = std::all_of(key.begin(), key.end(), [](char c) { return is_key_character(c) || c == '.'; });
    return is_plain ? KeyLine{key, file::trimmed(code.substr(equals + 1), blanks)} : KeyLine{};
}

std::string remedy_for(KeyLine const& line, std::string_view description)
{
    if (description.find("redefine") != std::string_view::npos)
        return "keep one of the two";
    if (description.find("utf-8") != std::string_view::npos || description.find("UTF-8") != std::string_view::npos)
        return "save the file as UTF-8";
    auto const remedy = line.key.empty() ? "" : remedy_for_value(line.key, line.value);
    return remedy.empty() ? "write lines of the form [table] or key = value, text in double quotes" : remedy;
}

/// A piece of what the parser says, and what it means for a scene.
struct PlainWords
{
    std::string_view parser, plain;
};

constexpr std::array plain_words{
    PlainWords{"redefine", "this name stands twice"},
    PlainWords{"nested", "brackets are nested too deeply"},
    PlainWords{"expected ']'", "a closing bracket ] is missing"},
    PlainWords{"expected '='", "neither a [table] nor key = value"},
    PlainWords{"expected keys, tables", "neither a [table] nor key = value"},
    PlainWords{"blank bare keys", "the brackets hold no name"},
    PlainWords{"expected bare key", "a name is missing there, or begins with a character that none has"},
    PlainWords{"expected a comment or whitespace", "the value goes on where only a comment may follow"}};

/// What is wrong, in words of a scene; else the parser's, with a small first letter and without the full stop.
std::string reason_of(toml::parse_error const& error)
{
    std::string reason(error.description());
    for (auto const& [parser, plain] : plain_words)
        if (reason.find(parser) != std::string::npos)
            return std::string(plain);
    while (!reason.empty() && (reason.back() == '.' || reason.back() == ' '))
        reason.pop_back();
    if (!reason.empty() && reason.front() == 'E')
        reason.front() = 'e';
    return printable(reason, 200);
}

}  // namespace

Fault syntax_fault(toml::parse_error const& error, std::string_view text, std::string const& name)
{
    auto const& place = error.source().begin;
    auto const line = TextLines(text).line(place.line);
    auto const parts = key_line(line);
    std::string const reason = "not TOML at column " + std::to_string(place.column) + ": " + reason_of(error);
    std::string const remedy = remedy_for(parts, error.description());
    if (parts.key.empty()) {
        return {name, static_cast<int>(place.line), "",
                reason + ", in " + in_quotes(printable(file::trimmed(line, blanks))), remedy};
    }
    return {printable(parts.key), static_cast<int>(place.line), printable(parts.value), reason, remedy};
}

}  // namespace hdconj::io
