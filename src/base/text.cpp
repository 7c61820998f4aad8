// SPDX-License-Identifier: GPL-3.0-or-later
#include "text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

namespace hdconj {
namespace {

bool is_control(unsigned char byte)
{
    constexpr unsigned char first_printable = 0x20;
    constexpr unsigned char delete_key = 0x7f;
    return byte < first_printable || byte == delete_key;
}

bool continues_sequence(char byte)
{
    return (static_cast<unsigned char>(byte) & 0xc0u) == 0x80u;
}

std::string escaped(unsigned char byte)
{
    constexpr std::string_view digits = "0123456789abcdef";
    return {'\\', 'x', digits[byte >> 4u], digits[byte & 0xfu]};
}

}  // namespace

std::string number_text(double value)
{
    constexpr double least_plain = 1e-4;
    constexpr double first_long = 1e7;
    double const size = std::abs(value);
    bool const plain = value == 0 || (size >= least_plain && size < first_long);
    std::array<char, 32> buffer{};  // the longest shortest double has 24 characters
    auto const format = plain ? std::chars_format::fixed : std::chars_format::general;
    auto const result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format);
    return {buffer.data(), result.ptr};
}

std::string short_number(double value, int digits)
{
    return fmt::format("{:.{}g}", value, digits);
}

std::string at_least_text(double bound)
{
    std::string const text = short_number(bound);
    if (std::strtod(text.c_str(), nullptr) >= bound)
        return text;
    double const last_digit = std::pow(10.0, std::floor(std::log10(std::abs(bound))) - 5);
    return short_number(bound + last_digit);
}

std::string at_most_text(double bound)
{
    std::string const text = at_least_text(-bound);
    return text.front() == '-' ? text.substr(1) : '-' + text;
}

std::string length_at_least(double bound)
{
    return short_number(std::ceil(bound * told_per_mm) / told_per_mm);
}

std::string in_quotes(std::string_view text)
{
    return '"' + std::string(text) + '"';
}

std::string printable(std::string_view text, std::size_t most)
{
    std::size_t length = text.size();
    if (length > most) {
        length = most;
        while (length > 0 && continues_sequence(text[length]))
            --length;
    }
    std::string shown;
    for (char const c : text.substr(0, length)) {
        auto const byte = static_cast<unsigned char>(c);
        shown += is_control(byte) ? escaped(byte) : std::string(1, c);
    }
    return length < text.size() ? shown + "..." : shown;
}

std::optional<NumberInText> leading_number(std::string text)
{
    std::replace(text.begin(), text.end(), ',', '.');
    std::size_t const first = text.find_first_not_of(" \t+");
    if (first == std::string::npos)
        return std::nullopt;
    double value = 0;
    char const* const end = text.data() + text.size();
    auto const [stop, error] = std::from_chars(text.data() + first, end, value);
    if (error != std::errc{} || !std::isfinite(value))
        return std::nullopt;
    std::string rest(stop, end);
    rest.erase(0, std::min(rest.find_first_not_of(" \t"), rest.size()));
    return NumberInText{value, rest};
}

std::string quoted_list(std::vector<std::string_view> const& words)
{
    std::string list;
    for (std::size_t i = 0; i < words.size(); ++i) {
        char const* const joint = i == 0 ? "" : i + 1 == words.size() ? " or " : ", ";
        list += joint + in_quotes(words[i]);
    }
    return list;
}

std::string plain_list(std::vector<std::string_view> const& words)
{
    std::string list;
    for (auto const word : words)
        list += (list.empty() ? "" : ", ") + std::string(word);
    return list;
}

}  // namespace hdconj
