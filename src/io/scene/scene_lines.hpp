// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Lines and columns of a text, as the TOML library counts them: from 1, columns in code points.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace hdconj::io {

class TextLines
{
  public:
    /// Keeps a view of @p text.
    explicit TextLines(std::string_view text);

    /// Line @p number without its line end; empty when there is none.
    [[nodiscard]] std::string_view line(std::size_t number) const;

    /// The text from @p begin to before @p end (anything with .line and .column) when both stand on one line; the
    /// rest of the first line and "..." when not.
    template <class Position>
    [[nodiscard]] std::string cut(Position const& begin, Position const& end) const
    {
        return begin.line == end.line ? columns(begin.line, begin.column, end.column)
                                      : columns(begin.line, begin.column, static_cast<std::size_t>(-1)) + "...";
    }

  private:
    [[nodiscard]] std::string columns(std::size_t number, std::size_t first, std::size_t last) const;

    std::string_view text_;
    std::vector<std::size_t> starts_;
};

}  // namespace hdconj::io
