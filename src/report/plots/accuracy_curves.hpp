// SPDX-License-Identifier: GPL-3.0-or-later
// What both pictures of a study share: lines, axes, title and legend.
#pragma once

#include <string>
#include <vector>

#include "figures/accuracy_figures.hpp"
#include "label_places.hpp"
#include "plot.hpp"

namespace hdconj::report {

/// One series as a line.
struct StudyCurve
{
    ConvergenceSeries const* series;
    std::vector<ConvergenceLevel const*> levels;  ///< with an error and a time to draw
    std::size_t colour = 1;                       ///< number of the method
    bool sample = false;                          ///< of the worst designs of the sample

    /// A method that has no knob to turn stands in its study with a single setting, whose value says nothing.
    [[nodiscard]] bool has_knob() const { return series->levels.size() > 1; }
};
[[nodiscard]] std::vector<StudyCurve> study_curves(std::vector<ConvergenceSeries> const& series_list,
                                                   std::string const& name);

/// One pair of axes: the drive's, or beside it that of the worst of the sample.
struct StudyPanel
{
    LabelBox axes;
    std::string title;  ///< above the axes; empty where there are no others
    std::vector<StudyCurve> curves;
};
[[nodiscard]] std::vector<StudyPanel> study_panels(std::vector<StudyCurve> const& curves, std::string const& drive);

/// Title, panels and legend. @param remark  on a curve, for the legend; empty: nothing to say
[[nodiscard]] PlotData study_data(StoredAccuracy const& study, std::string const& name,
                                  std::vector<StudyPanel> const& panels, std::string (*remark)(StudyCurve const&));

}  // namespace hdconj::report
