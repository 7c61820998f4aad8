// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>
#include <utility>
#include <vector>

#include "base/text.hpp"
#include "scene_document.hpp"
#include "scene_text.hpp"

namespace hdconj::io {
namespace {

using Member = std::pair<std::string, toml::node const*>;

std::string string_text(std::string const& text)
{
    std::ostringstream stream;
    auto const flags = toml::toml_formatter::default_flags & ~toml::format_flags::allow_literal_strings &
                       ~toml::format_flags::allow_multi_line_strings;
    toml::value<std::string> const value(text);
    stream << toml::toml_formatter{value, flags};
    return std::move(stream).str();
}

/// A number that TOML reads as a floating-point one.
std::string float_text(double value)
{
    std::string const text = number_text(value);
    bool const is_whole = std::isfinite(value) && text.find_first_of(".e") == std::string::npos;
    return is_whole ? text + ".0" : text;
}

bool has_tables(toml::array const& array)
{
    return std::any_of(array.begin(), array.end(), [](toml::node const& item) { return item.is_table(); });
}

std::string value_text(toml::node const& node)
{
    if (auto const* const number = node.as_floating_point())
        return float_text(number->get());
    if (auto const* const text = node.as_string())
        return string_text(text->get());
    if (auto const* const array = node.as_array(); array != nullptr && !array->empty() && !has_tables(*array)) {
        std::string items;
        for (auto const& item : *array)
            items += (items.empty() ? "[ " : ", ") + value_text(item);
        return items + " ]";
    }
    std::ostringstream stream;
    node.visit([&stream](auto const& value) { stream << value; });
    return std::move(stream).str();
}

std::string key_text(std::string_view key)
{
    bool const is_bare = !key.empty() && std::all_of(key.begin(), key.end(), is_key_character);
    return is_bare ? std::string(key) : string_text(std::string(key));
}

/// Members of @p table by line, those without a line last.
std::vector<Member> in_order(toml::table const& table)
{
    std::multimap<std::size_t, Member> members;  // equal lines in their order in the table
    for (auto const& [key, node] : table) {
        std::size_t const line = key.source().begin.line;
        members.insert({line == 0 ? std::numeric_limits<std::size_t>::max() : line, {key_text(key.str()), &node}});
    }
    std::vector<Member> sorted;
    for (auto& [line, member] : members)
        sorted.push_back(std::move(member));
    return sorted;
}

void write_table(std::string& text, std::string const& path, toml::table const& table)
{
    auto const members = in_order(table);
    auto const is_table = [](Member const& member) { return member.second->is_table(); };
    bool const only_tables = !members.empty() && std::all_of(members.begin(), members.end(), is_table);
    if (!path.empty() && !only_tables)
        text += (text.empty() ? "[" : "\n[") + path + "]\n";
    for (auto const& [key, node] : members)
        if (!node->is_table())
            text += key + " = " + value_text(*node) + "\n";
    for (auto const& [key, node] : members)
        if (auto const* const inner = node->as_table())
            write_table(text, path.empty() ? key : path + "." + key, *inner);
}

}  // namespace

std::string toml_text(toml::node const& node)
{
    auto const* const table = node.as_table();
    if (table == nullptr)
        return value_text(node);
    std::string text;
    write_table(text, "", *table);
    return text;
}

}  // namespace hdconj::io
