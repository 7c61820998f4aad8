// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The printed summary, line by line, and its parts that every verb prints; private to src/io.
#pragma once

#include <fmt/format.h>

#include <iterator>
#include <string>
#include <vector>

#include "hdconj/io/result_files.hpp"

namespace hdconj {

/// Grows line by line.
class Page
{
  public:
    /// Width of the first column.
    static constexpr int label_width = 26;

    template <class... Values>
    void line(fmt::format_string<Values...> pattern, Values&&... values)
    {
        fmt::format_to(std::back_inserter(text_), pattern, std::forward<Values>(values)...);
        text_ += '\n';
    }
    /// One named figure: "  r_m   24.347000 mm   note".
    void figure(std::string const& label, std::string const& value, std::string const& note = "")
    {
        line("  {:<{}}{:>14}{}{}", label, label_width, value, note.empty() ? "" : "   ", note);
    }
    [[nodiscard]] std::string const& text() const { return text_; }

  private:
    std::string text_;
};

/// "-78.1 um"
[[nodiscard]] std::string um(double value_mm, char const* sign = "");

/// Name, numbers of teeth, ratio, kinematics.
void write_drive(Page& page, Solution const& solution);

/// What every verb that goes on from the solution ends with: certificate, errors of the written points, times and files.
void write_end(Page& page, Solution const& solution, std::vector<WrittenFile> const& written);

}  // namespace hdconj
