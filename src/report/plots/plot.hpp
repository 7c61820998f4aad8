// SPDX-License-Identifier: GPL-3.0-or-later
// A picture is a gnuplot template, templates/NAME.gp, that is fed with columns and variables.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "hdconj/base/vec2.hpp"

namespace hdconj::report {

using Polylines = std::vector<std::vector<Vec2>>;

/// Rows of numbers that a template reads by their column.
class PlotColumns
{
  public:
    PlotColumns() = default;
    /// Rows x, y; an empty row after each polyline.
    explicit PlotColumns(Polylines const& lines);

    template <class... Numbers>
    void row(Numbers... values)
    {
        add({static_cast<double>(values)...});
        text_ += '\n';
    }
    /// A row whose last column is a text.
    template <class... Numbers>
    void named_row(std::string_view text, Numbers... values)
    {
        add({static_cast<double>(values)...});
        add(text);
    }
    void append(PlotColumns const& rows) { text_ += rows.text_; }
    /// An empty row: the next row begins another line.
    void end_line() { text_ += '\n'; }
    /// Two empty rows: the next row belongs to gnuplot's next index.
    void end_index() { text_ += "\n\n"; }

    [[nodiscard]] std::string const& text() const { return text_; }

  private:
    void add(std::initializer_list<double> values);
    void add(std::string_view text);

    std::string text_;
};

/// The data of one picture under the names that the head of its template explains.
class PlotData
{
  public:
    /// @param heading  first line above the drawing
    explicit PlotData(std::string_view heading) { set("heading", heading); }

    void set(std::string_view name, double value);
    void set(std::string_view name, std::string_view text);
    void set(std::string_view name, PlotColumns const& columns);

    [[nodiscard]] std::string const& commands() const { return commands_; }

  private:
    std::string commands_;
};

/// The data, the common part and the template: a script that lacks only the variable `png`.
/// @param name  of the template, without ending
[[nodiscard]] std::string plot_script(std::string_view name, PlotData const& data);

/// Fewer points: none of those left out is further than @p tolerance [mm] from the polyline that remains. The ends
/// stay.
[[nodiscard]] std::vector<Vec2> thinned(std::vector<Vec2> const& polyline, double tolerance);
[[nodiscard]] Polylines thinned(Polylines lines, double tolerance);

}  // namespace hdconj::report
