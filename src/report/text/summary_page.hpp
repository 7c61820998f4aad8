// SPDX-License-Identifier: GPL-3.0-or-later
// The printed summary, line by line, and its parts that every verb prints.
#pragma once

#include <fmt/format.h>

#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "figures/figure_of.hpp"
#include "hdconj/result_files.hpp"

namespace hdconj::report {

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
    /// The same of a row of a table, with its label and unit.
    template <class Record>
    void figure(figures::FigureOf<Record> const& row, Record const& record, std::string const& note = "")
    {
        figure(row.text.label, row.value_with_unit(record), note);
    }
    [[nodiscard]] std::string const& text() const { return text_; }

  private:
    std::string text_;
};

/// The figures of one record as text, by name.
template <class Record>
class Told
{
  public:
    Told(figures::Rows<Record> const& rows, Record const& record) : rows_(rows), record_(record) {}

    [[nodiscard]] std::string operator()(std::string_view name) const { return rows_[name].value_text(record_); }
    [[nodiscard]] std::string error(std::string_view name) const { return rows_[name].error_text(record_); }
    [[nodiscard]] std::string with_unit(std::string_view name) const { return rows_[name].value_with_unit(record_); }
    /// "+- 0.0032 um"
    [[nodiscard]] std::string error_with_unit(std::string_view name) const
    {
        return rows_[name].error_with_unit(record_);
    }

  private:
    figures::Rows<Record> rows_;
    Record const& record_;
};

/// "s" where there are several.
[[nodiscard]] inline char const* plural(std::size_t count)
{
    return count == 1 ? "" : "s";
}

/// The first columns of a row of a table: surface, kind and tilt.
[[nodiscard]] std::string surface_columns(ToothSurface surface, std::optional<TiltKind> kind, std::string const& tilt);
template <class Case>
[[nodiscard]] std::string surface_columns(figures::Rows<Case> const& rows, Case const& each)
{
    return surface_columns(each.surface, each.kind, rows["tilt"].value_text(each));
}

/// Name, numbers of teeth, ratio, kinematics.
void write_drive(Page& page, Solution const& solution);

/// "z -3.5 ... 3.5 mm", with the number of slices; nothing without slices.
void write_slices(Page& page, std::vector<double> const& z);

/// What was changed or left out.
void write_notes(Page& page, std::vector<std::string> const& notes);

/// Figures of the design outside their usual range; nothing where there are none.
void write_judgement(Page& page, Notes const& notes);

/// What every verb that goes on from the solution ends with: certificate, errors of the written points, times and
/// files.
void write_end(Page& page, Solution const& solution, std::vector<WrittenFile> const& written);

}  // namespace hdconj::report
