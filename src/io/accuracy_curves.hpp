// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What the pictures of a study share: its lines, colours, frame and legend; private to src/io.
#pragma once

#include <string>
#include <vector>

#include "accuracy_figures.hpp"
#include "picture_frame.hpp"

namespace hdconj::study_picture {

/// One ladder as a line.
struct Curve
{
    StudyLadder const* ladder;
    std::vector<StudyRung const*> rungs;   ///< with an error and a time to draw
    std::string colour;
    bool sample = false;

    /// A method that has no knob to turn stands in its study with a single setting, whose value says nothing.
    [[nodiscard]] bool has_knob() const { return ladder->rungs.size() > 1; }
};
[[nodiscard]] std::vector<Curve> curves_of(std::vector<StudyLadder> const& ladders, std::string const& name);

/// How the line looks, in gnuplot's words.
[[nodiscard]] std::string look(Curve const& curve);

/// One set of axes with its lines: the drive's, or beside them those of the worst of the sample.
struct Part
{
    std::string title;   ///< above the axes; empty where there are no others
    std::vector<Curve> curves;
    picture::Panel panel;
};
[[nodiscard]] std::vector<Part> parts_of(std::vector<Curve> const& curves, std::string const& drive);

/// What stands below the axes: for each method its line, name and remark, and below it that of its worst in the sample.
struct Legend
{
    struct Row
    {
        Curve const* curve;   ///< null: goes on with the last one
        std::string text;
    };
    std::vector<Row> rows;

    /// @param remark  of a curve; empty: nothing to say
    Legend(std::vector<Curve> const& curves, std::string (*remark)(Curve const&));
    /// @param panel  what it stands below
    [[nodiscard]] std::string text(picture::Panel const& panel, double height) const;
    /// Of the whole picture [px].
    [[nodiscard]] double height_below(picture::Panel const& panel) const;
};

/// Terminal, title and legend.
/// @param hint  what else has to be said; empty: nothing
[[nodiscard]] std::string frame(StoredAccuracy const& study, std::string const& name, std::string const& hint, std::string const& legend, double height, PictureFormat format);

/// Logarithmic axes of part number @p i. What stands about the first axes is not drawn again, nor are numbers of an axis that is the same.
[[nodiscard]] std::string axes_of(Part const& part, std::size_t i, double height);

/// Time on threads, for the study of which that is the knob.
[[nodiscard]] std::string time_on_threads(StoredAccuracy const& study, std::vector<StudyLadder> const& ladders, std::string const& name, PictureFormat format);

}  // namespace hdconj::study_picture
