// SPDX-License-Identifier: GPL-3.0-or-later
// What to say where TOML itself is broken: mostly a unit, a decimal comma or forgotten quotes.
#include <algorithm>

#include "scene/text.hpp"
#include "scene_document.hpp"
#include "scene_lines.hpp"

namespace hdconj::detail {
namespace {

std::string_view trimmed(std::string_view text)
{
    constexpr std::string_view blank = " \t\r";
    std::size_t const first = text.find_first_not_of(blank);
    return first == std::string_view::npos ? std::string_view{}
                                           : text.substr(first, text.find_last_not_of(blank) - first + 1);
}

bool is_key_character(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
}

bool is_bare_word(std::string_view text)
{
    return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' || c == '_';
    });
}

/// The remedy for the value of a line "key = value"; empty when the value looks right.
std::string remedy_for_value(std::string_view key, std::string_view value)
{
    if (value.empty()) {
        return "write a value after the = sign";
    }
    if (is_bare_word(value)) {
        return "write " + std::string(key) + " = " + in_quotes(value) + ", text needs quotes";
    }
    auto const number = leading_number(std::string(value));
    bool const has_comma = number && value.find(',') != std::string_view::npos;
    if (has_comma && number->rest.empty()) {
        return "write " + number_text(number->value) + ", with a decimal point";
    }
    if (number && is_bare_word(number->rest)) {
        return "write " + number_text(number->value) + " without a unit: lengths are in mm, angles in degrees";
    }
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
    std::string_view const code = trimmed(line.substr(0, line.find('#')));
    std::size_t const equals = code.find('=');
    if (equals == std::string_view::npos) {
        return {};
    }
    auto const key = trimmed(code.substr(0, equals));
    bool const is_plain = std::all_of(key.begin(), key.end(), [](char c) { return is_key_character(c) || c == '.'; });
    return is_plain ? KeyLine{key, trimmed(code.substr(equals + 1))} : KeyLine{};
}

std::string remedy_for(KeyLine const& line, std::string_view description)
{
    if (description.find("redefine") != std::string_view::npos) {
        return "keep one of the two";
    }
    if (description.find("utf-8") != std::string_view::npos || description.find("UTF-8") != std::string_view::npos) {
        return "save the file as UTF-8";
    }
    auto const remedy = line.key.empty() ? "" : remedy_for_value(line.key, line.value);
    return remedy.empty() ? "write lines of the form [table] or key = value, text in double quotes" : remedy;
}

/// The parser's words, with a small first letter and without the full stop.
std::string reason_of(toml::parse_error const& error)
{
    std::string reason(error.description());
    while (!reason.empty() && (reason.back() == '.' || reason.back() == ' ')) {
        reason.pop_back();
    }
    if (!reason.empty() && reason.front() == 'E') {
        reason.front() = 'e';
    }
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
        return {name, static_cast<int>(place.line), "", reason + ", in " + in_quotes(printable(trimmed(line))), remedy};
    }
    return {printable(parts.key), static_cast<int>(place.line), printable(parts.value), reason, remedy};
}

}  // namespace hdconj::detail
