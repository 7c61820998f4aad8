// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene_document.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "base/text.hpp"
#include "hdconj/scene/schema.hpp"
#include "scene_text.hpp"

namespace hdconj::io {
namespace {

using Kind = scene::RawValue::Kind;

Kind kind_of(toml::node const& node)
{
    using Type = toml::node_type;
    constexpr std::array kinds = {
        std::pair{Type::boolean, Kind::boolean},       std::pair{Type::integer, Kind::integer},
        std::pair{Type::floating_point, Kind::number}, std::pair{Type::string, Kind::text},
        std::pair{Type::array, Kind::array},           std::pair{Type::table, Kind::table}};
    auto const found =
        std::find_if(kinds.begin(), kinds.end(), [&](auto const& each) { return each.first == node.type(); });
    return found != kinds.end() ? found->second : Kind::date;
}

/// Items of all lists of a scene; a list cut here is refused for its length.
constexpr std::size_t most_items = 3 * scene::bounds::most_rows + 1;

/// Tables that --set had to create have no place at all; everything parsed has one.
bool is_override(toml::node const& node)
{
    auto const& source = node.source();
    return source.path ? *source.path == override_origin : source.begin.line == 0;
}

class Converter
{
  public:
    explicit Converter(std::string_view text) : lines_(text) {}

    scene::RawValue value(toml::node const& node) const
    {
        scene::RawValue raw;
        raw.kind = kind_of(node);
        raw.written = node.is_table() ? "" : written(node);
        if (auto const* const table = node.as_table()) {
            raw.entries = entries(*table);
        } else if (auto const* const array = node.as_array()) {
            raw.items = items(*array);
        } else if (auto const text = node.value_exact<std::string>()) {
            raw.text = *text;
        } else if (auto const* const integer = node.as_integer()) {
            raw.number = static_cast<double>(integer->get());
        } else if (auto const* const number = node.as_floating_point()) {
            raw.number = number->get();
        }
        return raw;
    }

  private:
    /// The text of an item is not kept: a list may hold thousands of numbers, all on one line.
    std::vector<scene::RawValue> items(toml::array const& array) const
    {
        std::vector<scene::RawValue> items;
        for (auto const& node : array) {
            if (items_ == most_items)
                break;
            ++items_;
            scene::RawValue raw;
            raw.kind = kind_of(node);
            raw.line = is_override(node) ? 0 : static_cast<int>(node.source().begin.line);
            if (auto const* const inner = node.as_array()) {
                raw.items = this->items(*inner);
            } else if (auto const number = node.value<double>(); number && !node.is_string()) {
                raw.number = *number;
            }
            items.push_back(std::move(raw));
        }
        return items;
    }

    std::vector<scene::RawEntry> entries(toml::table const& table) const
    {
        std::vector<scene::RawEntry> entries;
        for (auto const& [key, node] : table) {
            bool const from_override = is_override(node);
            int const line = from_override ? 0 : static_cast<int>(key.source().begin.line);
            entries.push_back(
                {std::string(key.str()), value(node), line, from_override ? std::string(override_origin) : ""});
        }
        std::stable_sort(entries.begin(), entries.end(),
                         [](scene::RawEntry const& a, scene::RawEntry const& b) { return a.line < b.line; });
        return entries;
    }

    /// As in the file; a value of --set in the form TOML gives it; nothing of a list of several lines, which is shown
    /// by its numbers.
    std::string written(toml::node const& node) const
    {
        auto const& source = node.source();
        if (node.is_array() && source.begin.line != source.end.line)
            return "";
        bool const in_file = !is_override(node) && source.end.line >= source.begin.line;
        std::string const found = in_file ? lines_.cut(source.begin, source.end) : "";
        return printable(found.empty() ? toml_text(node) : found);
    }

    TextLines lines_;
    mutable std::size_t items_ = 0;
};

}  // namespace

scene::RawValue raw_of(toml::table const& table, std::string_view text)
{
    return Converter(text).value(table);
}

}  // namespace hdconj::io
