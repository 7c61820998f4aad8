// SPDX-License-Identifier: GPL-3.0-or-later
#include "file/csv.hpp"
#include "scene_document.hpp"

#include <algorithm>
#include <optional>
#include <string_view>

#include "base/text.hpp"
#include "scene_text.hpp"

namespace hdconj::io {
namespace {

constexpr std::size_t most_parts = 8;  ///< of a key path; a scene needs three

Fault fault_of(std::string const& given, std::string reason, std::string remedy)
{
    std::string const shown = given.empty() ? "\"\"" : printable(given);
    return {shown, 0, "", std::move(reason), std::move(remedy), std::string(override_origin)};
}

/// The parts of "a.b.c"; empty when that is no key path.
std::vector<std::string> parts_of(std::string_view path)
{
    std::vector<std::string> parts{""};
    for (char const c : file::trimmed(path, " ")) {
        if (c == '.') {
            parts.emplace_back();
        } else if (is_key_character(c)) {
            parts.back() += c;
        } else {
            return {};
        }
    }
    bool const has_empty = std::find(parts.begin(), parts.end(), "") != parts.end();
    return has_empty || parts.size() > most_parts ? std::vector<std::string>{} : parts;
}

/// A word that may do without quotes on a command line: no character that means something in TOML.
bool is_bare_word(std::string_view text)
{
    return !text.empty() && std::none_of(text.begin(), text.end(), [](char c) {
        return static_cast<unsigned char>(c) < 0x20 || c == 0x7f ||
               std::string_view("\"'\\[]{}#=").find(c) != std::string_view::npos;
    });
}

std::optional<toml::table> parsed(std::string const& value)
{
    std::string const line = "value = " + value;
    if (line.find('\n') != std::string::npos || !unparsable(line, "").empty())
        return std::nullopt;
    try {
        toml::table table = toml::parse(line, override_origin);
        return table.size() == 1 ? std::optional(std::move(table)) : std::nullopt;
    } catch (toml::parse_error const&) {
        return std::nullopt;
    }
}

/// The table of @p document that holds the last of @p parts; null when a value is in the way.
toml::table* holder_of(toml::table& document, std::vector<std::string> const& parts, bool create)
{
    toml::table* table = &document;
    for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
        if (create)
            table->insert(parts[i], toml::table{});  // where there is none
        toml::node* const next = table->get(parts[i]);
        table = next == nullptr ? nullptr : next->as_table();
        if (table == nullptr)
            return nullptr;
    }
    return table;
}

std::optional<Fault> set_value(toml::table& document, std::string const& given, std::size_t equals)
{
    auto const parts = parts_of(std::string_view(given).substr(0, equals));
    if (parts.empty()) {
        return fault_of(given, "no key path before the = sign",
                        "write --set key.path=value, such as --set flexspline.wall=0.8");
    }
    std::string const value(file::trimmed(std::string_view(given).substr(equals + 1), " "));
    auto table = parsed(value);
    if (!table && is_bare_word(value))
        table = parsed(in_quotes(value));
    if (!table) {
        return fault_of(given, value.empty() ? "no value after the = sign" : "the value is not a TOML value",
                        "write a number, or text, such as --set solver.kinematics=first-order");
    }
    toml::table* const holder = holder_of(document, parts, true);
    if (holder == nullptr) {
        Fault fault = fault_of(given.substr(0, equals), "a part of the key path is a value, not a table",
                               "write the path of a key, such as flexspline.wall");
        fault.kind = FaultKind::unknown;
        return fault;
    }
    table->get("value")->visit([&](auto& node) { holder->insert_or_assign(parts.back(), std::move(node)); });
    return std::nullopt;
}

std::optional<Fault> remove(toml::table& document, std::string const& given)
{
    auto const parts = parts_of(std::string_view(given).substr(1));
    toml::table* const holder = parts.empty() ? nullptr : holder_of(document, parts, false);
    if (holder != nullptr && holder->erase(parts.back()) > 0)
        return std::nullopt;
    return fault_of(given, "there is no such key or table to remove",
                    "write --set '!tilt' for a table that is in the scene");
}

std::optional<Fault> apply(toml::table& document, std::string const& given)
{
    if (given.starts_with('!'))
        return remove(document, given);
    std::size_t const equals = given.find('=');
    if (equals == std::string::npos)
        return fault_of(given, "no = sign", "write --set key.path=value, such as --set flexspline.wall=0.8");
    return set_value(document, given, equals);
}

}  // namespace

Faults apply_overrides(toml::table& document, std::vector<std::string> const& overrides)
{
    Faults faults;
    for (auto const& given : overrides)
        if (auto fault = apply(document, given))
            faults.push_back(std::move(*fault));
    return faults;
}

}  // namespace hdconj::io
