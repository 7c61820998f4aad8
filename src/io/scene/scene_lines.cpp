// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene_lines.hpp"

#include <algorithm>

namespace hdconj::io {
namespace {

constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

bool continues_code_point(char byte)
{
    return (static_cast<unsigned char>(byte) & 0xc0u) == 0x80u;
}

/// Index of the byte where column @p column of @p line begins.
std::size_t byte_of(std::string_view line, std::size_t column)
{
    std::size_t current = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        current += continues_code_point(line[i]) ? 0 : 1;
        if (current == column)
            return i;
    }
    return line.size();
}

}  // namespace

TextLines::TextLines(std::string_view text) : text_(text), starts_{0}
{
    if (text_.starts_with(byte_order_mark))
        text_.remove_prefix(byte_order_mark.size());
    for (std::size_t at = text_.find('\n'); at != std::string_view::npos; at = text_.find('\n', at + 1))
        starts_.push_back(at + 1);
}

std::string_view TextLines::line(std::size_t number) const
{
    if (number == 0 || number > starts_.size()) {
        return {};
    }
    std::size_t const begin = starts_[number - 1];
    std::string_view found = text_.substr(begin, std::min(text_.find('\n', begin), text_.size()) - begin);
    while (!found.empty() && found.back() == '\r')
        found.remove_suffix(1);
    return found;
}

std::string TextLines::columns(std::size_t number, std::size_t first, std::size_t last) const
{
    auto const whole = line(number);
    std::size_t const begin = byte_of(whole, first);
    std::size_t const end = std::max(begin, byte_of(whole, last));
    return std::string(whole.substr(begin, end - begin));
}

}  // namespace hdconj::io
