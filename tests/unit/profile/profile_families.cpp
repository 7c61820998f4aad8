// SPDX-License-Identifier: GPL-3.0-or-later
// Each family's flank against its formula by a second path.
#include <algorithm>
#include <fstream>
#include <functional>
#include <numbers>

#include "hdconj/profile/registry.hpp"
#include "hdconj/units.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

namespace hdconj::test::profile_families_cases {

namespace {

profile::ToothPlace const drive{0.25, 200, 0.7, 0, "", false, 2, 2};

scene::FamilyChoice choice_of(std::string const& family,
                              std::initializer_list<std::pair<char const*, scene::ParameterValue>> given)
{
    scene::FamilyChoice choice;
    choice.family = family;
    choice.path = "flexspline.profile";
    for (auto const& [key, value] : given)
        choice.given[key] = {value, 1};
    return choice;
}

profile::Profile tooth_of(scene::FamilyChoice const& choice, profile::ToothPlace const& place = drive)
{
    Faults faults;
    profile::Profile tooth = profile::build_profile(choice, place, faults);
    INFO(describe(faults));
    REQUIRE(faults.empty());
    REQUIRE_FALSE(tooth.pieces.empty());
    return tooth;
}

/// Neighbouring pieces meet; inside segments and wherever there is no corner their tangents agree too.
void check_joints(profile::Profile const& tooth, double bend = 1e-13)
{
    for (std::size_t i = 0; i + 1 < tooth.pieces.size(); ++i) {
        INFO("after piece " << i << " of segment "
                            << tooth.segment_names[static_cast<std::size_t>(tooth.pieces[i].segment)]);
        profile::PieceEnd const end = profile::end_of(tooth.pieces[i].shape);
        profile::PieceEnd const start = profile::start_of(tooth.pieces[i + 1].shape);
        CHECK((end.point - start.point).norm() < 1e-15);
        CHECK((end.normal - start.normal).norm() < bend);
    }
}

/// Points of the right flank, y from the pitch line, where @p wanted says so of the piece's shape.
template <class Wanted>
std::vector<Vec2> right_points(profile::Profile const& tooth, Wanted&& wanted)
{
    std::vector<Vec2> points;
    for (profile::ProfilePiece const& piece : tooth.pieces) {
        bool const right = tooth.segment_names[static_cast<std::size_t>(piece.segment)].starts_with("right");
        if (!right || !wanted(piece))
            continue;
        for (int i = 0; i <= 64; ++i)
            points.push_back(profile::point_at(piece.shape, i / 64.0) - Vec2(0, tooth.pitch_line));
    }
    return points;
}

bool is_curve(profile::ProfilePiece const& piece)
{
    return std::holds_alternative<profile::CurvePiece>(piece.shape);
}

scene::FamilyChoice involute_choice(double alpha_deg, double thickness = 0.36)
{
    return choice_of(
        "involute",
        {{"addendum", 0.18}, {"dedendum", 0.26}, {"pressure_angle_deg", alpha_deg}, {"thickness", thickness}});
}

/// Largest distance of the involute's points from the string construction: a point at radius q stands at the polar
/// angle s/(2 r) + inv(alpha) - inv(acos(r_b/q)), and an involute turned by d about the centre moves by r_b d along its
/// normal.
double involute_error(profile::Profile const& tooth, double alpha_deg, double thickness,
                      profile::ToothPlace const& place)
{
    using Long = long double;
    Long const r = Long(place.module) * place.teeth / 2;
    Long const alpha = Long(alpha_deg) * std::numbers::pi_v<Long> / 180;
    Long const base = r * std::cos(alpha);
    auto const roll_less_angle = [](Long t) { return t - std::atan(t); };
    Long worst = 0;
    for (Vec2 const& p : right_points(tooth, is_curve)) {
        Long const q = std::hypot(Long(p.x()), r + p.y());
        Long const roll = std::sqrt((q - base) * (q + base)) / base;
        Long const polar = std::atan2(Long(p.x()), r + p.y());
        Long const wanted = Long(thickness) / (2 * r) + roll_less_angle(std::tan(alpha)) - roll_less_angle(roll);
        worst = std::max(worst, std::abs(base * (polar - wanted)));
    }
    return static_cast<double>(worst);
}

}  // namespace

TEST_CASE("an involute tooth is what a string draws that leaves its base circle", "[profile][involute]")
{
    for (double alpha : {3.0, 5.0, 10.0, 20.0, 28.0})
        for (int teeth : {30, 200, 5000}) {
            INFO(alpha << " degrees, " << teeth << " teeth");
            profile::ToothPlace const place{0.25, teeth, 0.7, 0, "", false, 2, 2};
            profile::Profile const tooth = tooth_of(involute_choice(alpha), place);
            check_joints(tooth, 1e-10);
            CHECK(involute_error(tooth, alpha, 0.36, place) < 1e-14 * 0.44);
            auto const points = right_points(tooth, [](profile::ProfilePiece const&) { return true; });
            CHECK(points.front().y() == Approx(0.18).epsilon(1e-14));
            CHECK(points.back().y() == Approx(-0.26).epsilon(1e-14));
        }
}

TEST_CASE("an involute's thickness is half the pitch when absent", "[profile][involute]")
{
    scene::FamilyChoice choice = involute_choice(20);
    choice.given.erase("thickness");
    profile::Profile const tooth = tooth_of(choice);
    CHECK(involute_error(tooth, 20, std::numbers::pi * 0.125, drive) < 5e-15);
}

TEST_CASE("below the base circle an involute tooth is radial", "[profile][involute]")
{
    // r_b = 25 cos 5 deg lies 0.095 below the pitch circle, the root 0.26
    profile::Profile const tooth = tooth_of(involute_choice(5));
    CHECK(tooth.segment_names.back() == "right radial line");
    auto const& line = std::get<profile::LinePiece>(tooth.pieces.back().shape);
    Vec2 const centre{0, tooth.pitch_line - 25};
    CHECK(std::abs(cross(line.tangent(), (line.a - centre).normalized())) < 1e-11);
    CHECK((line.a - centre).norm() == Approx(25 * std::cos(5 * deg)).margin(1e-6));
    CHECK(tooth_of(involute_choice(20)).segment_names.back() == "right involute");
    // the arc at the base circle leaves the involute by less than 1e-12 of the height
    for (profile::ProfilePiece const& piece : tooth.pieces)
        if (auto const* arc = std::get_if<profile::ArcPiece>(&piece.shape); arc != nullptr && !piece.corner)
            CHECK(arc->length() < 1e-5);
}

TEST_CASE("a root within nanometres of the base circle is no special case", "[profile][involute]")
{
    double const base_depth = 25 - (25 * std::cos(5 * deg));
    for (double off : {0.0, 1e-15, -1e-15, 1e-12, -1e-12, 1e-9, -1e-9, 1e-7, -1e-7}) {
        INFO(off);
        scene::FamilyChoice choice = involute_choice(5);
        choice.given["dedendum"] = {base_depth + off, 1};
        profile::Profile const tooth = tooth_of(choice);
        for (Vec2 const& p : profile::polygon_of(tooth, 1e-4))
            REQUIRE(p.allFinite());
        for (profile::ProfilePiece const& piece : tooth.pieces)
            REQUIRE(end_of(piece.shape).normal.norm() == Approx(1));
        check_joints(tooth, 1e-3);
    }
}

TEST_CASE("the involute tooth of a circular spline is the space of an external one", "[profile][involute]")
{
    // s + s' = pitch: the flanks of the external tooth and of the internal one on the same pitch circle are the same
    // curve
    double const pitch = std::numbers::pi * 0.25;
    profile::ToothPlace const inside{0.25, 202, 0, 0, "", true, 2, 2};
    profile::ToothPlace const outside{0.25, 202, 0.7, 0, "", false, 2, 2};
    profile::Profile const internal = tooth_of(involute_choice(20, pitch - 0.36), inside);
    check_joints(internal);
    double const r = 25.25;
    std::vector<Vec2> turned;
    // seen from the centre, the middle of the space lies half a pitch from the middle of the tooth
    for (Vec2 const& p : right_points(internal, is_curve)) {
        Vec2 const from_centre{-p.x(), r - p.y()};
        double const half_pitch = std::numbers::pi / 202;
        turned.push_back({from_centre.x() * std::cos(half_pitch) + from_centre.y() * std::sin(half_pitch),
                          -from_centre.x() * std::sin(half_pitch) + from_centre.y() * std::cos(half_pitch) - r});
    }
    double const alpha = 20 * deg;
    double const base = r * std::cos(alpha);
    for (Vec2 const& p : turned) {
        double const q = std::hypot(p.x(), r + p.y());
        double const roll = std::sqrt((q - base) * (q + base)) / base;
        double const wanted = 0.36 / (2 * r) + std::tan(alpha) - alpha - (roll - std::atan(roll));
        CHECK(std::abs(base * (std::atan2(p.x(), r + p.y()) - wanted)) < 2e-14);
    }
    Faults faults;
    CHECK(build_profile(involute_choice(5), inside, faults).pieces.empty());
    REQUIRE(faults.size() == 1);
    CHECK_THAT(faults[0].reason, ContainsSubstring("base circle"));
}

TEST_CASE("a pointed involute tooth is refused with the height of its point", "[profile][involute]")
{
    scene::FamilyChoice choice = involute_choice(30);
    choice.given["addendum"] = {0.35, 1};
    Faults faults;
    CHECK(build_profile(choice, drive, faults).pieces.empty());
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].path == "flexspline.profile.addendum");
    CHECK_THAT(faults[0].reason, ContainsSubstring("becomes pointed at height 0.306"));
    choice.given["addendum"] = {0.306, 1};
    (void)tooth_of(choice);
}

namespace {

scene::FamilyChoice cycloid_choice(double above = 0.14, double below = 0.2)
{
    return choice_of("cycloid", {{"addendum", 0.19},
                                 {"dedendum", 0.26},
                                 {"addendum_rolling_radius", above},
                                 {"dedendum_rolling_radius", below},
                                 {"thickness", 0.39}});
}

/// Distance of @p p from the nearest point of a curve of one parameter, by golden section around the best of many.
template <class F>
double distance_to(Vec2 const& p, F&& curve, double from, double to)
{
    using Long = long double;
    auto const apart = [&](Long t) {
        auto const [x, y] = curve(t);
        return (x - p.x()) * (x - p.x()) + (y - p.y()) * (y - p.y());
    };
    Long best = from;
    constexpr int probes = 2000;
    Long const step = (Long(to) - from) / probes;
    for (int i = 0; i <= probes; ++i)
        if (apart(from + i * step) < apart(best))
            best = from + i * step;
    // the least distance, by the root of its square's slope as a central difference
    Long a = std::max(best - step, Long(from));
    Long b = std::min(best + step, Long(to));
    auto const slope = [&](Long t) { return apart(t + step / 1024) - apart(t - step / 1024); };
    for (int k = 0; k < 100; ++k) {
        Long const c = (a + b) / 2;
        (slope(c) < 0 ? a : b) = c;
    }
    // across the tangent there: the foot's own error does not count
    Long const foot = (a + b) / 2;
    auto const [x, y] = curve(foot);
    auto const [x1, y1] = curve(foot - step / 1024);
    auto const [x2, y2] = curve(foot + step / 1024);
    return static_cast<double>(std::abs((p.x() - x) * (y2 - y1) - (p.y() - y) * (x2 - x1)) /
                               std::hypot(x2 - x1, y2 - y1));
}

}  // namespace

TEST_CASE("a cycloidal tooth is what points of rolling circles draw", "[profile][cycloid]")
{
    using Long = long double;
    for (int teeth : {30, 200, 5000}) {
        INFO(teeth << " teeth");
        profile::ToothPlace const place{0.25, teeth, 0.7, 0, "", false, 2, 2};
        profile::Profile const tooth = tooth_of(cycloid_choice(), place);
        check_joints(tooth, 1e-9);
        Long const r = Long(0.25) * teeth / 2;
        Long const start = Long(0.39) / (2 * r);
        auto const epicycloid = [&](Long t) {
            Long const rho = 0.14L;
            Long const centre = start - rho / r * t;
            return std::pair{(r + rho) * std::sin(centre) - rho * std::sin(centre - t),
                             (r + rho) * std::cos(centre) - rho * std::cos(centre - t) - r};
        };
        auto const hypocycloid = [&](Long t) {
            Long const rho = 0.2L;
            Long const centre = start + rho / r * t;
            return std::pair{(r - rho) * std::sin(centre) + rho * std::sin(centre - t),
                             (r - rho) * std::cos(centre) + rho * std::cos(centre - t) - r};
        };
        Long const pitch_y = r * (std::cos(start) - 1);
        double worst = 0;
        auto const points = right_points(tooth, is_curve);
        for (std::size_t i = 0; i < points.size(); i += 5) {
            Vec2 const& p = points[i];
            worst =
                std::max(worst, p.y() > pitch_y ? distance_to(p, epicycloid, 0, 3) : distance_to(p, hypocycloid, 0, 3));
        }
        INFO(worst * 1e15 << " fm");
        CHECK(worst < 1e-14 * 0.45);
        // the two arcs at the pitch point
        for (Vec2 const& p : right_points(tooth, [](profile::ProfilePiece const& piece) {
                 return std::holds_alternative<profile::ArcPiece>(piece.shape) && !piece.corner;
             }))
            CHECK(distance_to(p, p.y() > pitch_y ? std::function<std::pair<Long, Long>(Long)>(epicycloid) : hypocycloid,
                              0, 0.002) < 1e-12 * 0.2);
    }
}

TEST_CASE("rolling on half the pitch circle makes a radial dedendum", "[profile][cycloid]")
{
    for (double below : {12.5, 12.4999, 5.0}) {
        INFO(below);
        profile::Profile const tooth = tooth_of(cycloid_choice(0.14, below));
        check_joints(tooth, 1e-9);
        Vec2 const root = profile::end_of(tooth.pieces.back().shape).point - Vec2(0, tooth.pitch_line);
        double const radial = 0.39 / 50;
        if (below == 12.5)
            CHECK(std::atan2(root.x(), root.y() + 25) == Approx(radial).epsilon(1e-9));
        else
            CHECK(std::atan2(root.x(), root.y() + 25) > radial);
    }
}

TEST_CASE("an S-tooth is half the locus, straight below its datum point with the angle of the curve",
          "[profile][s-tooth]")
{
    for (double kappa : {0.6, 0.8, 1.0, 1.2})
        for (int waves : {1, 2, 3}) {
            INFO(kappa << ", " << waves << " waves");
            profile::ToothPlace const place{0.25, 200, 0.7, 0, "", false, waves, waves};
            bool const least = kappa < 1 && waves == 2;
            double const size = 0.25 * waves / 2;
            double const steepest = kappa < 1 ? std::atan(std::sqrt(1 - kappa * kappa) / (waves * kappa)) / deg : 0;
            double const alpha = least ? steepest : steepest + 6;
            scene::FamilyChoice choice = choice_of("s-tooth", {{"addendum", 0.3 * size * kappa},
                                                               {"dedendum", 0.8 * size * kappa},
                                                               {"deflection", kappa},
                                                               {"thickness", 0.39},
                                                               {"datum_rise", 0.02 * size}});
            if (!least)
                choice.given["pressure_angle_deg"] = {alpha, 1};
            profile::Profile const tooth = tooth_of(choice, place);
            check_joints(tooth);
            // second path: the tangent of the locus from its own derivative, eta by bisection
            auto const tangent = [&](double eta) {
                return (1 - kappa * std::cos(eta)) / (waves * kappa * std::sin(eta));
            };
            double low = kappa < 1 ? std::acos(kappa) : std::acos(1 / kappa);
            double high = 3;
            for (int k = 0; k < 60; ++k)
                (tangent(0.5 * (low + high)) < std::tan(alpha * deg) ? low : high) = 0.5 * (low + high);
            Vec2 const datum{0.195 - 0.02 * size * std::tan(alpha * deg), 0.02 * size};
            auto const locus = [&](long double eta) {
                return std::pair{size / waves * (eta - kappa * std::sin(eta)), size * kappa * std::cos(eta)};
            };
            double worst = 0;
            auto const points = right_points(tooth, is_curve);
            for (std::size_t i = 0; i < points.size(); i += 5)
                worst = std::max(worst, distance_to(
                                            points[i],
                                            [&](long double eta) {
                                                auto const [x, y] = locus(eta);
                                                auto const [x_m, y_m] = locus(low);
                                                return std::pair{datum.x() + (x_m - x) / 2, datum.y() + (y_m - y) / 2};
                                            },
                                            0, std::numbers::pi));
            // at the point of inflexion eta is as uncertain as the square root of a rounding, which moves the curve by
            // its cube
            CHECK(worst < (least ? 1e-9 : 1e-14));
            auto const& line = std::get<profile::LinePiece>(tooth.pieces.back().shape);
            CHECK(std::atan2(line.tangent().x(), -line.tangent().y()) / deg == Approx(alpha).epsilon(1e-9));
            CHECK(line.a.y() - tooth.pitch_line == Approx(0.02 * size).margin(1e-15));
            double const at_pitch = line.a.x() + (line.a.y() - tooth.pitch_line) * std::tan(alpha * deg);
            CHECK(at_pitch == Approx(0.195).epsilon(1e-9));
        }
}

TEST_CASE("a chain of arcs is the double-circular-arc tooth that it describes", "[profile][arc-chain]")
{
    scene::FamilyChoice const arcs = choice_of("double-circular-arc", {{"addendum", 0.2250},
                                                                       {"dedendum", 0.3030},
                                                                       {"convex_radius", 0.2701},
                                                                       {"convex_offset", 0.0982},
                                                                       {"concave_radius", 0.5145},
                                                                       {"concave_offset", 0.69},
                                                                       {"concave_rise", 0.0671},
                                                                       {"tip_line_from", 0.19}});
    profile::Profile const wanted = tooth_of(arcs);
    auto const arc_of = [&](std::size_t back) {
        return std::get<profile::ArcPiece>(wanted.pieces[wanted.pieces.size() - back].shape);
    };
    profile::ArcPiece const concave = arc_of(1);
    profile::ArcPiece const convex = arc_of(3);
    auto const& between = std::get<profile::LinePiece>(wanted.pieces[wanted.pieces.size() - 2].shape);
    auto const& tip = std::get<profile::LinePiece>(wanted.pieces[wanted.pieces.size() - 4].shape);
    scene::NumberRows const rows{{tip.length()},
                                 {0.2701, (convex.from - convex.to) / deg},
                                 {between.length()},
                                 {-0.5145, (concave.to - concave.from) / deg + 5}};
    profile::Profile const chain = tooth_of(choice_of("arc-chain", {{"addendum", 0.2250},
                                                                    {"dedendum", 0.3030},
                                                                    {"tip_thickness", 2 * tip.a.x()},
                                                                    {"tip_angle_deg", convex.from / deg},
                                                                    {"pieces", rows}}));
    REQUIRE(chain.pieces.size() == wanted.pieces.size());
    for (std::size_t i = 0; i < chain.pieces.size(); ++i)
        for (double t : {0.0, 0.3, 1.0})
            CHECK((point_at(chain.pieces[i].shape, t) - point_at(wanted.pieces[i].shape, t)).norm() < 1e-13);
}

TEST_CASE("arcs of any radius and pieces of no length make a tooth", "[profile][arc-chain]")
{
    auto const chain_with = [](scene::NumberRows rows) {
        rows.push_back({-0.8, 60});
        return choice_of("arc-chain", {{"addendum", 0.2},
                                       {"dedendum", 0.28},
                                       {"tip_thickness", 0.14},
                                       {"tip_angle_deg", 30.0},
                                       {"pieces", std::move(rows)}});
    };
    profile::Profile const plain = tooth_of(chain_with({{0.2, 10}, {0.1}}));
    Vec2 const root = profile::end_of(plain.pieces.back().shape).point;
    // what is inserted, and how far it may move the root
    struct Row
    {
        std::vector<double> piece;
        double moves;
    };
    for (Row const& row : {Row{{0}, 1e-15},
                           {{1e-300}, 1e-12},
                           {{0.3, 0}, 1e-15},
                           {{-1e9, 0}, 1e-15},
                           {{1e-9, 0}, 1e-15},
                           {{0.3, 1e-12}, 1e-12},
                           {{1e-9, 1e-12}, 1e-12},
                           {{1e-9, 1e-3}, 1e-4},
                           {{-1e-9, 1e-3}, 1e-4},
                           {{1e9, 1e-13}, 1e-5},
                           {{0.3, 1e-9}, 1e-8},
                           {{1e3, 1e-9}, 1e-7},
                           {{1e15, 1e-20}, 1e-6}}) {
        INFO("radius or length " << row.piece[0]
                                 << (row.piece.size() > 1 ? ", sweep " + std::to_string(row.piece[1]) : ""));
        profile::Profile const tooth = tooth_of(chain_with({{0.2, 10}, row.piece, {0.1}}));
        for (Vec2 const& p : profile::polygon_of(tooth, 1e-4))
            REQUIRE(p.allFinite());
        for (std::size_t i = 0; i + 1 < tooth.pieces.size(); ++i) {
            CHECK((end_of(tooth.pieces[i].shape).point - start_of(tooth.pieces[i + 1].shape).point).norm() < 1e-12);
            // what is left out leaves its bend; what is short has a direction no better than the rounding of its ends
            double const sweep = row.piece.size() > 1 ? row.piece[1] * deg : 0;
            double const length = row.piece.size() > 1 ? std::abs(row.piece[0]) * sweep : row.piece[0];
            double const rounding = length > 1e-13 ? 1e-15 / length : 0;
            CHECK((end_of(tooth.pieces[i].shape).normal - start_of(tooth.pieces[i + 1].shape).normal).norm() <
                  1e-13 + sweep + rounding);
        }
        CHECK((end_of(tooth.pieces.back().shape).point - root).norm() < row.moves);
    }
    // an arc and the same arc as a polynomial, on both sides of the radius where they change over
    for (double radius : {479.0, 481.0}) {
        double const sweep = 0.1 / radius / deg;
        profile::Profile const tooth = tooth_of(chain_with({{0.2, 10}, {radius, sweep}}));
        double const half = 0.5 * sweep * deg;
        Vec2 const start = Vec2(0.07, 0.2) + 0.2 * (direction(20 * deg) - direction(30 * deg));
        Vec2 const end = start + 2 * radius * std::sin(half) * right_of(direction(20 * deg - half));
        auto const concave = tooth.pieces.back();
        CHECK((start_of(concave.shape).point - Vec2(0, tooth.pitch_line) - end).norm() < 2e-13);
    }
}

TEST_CASE("a round tip has no tip land and no corner", "[profile][arc-chain]")
{
    profile::Profile const tooth =
        tooth_of(choice_of("arc-chain", {{"addendum", 0.2},
                                         {"dedendum", 0.28},
                                         {"tip_thickness", 0.0},
                                         {"tip_angle_deg", 90.0},
                                         {"pieces", scene::NumberRows{{0.16, 70}, {-1.0, 65}}}}));
    for (profile::ProfilePiece const& piece : tooth.pieces)
        CHECK_FALSE(piece.corner);
    CHECK(std::find(tooth.segment_names.begin(), tooth.segment_names.end(), "tip land") == tooth.segment_names.end());
    check_joints(tooth);
}

TEST_CASE("a Bezier line is the straight tooth", "[profile][bezier]")
{
    double const slope = std::tan(25 * deg);
    double const tip = 0.2 - 0.2 * slope;
    double const root = 0.2 + 0.28 * slope;
    profile::Profile const straight = tooth_of(choice_of(
        "straight", {{"addendum", 0.2}, {"dedendum", 0.28}, {"thickness", 0.4}, {"pressure_angle_deg", 25.0}}));
    scene::NumberRows cubic;
    for (int i = 0; i <= 3; ++i)
        cubic.push_back({tip + (root - tip) * i / 3, 0.2 - 0.48 * i / 3});
    for (auto const& [rows, degree_of] :
         {std::pair{scene::NumberRows{{tip, 0.2}, {root, -0.28}}, 1.0}, std::pair{cubic, 3.0}, std::pair{cubic, 1.0}}) {
        profile::Profile const tooth = tooth_of(choice_of("bezier", {{"points", rows}, {"degree", degree_of}}));
        CHECK(tooth.addendum == straight.addendum);
        for (Vec2 const& p : profile::polygon_of(tooth, 1e-3))
            CHECK(std::abs(std::abs(p.x()) - std::clamp(0.2 - (p.y() - tooth.pitch_line) * slope, 0.0, 1.0)) *
                      (p.y() < tooth.pitch_line + 0.2) <
                  1e-15);
    }
}

TEST_CASE("Bezier curves that share a bend have a corner there", "[profile][bezier]")
{
    scene::NumberRows const rows{{0.07, 0.2}, {0.14, 0.1}, {0.17, 0.0}, {0.2, -0.15}, {0.27, -0.28}};
    profile::Profile const tooth = tooth_of(choice_of("bezier", {{"points", rows}, {"degree", 2.0}}));
    int corners = 0;
    for (profile::ProfilePiece const& piece : tooth.pieces)
        corners += piece.corner;
    CHECK(tooth.segment_names.back() == "right curve 2");
    // (0.14, 0.1) -> (0.17, 0) -> (0.2, -0.15) bends to the right going down: convex; two of these, two at the tip
    CHECK(corners == 4);
}

TEST_CASE("a spline of points in the scene is the spline of the same points in a file", "[profile][b-spline]")
{
    scene::NumberRows const rows{{0.07, 0.2},    {0.12, 0.13},   {0.152, 0.06}, {0.172, 0.0},
                                 {0.196, -0.08}, {0.232, -0.17}, {0.29, -0.28}};
    test::TemporaryFolder const folder;
    {
        std::ofstream file(folder.path() / "flank.csv");
        for (auto const& row : rows)
            file << row[0] << "," << row[1] << "\n";
    }
    profile::Profile const here = tooth_of(choice_of("b-spline", {{"points", rows}}));
    profile::ToothPlace place = drive;
    place.folder = folder.path().string();
    profile::Profile const there = tooth_of(choice_of("points", {{"file", std::string("flank.csv")}}), place);
    REQUIRE(here.pieces.size() == there.pieces.size());
    for (std::size_t i = 0; i < here.pieces.size(); ++i)
        for (double t : {0.0, 0.4, 1.0})
            CHECK(point_at(here.pieces[i].shape, t) == point_at(there.pieces[i].shape, t));
    scene::NumberRows const upside{rows.rbegin(), rows.rend()};
    CHECK(point_at(tooth_of(choice_of("b-spline", {{"points", upside}})).pieces[1].shape, 0.3)
              .isApprox(point_at(here.pieces[1].shape, 0.3), 1e-13));
}

}  // namespace hdconj::test::profile_families_cases
