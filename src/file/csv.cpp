// SPDX-License-Identifier: GPL-3.0-or-later
#include "csv.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>
#include <system_error>

namespace hdconj::file {
namespace {

using TakeLine = std::function<bool(std::string_view line, int number)>;

/// Opens @p file into @p in.
std::optional<Unreadable> open(std::filesystem::path const& file, std::uintmax_t largest, std::ifstream& in)
{
    std::error_code ignored;
    if (std::filesystem::is_directory(file, ignored))
        return Unreadable::is_folder;
    in.open(file);
    if (!in)
        return Unreadable::not_opened;
    if (!std::filesystem::is_regular_file(file, ignored))
        return Unreadable::endless;
    if (std::filesystem::file_size(file, ignored) > largest)
        return Unreadable::too_large;
    return std::nullopt;
}

void take_lines(std::istream& in, TakeLine const& take)
{
    constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
    std::string line;
    for (int number = 1; std::getline(in, line); ++number) {
        std::string_view text = line;
        if (number == 1 && text.starts_with(byte_order_mark))
            text.remove_prefix(byte_order_mark.size());
        if (!take(text, number))
            break;
    }
}

/// @p take of lines that are neither blank nor a comment.
TakeLine rows_only(TakeLine const& take)
{
    return [&take](std::string_view line, int number) {
        std::string_view const content = trimmed(line);
        return content.empty() || content.front() == '#' || take(line, number);
    };
}

}  // namespace

std::optional<Unreadable> read_lines(std::filesystem::path const& file, std::uintmax_t largest, TakeLine const& take)
{
    std::ifstream in;
    auto const refused = open(file, largest, in);
    if (!refused)
        take_lines(in, take);
    return refused;
}

std::optional<Unreadable> read_csv(std::filesystem::path const& file, std::uintmax_t largest, TakeLine const& take)
{
    return read_lines(file, largest, rows_only(take));
}

std::optional<Unreadable> read_csv(std::filesystem::path const& file, std::string const* content,
                                   std::uintmax_t largest, TakeLine const& take)
{
    if (content == nullptr)
        return read_csv(file, largest, take);
    std::istringstream in(*content);
    take_lines(in, rows_only(take));
    return std::nullopt;
}

std::shared_ptr<std::string const> whole_text(std::filesystem::path const& file, std::uintmax_t largest)
{
    std::ifstream in;
    if (open(file, largest, in))
        return nullptr;
    return std::make_shared<std::string const>(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
}

std::string_view trimmed(std::string_view text, std::string_view blanks)
{
    auto const begin = text.find_first_not_of(blanks);
    return begin == std::string_view::npos ? std::string_view()
                                           : text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

std::string lower_case(std::string_view text, std::string_view without)
{
    std::string result;
    for (char const c : text)
        if (without.find(c) == std::string_view::npos)
            result += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return result;
}

char separator_of(std::string_view line)
{
    auto const found = line.find(';') != std::string_view::npos ? line.find(';') : line.find('\t');
    return found != std::string_view::npos ? line[found] : ',';
}

std::vector<std::string_view> fields_of(std::string_view line, char separator)
{
    std::vector<std::string_view> fields;
    for (std::size_t begin = 0;;) {
        auto const end = line.find(separator, begin);
        fields.push_back(trimmed(line.substr(begin, end == std::string_view::npos ? end : end - begin)));
        if (end == std::string_view::npos)
            return fields;
        begin = end + 1;
    }
}

std::optional<double> number_in(std::string_view field)
{
    double value = 0;
    char const* const end = field.data() + field.size();
    if (field.starts_with('+'))
        field.remove_prefix(1);
    auto const [next, error] = std::from_chars(field.data(), end, value);
    return error == std::errc{} && next == end && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

Heading heading_of(std::string_view text)
{
    auto const open = text.find_first_of("[(");
    auto const close = text.find_first_of("])", open == std::string_view::npos ? 0 : open);
    Heading heading{trimmed(text.substr(0, open)), std::nullopt};
    if (open != std::string_view::npos && close != std::string_view::npos)
        heading.unit = text.substr(open + 1, close - open - 1);
    return heading;
}

std::optional<double> factor_of(std::span<ColumnUnit const> units, std::string_view name)
{
    auto const found =
        std::find_if(units.begin(), units.end(), [&](ColumnUnit const& each) { return each.name == name; });
    return found == units.end() ? std::nullopt : std::optional(found->factor);
}

}  // namespace hdconj::file
