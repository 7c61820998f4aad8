// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "accuracy/study_drive.hpp"
#include "fifty.hpp"
#include "hdconj/accuracy.hpp"
#include "hdconj/error.hpp"
#include "reference_contact.hpp"
#include "reference_outline.hpp"

namespace hdconj::accuracy {
namespace {

/// n.v of the end @p t, 0 or 1, of a piece at @p u.
Fifty normal_speed(profile::PieceShape const& shape, int t, MovingFrame<Fifty> const& place)
{
    profile::PieceEnd const end = t == 0 ? profile::start_of(shape) : profile::end_of(shape);
    Pair<Fifty> const x = pair_of<Fifty>(end.point), n = pair_of<Fifty>(end.normal);
    return inner(place.turned(n), place.velocity(x));
}

/// The root of it next to @p u, by the secant rule.
Fifty crossing(profile::PieceShape const& shape, int t, ReferenceView<Fifty> const& motion, double u)
{
    Fifty a(u), b = a + Fifty(0x1p-30);
    Fifty fa = normal_speed(shape, t, motion.at(a));
    Fifty const enough("1e-30");
    constexpr int budget = 60;
    for (int i = 0; i < budget; ++i) {
        Fifty const fb = normal_speed(shape, t, motion.at(b));
        if (fb == fa)
            return b;
        Fifty const next = b - fb * (b - a) / (fb - fa);
        a = b;
        fa = fb;
        b = next;
        if (abs(b - a) < enough)
            return b;
    }
    throw NumericalError(ErrorCode::not_converged, "reference", "zone that ends at u = " + std::to_string(u),
                         "its end did not converge in 50 digits");
}

}  // namespace

ReferenceFigures reference_figures(Scene const& scene, ReferenceCurve const& truth)
{
    StudyDrive const drive = drive_parts(scene);
    double const tip = drive.geometry.circular_spline_inner_radius;
    // mirror images are not assumed: the land between the right corner of one space and the left one of the next
    Vec2 const left = truth.end_of(truth.patches().front().stretch),
               right = truth.start_of(truth.patches().back().stretch);
    double const land = 2 * std::numbers::pi / scene.drive.circular_spline_teeth -
                        (std::atan2(right.x(), right.y()) - std::atan2(left.x(), left.y()));
    // the linear models measure w from the undeformed circle
    bool const exact = scene.solver.kinematics == Kinematics::exact;
    return {exact ? static_cast<double>(ReferenceNeutralCurve<Fifty>(drive.given()).mean_radius()) : drive.geometry.r_m,
            truth.largest_radius() - tip, land * tip};
}

std::vector<ZoneEndCheck> check_zone_ends(Solution const& solution)
{
    Faults const faults = check_accuracy(solution.scene, {});
    if (!faults.empty())
        throw InputError(faults);
    StudyDrive const drive = drive_parts(solution.scene);
    std::vector<ReferenceView<Fifty>> views;
    for (std::size_t j = 0; j < drive.motions.size(); ++j)
        views.push_back(drive.view<Fifty>(j));
    bool const exact = solution.scene.solver.kinematics == Kinematics::exact;
    std::vector<ZoneEndCheck> checks;
    for (ConjugateZone const& zone : solution.zones) {
        if (zone.kind != "regular")
            continue;
        for (bool const begin : {true, false}) {
            double const t = begin ? zone.t_begin : zone.t_end;
            double const u = exact ? (begin ? zone.u_begin : zone.u_end)
                                   : (begin ? zone.phi_begin : zone.phi_end);  // what the motion is given by
            double const lobe_end = drive.motion().half_lobe();
            if ((t != 0 && t != 1) || std::abs(std::abs(u) - lobe_end) <= 2 * zone.phi_error)
                continue;
            auto const piece =
                std::find_if(drive.tooth.pieces.begin(), drive.tooth.pieces.end(), [&](profile::ProfilePiece const& p) {
                    return !p.corner && p.segment == zone.segment && (t == 0 ? p.t_begin : p.t_end) == t;
                });
            if (piece == drive.tooth.pieces.end())
                continue;
            auto const made_by =
                std::find(drive.numbers.begin(), drive.numbers.end(), solution.branches[zone.branch].tooth);
            auto const which = drive.reverse() ? static_cast<std::size_t>(made_by - drive.numbers.begin()) : 0;
            Fifty const root = crossing(piece->shape, static_cast<int>(t), views[which], u);
            checks.push_back({zone.segment_name, static_cast<double>(abs(root - Fifty(u))), zone.phi_error});
        }
    }
    return checks;
}

}  // namespace hdconj::accuracy
