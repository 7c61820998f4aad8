// SPDX-License-Identifier: GPL-3.0-or-later
// The figures of a contact study.
#pragma once

#include <string>

#include "figure_of.hpp"
#include "hdconj/contact.hpp"

namespace hdconj::figures {

/// The closest place of two surfaces, and the estimated error of its clearance.
struct ClosestPlace
{
    Closest at;
    double error = 0;
};

/// Of a map: place along the flank, 0 at the land corner ... 1 at the flank end.
inline constexpr Name flank_position{"flank_position", "station"};

/// Of the study as a whole.
[[nodiscard]] Rows<ContactStudy> contact_study_figures();
/// At one angle of the wave generator.
[[nodiscard]] Rows<ContactState> state_figures();
/// Of the surface, over a full turn.
[[nodiscard]] Rows<ContactCase> case_figures();
/// Where flanks or roots come closest; in HDF5 "flank_" or "root_" precedes the names.
[[nodiscard]] Rows<ClosestPlace> closest_figures();
/// Of one slice over a full turn.
[[nodiscard]] Rows<SliceClearance> slice_figures();
/// Of the best tilt, but for the value there.
[[nodiscard]] Rows<BestTilt> best_tilt_figures();
/// The value at the best tilt: the contact fraction, or the least side clearance.
[[nodiscard]] FigureOf<BestTilt> best_value_figure(BestTilt const& best);
/// "contact area" or "least side clearance": what the tilt is best for.
[[nodiscard]] std::string goal_name(BestTilt const& best);
/// The same in the words of the format before.
[[nodiscard]] std::string former_goal_name(BestTilt const& best);

/// "tilted, radial 0.2 deg", or "per-slice": what a row of the table is of.
[[nodiscard]] std::string surface_name(ToothSurface surface, std::optional<TiltKind> kind, double tilt);

[[nodiscard]] inline std::string case_name(ContactCase const& each)
{
    return surface_name(each.surface, each.kind, each.tilt);
}

/// An angle as backlash at the pitch circle [mm].
[[nodiscard]] inline double at_pitch_circle(double angle, ContactStudy const& study)
{
    return angle * study.pitch_radius;
}

/// The slice whose roots come closest; the case must have slices.
[[nodiscard]] SliceClearance const& closest_root(ContactCase const& each);

}  // namespace hdconj::figures
