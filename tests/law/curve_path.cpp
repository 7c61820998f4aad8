// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The general curve path against the closed form: the same tooth with its arcs as arcs and as polynomials of high
/// degree.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "hdconj/envelope/find_branches.hpp"
#include "hdconj/profile/polynomial_curve.hpp"
#include "support/catch.hpp"
#include "support/random_designs.hpp"
#include "support/type50.hpp"

namespace hdconj::test::curve_path_cases {

namespace {

/// @p tooth with every arc replaced by polynomial pieces that follow it to rounding.
profile::Profile as_polynomials(profile::Profile const& tooth)
{
    profile::Profile result = tooth;
    result.pieces.clear();
    for (profile::ProfilePiece const& piece : tooth.pieces) {
        auto const* arc = std::get_if<profile::ArcPiece>(&piece.shape);
        if (arc == nullptr || piece.corner) {
            result.pieces.push_back(piece);
            continue;
        }
        auto const circle = [&](double s) {
            double const angle = arc->from + s * (arc->to - arc->from);
            Vec2 const n = direction(angle);
            return profile::CurveJet{arc->centre + arc->radius * n, arc->radius * (arc->to - arc->from) * left_of(n)};
        };
        std::vector<profile::CurvePiece> curves = profile::polynomial_curve(
            circle, 0, 1, 4e-16 + 8 * unit_roundoff * (std::abs(arc->radius) + arc->centre.norm()));
        double const share = (piece.t_end - piece.t_begin) / static_cast<double>(curves.size());
        for (std::size_t i = 0; i < curves.size(); ++i) {
            double const from = piece.t_begin + share * static_cast<double>(i);
            result.pieces.push_back({std::move(curves[i]), piece.segment, from, from + share, false});
        }
    }
    return result;
}

struct Difference
{
    double points = 0;  ///< [mm]
    double ends = 0;    ///< of branches [rad]
    std::size_t compared = 0, unmatched = 0;
};

/// Every branch of the closed form, at its ends and between, against the nearest contact of the same segment at the
/// same instant.
template <class Motion>
void compare(profile::Profile const& round, Motion const& motion, double offset, Difference& worst)
{
    profile::Profile const curved = as_polynomials(round);
    envelope::Envelope<Motion> const a(round, motion, offset), b(curved, motion, offset);
    envelope::BranchSet const exact = envelope::find_branches(a, 1), general = envelope::find_branches(b, 1);
    REQUIRE(exact.record.certified());
    REQUIRE(general.record.certified());
    for (envelope::Branch const& branch : exact.branches) {
        if (branch.corner || !std::holds_alternative<profile::ArcPiece>(
                                 round.pieces[static_cast<std::size_t>(branch.arcs.front().piece)].shape))
            continue;
        for (envelope::ContactArc const& arc : branch.arcs) {
            constexpr int stations = 40;
            for (int i = 0; i <= stations; ++i) {
                double const u = envelope::arc_parameter_to_u(arc, static_cast<double>(i) / stations);
                Vec2 const p = a.point(arc, u).p;
                double nearest = 1;
                double end = 1;
                for (envelope::Branch const& other : general.branches) {
                    if (other.segment != branch.segment || other.corner)
                        continue;
                    for (envelope::ContactArc const& c : other.arcs) {
                        constexpr double slack = 0x1p-36;
                        if (u < c.u_begin - slack || u > c.u_end + slack)
                            continue;
                        nearest = std::min(nearest, (b.point(c, std::clamp(u, c.u_begin, c.u_end)).p - p).norm());
                        end = std::min({end, std::abs(c.u_begin - u), std::abs(c.u_end - u)});
                    }
                }
                ++worst.compared;
                if (nearest > 0x1p-20) {
                    ++worst.unmatched;
                    continue;
                }
                worst.points = std::max(worst.points, nearest);
                if (i == 0 || i == stations)
                    worst.ends = std::max(worst.ends, end);
            }
        }
    }
}

}  // namespace

TEST_CASE("curve path: arcs as polynomials give the envelope of arcs to 1e-12 mm", "[curve]")
{
    Difference worst;
    for (double offset : {0.0, 0.01}) {
        compare(type50_tooth(), type50_motion(), offset, worst);
        compare(type50_tooth(), type50_motion(3), offset, worst);
        compare(type50_tooth(), type50_first_order(), offset, worst);
    }
    designs::RandomDesigns random(20240901);
    int drives = 0;
    while (drives < 25) {
        Scene const scene = random.next();
        if (scene.flexspline.profile.family != "double-circular-arc")
            continue;
        Faults faults;
        profile::Profile const tooth = profile::build_profile(scene.flexspline.profile, place_of(scene), faults);
        REQUIRE(faults.empty());
        double const r_m = oracle::Motion<double>(scene).r_m;
        double const ratio = static_cast<double>(scene.drive.flexspline_teeth) / scene.drive.circular_spline_teeth;
        double const w0 = oracle::Motion<double>(scene).w0;
        compare(
            tooth,
            Exact(wavegen::NeutralCurve<wavegen::CosineCam>(wavegen::CosineCam{w0, scene.wave_generator.waves}, r_m),
                  ratio),
            0, worst);
        ++drives;
    }
    std::printf("arcs as polynomials: %zu points, largest difference %.2g mm, of branch ends %.2g rad\n",
                worst.compared, worst.points, worst.ends);
    CHECK(worst.compared > 5000);
    CHECK(worst.unmatched == 0);
    CHECK(worst.points < 1e-12);
    CHECK(worst.ends < 1e-11);
}

}  // namespace hdconj::test::curve_path_cases
