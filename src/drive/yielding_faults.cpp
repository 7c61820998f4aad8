// SPDX-License-Identifier: GPL-3.0-or-later
#include "yielding_faults.hpp"

#include <cmath>
#include <numbers>

#include "base/text.hpp"
#include "drive.hpp"

namespace hdconj::drive {
namespace {

/// Root circle of the circular spline as far as it is known before anything is solved [mm].
double root_radius(Scene const& scene, profile::Profile const& tooth, PairGeometry const& g)
{
    return scene.is_reverse() ? given_tooth_seat(g, tooth) - tooth.pitch_line + tooth.dedendum
                              : g.r_m + g.w0 + g.pitch_line + g.addendum + scene.circular_spline.root_clearance +
                                    scene.circular_spline.backlash_offset;
}

void validate_body(Compliance const& compliance, double root, Faults& faults)
{
    constexpr double usual = 1.4;  // of the root circle, as of the drive of the thesis
    if (compliance.outer_radius && !(*compliance.outer_radius > root))
        faults.push_back(
            {"compliance.outer_radius", 0, short_number(*compliance.outer_radius),
             "the circular spline has its root circle at " + short_number(root) + " mm: nothing is left of its body",
             "write the radius at which it is held, such as " + short_number(std::round(usual * root))});
}

/// Neighbouring balls touch where the chord between their centres is as long as they are thick.
void validate_balls(BearingChoice const& bearing, double inner_radius, Faults& faults)
{
    if (!bearing.ball_diameter || !bearing.balls || !bearing.ring_thickness)
        return;
    double const raceway = inner_radius - *bearing.ring_thickness, half = std::sin(std::numbers::pi / *bearing.balls);
    double const largest = 2 * raceway * half / (1 + half);
    if (raceway > 0 && !(*bearing.ball_diameter < largest))
        faults.push_back({"bearing.ball_diameter", 0, short_number(*bearing.ball_diameter),
                          std::to_string(*bearing.balls) + " balls of this size do not fit in a ring of " +
                              short_number(raceway) + " mm inner radius",
                          "write less than " + short_number(largest, 3) + ", or fewer balls"});
}

}  // namespace

void validate_yielding(Scene const& scene, profile::Profile const& tooth, PairGeometry const& g, Faults& faults)
{
    if (scene.compliance)
        validate_body(*scene.compliance, root_radius(scene, tooth, g), faults);
    if (scene.bearing)
        validate_balls(*scene.bearing, g.flexspline_inner_radius, faults);
}

}  // namespace hdconj::drive
