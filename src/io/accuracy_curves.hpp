// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What the pictures of a study share: its lines, colours, frame and legend; private to src/io.
#pragma once

#include <string>
#include <vector>

#include "accuracy_figures.hpp"

namespace hdconj::study_picture {

// Layout [px].
inline constexpr double top = 82;
inline constexpr double panel_height = 430;
inline constexpr double left_axis = 112;

/// One ladder as a line; dashed where it is the worst of the sample.
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

/// Height of a picture with that many lines [px].
[[nodiscard]] double height_of(std::size_t curves);

/// Terminal, title and logarithmic axes.
[[nodiscard]] std::string frame(StoredAccuracy const& study, std::string const& name, std::string const& hint, double height, PictureFormat format);

/// The legend's entry number @p i.
[[nodiscard]] std::string legend(Curve const& curve, std::size_t i, std::string const& remark, double height);

/// Time on threads, for the study of which that is the knob.
[[nodiscard]] std::string time_on_threads(StoredAccuracy const& study, std::vector<StudyLadder> const& ladders, std::string const& name, PictureFormat format);

}  // namespace hdconj::study_picture
