// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "drive_text.hpp"
#include "hdconj/contact.hpp"
#include "hdconj/solve.hpp"
#include "hdconj/wanted_curve.hpp"
#include "refusal.hpp"
#include "targets.hpp"

namespace hdconj::fuzz {
namespace {

void finite(std::initializer_list<double> values, std::string const& what)
{
    if (!std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); }))
        throw Find(what + " is not finite");
}

void finite(std::vector<double> const& values, std::string const& what)
{
    if (!std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); }))
        throw Find(what + " is not finite");
}

void finite(std::vector<Vec2> const& points, std::string const& what)
{
    if (!std::all_of(points.begin(), points.end(), [](Vec2 const& p) { return p.allFinite(); }))
        throw Find(what + " is not finite");
}

void validate_numbers(Solution const& s)
{
    PairGeometry const& g = s.geometry;
    finite({g.r_m, g.r_0, g.w0, g.pitch_line, g.addendum, g.dedendum, g.flexspline_inner_radius,
            g.circular_spline_inner_radius, g.land_half_angle, g.space_depth, g.ratio},
           "geometry");
    finite(s.flexspline_outline, "flexspline outline");
    finite(s.neutral_curve, "neutral curve");
    for (BranchRecord const& branch : s.branches) {
        finite(branch.u, "u of branch " + branch.segment_name);
        finite(branch.phi, "phi of branch " + branch.segment_name);
        finite(branch.t, "t of branch " + branch.segment_name);
        finite(branch.point, "points of branch " + branch.segment_name);
    }
    for (ConjugateZone const& zone : s.zones)
        finite({zone.u_begin, zone.u_end, zone.phi_begin, zone.phi_end, zone.t_begin, zone.t_end},
               "zone of " + zone.segment_name);
    for (auto const& outline : s.circular_spline.outline)
        finite(outline, "circular spline");
    for (auto const& tooth : s.tooth_family)
        finite(tooth, "tooth family");
    finite(s.circular_spline.z, "z of the slices");
    finite({s.error.chord, s.error.point, s.error.arc_length}, "error estimate");
}

void validate_pieces(std::vector<OutlinePiece> const& pieces, std::size_t count)
{
    for (OutlinePiece const& piece : pieces) {
        if (piece.first > piece.last || piece.last >= count)
            throw Find("a piece outside its outline");
    }
}

void validate_indices(Solution const& s)
{
    if (s.circular_spline.outline.empty() || s.circular_spline.outline.front().size() < 2)
        throw Find("no outline");
    std::size_t const count = s.circular_spline.outline.front().size();
    for (auto const& slice : s.circular_spline.outline) {
        if (slice.size() != count)
            throw Find("slices that do not match");
    }
    if (s.circular_spline.z.size() != s.circular_spline.outline.size())
        throw Find("a slice without its place");
    for (int landmark : s.circular_spline.landmarks) {
        if (landmark < 0 || static_cast<std::size_t>(landmark) >= count)
            throw Find("a landmark outside the outline");
    }
    validate_pieces(s.circular_spline.pieces, count);
    validate_pieces(s.flexspline_pieces, s.flexspline_outline.size());
}

void validate_pair(Solution const& s)
{
    double const tolerance = s.scene.solver.tolerance;
    if (!s.check)
        throw Find("no check of the pair");
    finite({s.check->smallest_clearance, s.check->where.x(), s.check->where.y(), s.check->at_phi}, "check of the pair");
    if (!(s.check->smallest_clearance >= s.scene.circular_spline.backlash_offset - tolerance))
        throw Find("a tooth enters the outline: clearance " + std::to_string(s.check->smallest_clearance) + " mm");
    if (!(s.error.chord <= tolerance))
        throw Find("chord error " + std::to_string(s.error.chord) + " mm above the tolerance");
}

/// A neutral curve between both given teeth.
void validate_curve(WantedCurve const& found)
{
    finite({found.touch_begin, found.touch_end, found.residual, found.error, found.growth, found.least_curvature,
            found.largest_curvature, found.bending_stress, found.smallest_clearance, found.geometry.r_0,
            found.geometry.w0},
           "figures of the curve");
    finite(found.neutral_curve, "neutral curve");
    finite(found.inner_surface, "surface of the cam");
    for (WantedCurveRow const& row : found.rows)
        finite({row.u, row.displacement, row.slope, row.curvature}, "row of the curve");
    if (!(found.touch_begin <= found.touch_end && found.least_curvature > 0))
        throw Find("a curve without a mesh, or with a hollow");
}

/// The same drive in contact, on a coarse grid.
void validate_contact(Scene scene)
{
    constexpr int few = 12;
    scene.contact->flank_points = std::min(scene.contact->flank_points, few);
    ContactStudy const study = study_contact(scene);
    finite(study.map.gap, "gap map");
    for (ContactCase const& each : study.cases) {
        finite({each.least_side_clearance, each.least_tip_radius, each.least_root_clearance, each.state.turn_to_contact,
                each.state.reverse_turn_to_contact, each.state.contact_fraction, each.state.contact_fraction_error,
                each.state.smallest_gap},
               "contact");
        if (!(each.state.contact_fraction >= 0 && each.state.contact_fraction <= 1))
            throw Find("a share of contact outside 0 ... 1");
    }
}

}  // namespace

void scene_solve(Bytes input)
{
    constexpr int most_slices = 4;
    constexpr double finest = 0x1p-24;  // of the module: bounds the number of points, and with it the work
    accepted([&] {
        Scene scene = scene_of(parse_drive(text_of(input)));
        scene.solver.threads = 1;
        scene.solver.tolerance = std::max(scene.solver.tolerance, scene.drive.module * finest);
        if (scene.wants_neutral_curve())
            return validate_curve(find_neutral_curve(scene));
        if (scene.slices)
            scene.slices->count = std::min(scene.slices->count, most_slices);
        Solution const solution = solve(scene);
        validate_numbers(solution);
        validate_indices(solution);
        if (scene.contact)
            validate_contact(scene);
        validate_pair(solution);
    });
}

}  // namespace hdconj::fuzz
