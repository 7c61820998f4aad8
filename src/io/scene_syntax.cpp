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

std::string remedy_for(std::string_view line, std::string_view description)
{
    if (description.find("redefine") != std::string_view::npos) {
        return "keep one of the two";
    }
    if (description.find("utf-8") != std::string_view::npos || description.find("UTF-8") != std::string_view::npos) {
        return "save the file as UTF-8";
    }
    std::string_view const code = trimmed(line.substr(0, line.find('#')));
    std::size_t const equals = code.find('=');
    if (equals != std::string_view::npos && equals > 0) {
        auto const remedy = remedy_for_value(trimmed(code.substr(0, equals)), trimmed(code.substr(equals + 1)));
        if (!remedy.empty()) {
            return remedy;
        }
    }
    return "write lines of the form [table] or key = value, text in double quotes";
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
    return {name, static_cast<int>(place.line), printable(trimmed(line)),
            "not TOML at column " + std::to_string(place.column) + ": " + reason_of(error),
            remedy_for(line, error.description())};
}

}  // namespace hdconj::detail
