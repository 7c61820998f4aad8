// SPDX-License-Identifier: GPL-3.0-or-later
// Reads files of wire programs back, line by line and word by word. Shares nothing with the writers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "post.hpp"

namespace hdconj::wedm {

/// A line of a file, and where it is.
class WireLine
{
  public:
    WireLine(std::string_view file, std::size_t number, std::string_view text)
        : file_(file), number_(number), text_(text)
    {
    }

    [[nodiscard]] std::string_view text() const { return text_; }
    /// @throws NumericalError with file, line and @p cause
    [[noreturn]] void refuse(std::string const& cause) const;
    /// A number in fixed notation, finite, no negative zero; else it is refused.
    [[nodiscard]] double number(std::string_view digits) const;
    /// The same of a whole number.
    [[nodiscard]] long long whole(std::string_view digits) const;

  private:
    std::string_view file_;
    std::size_t number_;
    std::string_view text_;
};

/// The lines of @p file. The last one must end as the others do.
[[nodiscard]] std::vector<WireLine> lines_of(WireText const& file);

/// The parts of @p text between separators; one more than there are separators.
[[nodiscard]] std::vector<std::string_view> parts_of(std::string_view text, char separator);

/// Letter and number: "X-4.9380".
struct WireWord
{
    char letter = ' ';
    std::string_view digits;
};

/// The words of @p text, comments in round brackets left out; each letter once. Spaces between words may be left out.
[[nodiscard]] std::vector<WireWord> words_of(WireLine const& line, std::string_view text);

/// The number of @p letter; a missing one is refused.
[[nodiscard]] double value_of(WireLine const& line, std::vector<WireWord> const& words, char letter);

/// The point of two of them.
[[nodiscard]] inline Vec2 point_of(WireLine const& line, std::vector<WireWord> const& words, char x = 'X', char y = 'Y')
{
    return {value_of(line, words, x), value_of(line, words, y)};
}

[[nodiscard]] bool has_word(std::vector<WireWord> const& words, char letter);

/// Notes in @p path that the program stops behind its last point where @p words are M0 or M1, in one or two digits.
/// The one that is not the stop of @p program is refused.
void note_stop(WireLine const& line, std::vector<WireWord> const& words, WireProgram const& program, FacePath& path);

/// Whether G0, G00, G1 or G01 is among the words.
[[nodiscard]] bool is_straight_move(std::vector<WireWord> const& words);

}  // namespace hdconj::wedm
