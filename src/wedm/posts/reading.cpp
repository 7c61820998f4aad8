// SPDX-License-Identifier: GPL-3.0-or-later
#include "reading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace hdconj::wedm {

void WireLine::refuse(std::string const& cause) const
{
    constexpr std::size_t shown = 80;
    refuse_to_write(fmt::format("{}, line {}", file_, number_),
                    fmt::format("{} in '{}'", cause, text_.substr(0, shown)));
}

double WireLine::number(std::string_view digits) const
{
    double value = 0;
    char const* const end = digits.data() + digits.size();
    auto const found = std::from_chars(digits.data(), end, value, std::chars_format::fixed);
    if (found.ec != std::errc() || found.ptr != end || !std::isfinite(value))
        refuse(fmt::format("'{}' is no number in fixed notation", digits));
    if (value == 0 && std::signbit(value))
        refuse("negative zero");
    return value;
}

long long WireLine::whole(std::string_view digits) const
{
    long long value = 0;
    char const* const end = digits.data() + digits.size();
    auto const found = std::from_chars(digits.data(), end, value);
    if (found.ec != std::errc() || found.ptr != end)
        refuse(fmt::format("'{}' is no whole number", digits));
    return value;
}

std::vector<WireLine> lines_of(WireText const& file)
{
    std::vector<WireLine> lines;
    std::string_view rest = file.text;
    while (!rest.empty()) {
        auto const end = rest.find('\n');
        lines.emplace_back(file.name, lines.size() + 1, rest.substr(0, end));
        if (end == std::string_view::npos)
            lines.back().refuse("the file ends in the middle of a line");
        rest.remove_prefix(end + 1);
    }
    return lines;
}

std::vector<std::string_view> parts_of(std::string_view text, char separator)
{
    std::vector<std::string_view> parts;
    for (;;) {
        auto const end = text.find(separator);
        parts.push_back(text.substr(0, end));
        if (end == std::string_view::npos)
            return parts;
        text.remove_prefix(end + 1);
    }
}

std::vector<WireWord> words_of(WireLine const& line, std::string_view text)
{
    std::vector<WireWord> words;
    for (std::size_t at = 0; at < text.size();) {
        char const c = text[at];
        if (c == ' ') {
            ++at;
        } else if (c == '(') {
            at = text.find(')', at);
            if (at == std::string_view::npos)
                line.refuse("a comment does not end");
            ++at;
        } else if (c >= 'A' && c <= 'Z') {
            auto const end = std::min(text.find_first_not_of("-.0123456789", at + 1), text.size());
            bool const seen = c != 'G' && has_word(words, c);
            if (seen || end == at + 1)
                line.refuse(fmt::format("{} {}", c, seen ? "stands twice" : "has no number"));
            words.push_back({c, text.substr(at + 1, end - at - 1)});
            at = end;
        } else {
            line.refuse(fmt::format("'{}' begins no word", c));
        }
    }
    return words;
}

double value_of(WireLine const& line, std::vector<WireWord> const& words, char letter)
{
    auto const word = std::ranges::find(words, letter, &WireWord::letter);
    if (word == words.end())
        line.refuse(fmt::format("{} is missing", letter));
    return line.number(word->digits);
}

bool has_word(std::vector<WireWord> const& words, char letter)
{
    return std::ranges::find(words, letter, &WireWord::letter) != words.end();
}

void note_stop(WireLine const& line, std::vector<WireWord> const& words, WireProgram const& program, FacePath& path)
{
    auto const word = std::ranges::find(words, 'M', &WireWord::letter);
    if (word == words.end())
        return;
    long long const code = line.whole(word->digits);
    if (code > 1)
        return;  // the end
    if (code != static_cast<long long>(program.stop) || path.lower.empty())
        line.refuse("another stop than asked for");
    path.stops.push_back(path.lower.size() - 1);
}

bool is_straight_move(std::vector<WireWord> const& words)
{
    return std::any_of(words.begin(), words.end(), [](WireWord const& word) {
        return word.letter == 'G' &&
               (word.digits == "0" || word.digits == "00" || word.digits == "1" || word.digits == "01");
    });
}

}  // namespace hdconj::wedm
