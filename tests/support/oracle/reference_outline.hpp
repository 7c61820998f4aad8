// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The true outline of a drive and its figures in 50 digits, to measure others by.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "accuracy/reference/fifty.hpp"
#include "accuracy/reference/reference_contact.hpp"
#include "accuracy/study_drive.hpp"
#include "hdconj/accuracy.hpp"
#include "hdconj/error.hpp"

namespace hdconj::accuracy {

/// Figures of a drive by the same path.
struct ReferenceFigures
{
    double r_0 = 0;          ///< base radius of the deformed neutral curve, as PairGeometry::r_0 [mm]
    double space_depth = 0;  ///< from the tip circle [mm]
    double land = 0;         ///< along the tip circle [mm]
};

/// Where a contact crosses an end of its segment in 50 digits, near @p phi_begin or @p phi_end of the zones of @p
/// solution that end there: per such end the distance from the angle stated [rad], and the error that is stated for it.
struct ZoneEndCheck
{
    std::string segment_name;
    double off = 0;
    double stated = 0;
};

/// n.v of the end @p t, 0 or 1, of a piece at @p u.
inline Fifty normal_speed(profile::PieceShape const& shape, int t, MovingFrame<Fifty> const& place)
{
    profile::PieceEnd const end = t == 0 ? profile::start_of(shape) : profile::end_of(shape);
    Pair<Fifty> const x = pair_of<Fifty>(end.point), n = pair_of<Fifty>(end.normal);
    return inner(place.turned(n), place.velocity(x));
}

/// The root of it next to @p u, by the secant rule.
inline Fifty crossing(profile::PieceShape const& shape, int t, ReferenceView<Fifty> const& motion, double u)
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

/// Largest distance of @p curve from the origin [mm].
inline double largest_radius(ReferenceCurve const& curve)
{
    constexpr std::size_t patch_steps = 48;
    long double largest = 0;
    for (ReferencePatch const& patch : curve.patches()) {
        auto const radius = [&](long double s) {
            return std::hypot(chebyshev_sum(patch.x, s), chebyshev_sum(patch.y, s));
        };
        std::size_t best = 0;
        long double const step = 2.0L / patch_steps;
        for (std::size_t k = 1; k <= patch_steps; ++k)
            if (radius(-1 + step * static_cast<long double>(k)) > radius(-1 + step * static_cast<long double>(best)))
                best = k;
        long double const middle = -1 + step * static_cast<long double>(best);
        long double a = std::max(-1.0L, middle - step), b = std::min(1.0L, middle + step);
        constexpr int thirds = 100;
        for (int i = 0; i < thirds; ++i) {
            long double const c = a + (b - a) / 3, d = b - (b - a) / 3;
            bool const left = radius(c) > radius(d);
            (left ? b : a) = left ? d : c;
        }
        largest = std::max({largest, radius(a), radius(middle)});
    }
    return static_cast<double>(largest);
}

/// Where the first stretch of @p curve ends, and where the last one begins.
inline std::pair<Vec2, Vec2> inner_ends(ReferenceCurve const& curve)
{
    auto const& patches = curve.patches();
    std::size_t const steps = curve.points().size() / patches.size();
    auto const of = [&](int stretch) {
        return [stretch](ReferencePatch const& patch) { return patch.stretch == stretch; };
    };
    auto const first = std::find_if_not(patches.begin(), patches.end(), of(patches.front().stretch));
    auto const last = std::find_if(patches.begin(), patches.end(), of(patches.back().stretch));
    auto const point = [&](auto patch) {
        return curve.points()[static_cast<std::size_t>(patch - patches.begin()) * steps];
    };
    return {point(first), point(last)};
}

/// The outline that `solve` is asked for, in 50 digits by a path of its own: one pitch of the circular spline, mid-land
/// to mid-land, or in the reverse problem the flexspline tooth from root to root, y from its pitch line. Under the
/// motion model of the scene, with any wave generator; cut where the third derivative of its shape jumps.
///
/// Domain: a side clearance that is a number; root clearance and effects along the axis are not looked at.
/// Accuracy: ReferenceCurve::error(), some 1e-16 mm.
/// @throws InputError and NumericalError as `solve` does; NumericalError where an arc's centre is at rest too
[[nodiscard]] inline ReferenceCurve reference_outline(Scene const& scene)
{
    Faults const faults = check_accuracy(scene, {});
    if (!faults.empty())
        throw InputError(faults);
    return reference_of(study_drive(scene));
}

/// @param truth  reference_outline(@p scene)
/// Domain: the forward problem, else as there; errors as there. Accuracy: that of double coordinates, and of the land
/// over the sine of the angle at which flank and tip circle cross.
[[nodiscard]] inline ReferenceFigures reference_figures(Scene const& scene, ReferenceCurve const& truth)
{
    StudyDrive const drive = drive_parts(scene);
    double const tip = drive.geometry.circular_spline_inner_radius;
    // mirror images are not assumed: the land between the right corner of one space and the left one of the next
    auto const [left, right] = inner_ends(truth);
    double const land = 2 * std::numbers::pi / scene.drive.circular_spline_teeth -
                        (std::atan2(right.x(), right.y()) - std::atan2(left.x(), left.y()));
    // the linear models measure w from the undeformed circle
    bool const exact = scene.solver.kinematics == Kinematics::exact;
    return {exact ? static_cast<double>(ReferenceNeutralCurve<Fifty>(drive.given()).mean_radius()) : drive.geometry.r_m,
            largest_radius(truth) - tip, land * tip};
}

/// All zones of regular branches that end with their segment. Domain and errors as of reference_outline().
[[nodiscard]] inline std::vector<ZoneEndCheck> check_zone_ends(Solution const& solution)
{
    Faults const faults = check_accuracy(solution.scene, {});
    if (!faults.empty())
        throw InputError(faults);
    StudyDrive const drive = drive_parts(solution.scene);
    std::vector<ReferenceView<Fifty>> const views = drive.views<Fifty>();
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
            std::size_t const which = drive.index_of(solution.branches[zone.branch].tooth);
            Fifty const root = crossing(piece->shape, static_cast<int>(t), views[which], u);
            checks.push_back({zone.segment_name, static_cast<double>(abs(root - Fifty(u))), zone.phi_error});
        }
    }
    return checks;
}

}  // namespace hdconj::accuracy
