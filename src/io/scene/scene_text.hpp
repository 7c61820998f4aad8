// SPDX-License-Identifier: GPL-3.0-or-later
// The bytes of a scene: read with a limit and refused when they are no text, before they are parsed; lines of it for
// messages.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "hdconj/error.hpp"

namespace hdconj::io {

/// Whether a bare key of TOML may contain @p c.
[[nodiscard]] constexpr bool is_key_character(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
}

/// The content of @p file.
/// @throws InputError when it cannot be read or is too large
[[nodiscard]] std::string read_scene_text(std::filesystem::path const& file);

/// The fault of a scene above largest_scene.
[[nodiscard]] Fault too_large(std::string const& name);

/// Why @p text, called @p name, must not go to the parser: binary, too large, keys nested without end. Empty when it
/// may.
[[nodiscard]] Faults unparsable(std::string_view text, std::string const& name);

/// Lines and columns of a text, as the TOML library counts them: from 1, columns in code points.
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
