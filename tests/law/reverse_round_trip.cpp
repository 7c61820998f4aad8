// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Solved back, a solved flank is the one it came from, whichever way it is written.
#include <fstream>
#include <iostream>
#include <sstream>

#include "hdconj/distance/tooth_distance.hpp"
#include "hdconj/profile/registry.hpp"
#include "support/catch.hpp"
#include "support/reverse_law.hpp"
#include "support/temporary_folder.hpp"
#include "support/type50.hpp"

namespace hdconj::test::reverse_round_trip_cases {

using namespace oracle;
using hdconj::Scene;
using hdconj::Solution;
using hdconj::Vec2;

namespace {

/// The stretch of type-50's circular spline that its convex arc makes, as a right flank that points inward, y from the
/// pitch line, between two heights.
std::vector<Vec2> solved_flank(Solution const& there, double lowest, double highest)
{
    double const pitch_radius = there.geometry.r_m + there.geometry.pitch_line + there.geometry.w0;
    double const half_pitch = pi<double>() / there.scene.drive.circular_spline_teeth;
    std::vector<Vec2> flank;
    for (auto const& piece : there.circular_spline.pieces) {
        if (piece.segment_name != "right convex arc" || piece.kind != "flank")
            continue;
        for (std::size_t i = piece.first; i <= piece.last; ++i) {
            Vec2 const p = there.circular_spline.outline[0][i];
            double const angle = half_pitch - std::atan2(p.x(), p.y());
            Vec2 const q(p.norm() * std::sin(angle), pitch_radius - p.norm() * std::cos(angle));
            if (q.y() > lowest && q.y() < highest)
                flank.push_back(q);
        }
    }
    return flank;
}

/// @p flank given as a spline through @p count of its points, at equal shares of its length, and solved back.
Solution solved_back(Solution const& there, std::vector<Vec2> const& flank, std::size_t count, double addendum)
{
    hdconj::test::TemporaryFolder const folder;
    std::vector<double> length{0};
    for (std::size_t i = 1; i < flank.size(); ++i)
        length.push_back(length.back() + (flank[i] - flank[i - 1]).norm());
    double const tip = std::max(flank.front().y(), flank.back().y());
    double const middle = 0.5 * (flank.front().y() + flank.back().y());
    std::ofstream file(folder / "flank.csv");
    file.precision(17);
    std::size_t at = 0;
    for (std::size_t k = 0; k < count; ++k) {
        double const wanted = length.back() * static_cast<double>(k) / static_cast<double>(count - 1);
        while (at + 1 < flank.size() && length[at + 1] <= wanted)
            ++at;
        Vec2 const& p = k + 1 == count ? flank.back() : flank[at];
        file << p.x() << "," << p.y() - middle << "\n";
    }
    file.close();
    std::ostringstream text;
    text.precision(17);
    text << "[drive]\nmodule = 0.25\nflexspline_teeth = 200\ncircular_spline_teeth = 202\n[flexspline]\nwall = "
            "0.7\naddendum = "
         << addendum
         << "\ndedendum = 0.303\n[wave_generator]\nfamily = \"cosine\"\nradial_deformation = "
            "0.25\n[circular_spline]\ninner_radius = "
         << there.geometry.r_m + there.geometry.pitch_line + there.geometry.w0 - tip
         << "\n[circular_spline.profile]\nfamily = \"points\"\nfile = \"flank.csv\"\n";
    return hdconj::solve(hdconj::parse_scene(text.str(), "round trip", folder.path()));
}

/// How far the solved flank above @p from is off type-50's tooth, and how far that one reaches out of it.
struct RoundTrip
{
    double worst = 0, deepest = 0;
    std::size_t seen = 0;
};

RoundTrip compared(Solution const& back, double from)
{
    hdconj::profile::Profile const tooth = hdconj::test::type50_tooth();
    hdconj::distance::ToothDistance const distance(tooth);
    RoundTrip trip;
    for (auto const& piece : back.flexspline_pieces) {
        for (std::size_t i = piece.first; i <= piece.last; ++i) {
            Vec2 const p = back.flexspline_outline[i] + Vec2(0, tooth.pitch_line);
            double const away = distance(p).distance;
            // the original tooth is free of the circular spline, so the largest free tooth contains it
            if (piece.kind == "flank" || piece.kind == "corner")
                trip.deepest = std::max(trip.deepest, -away);
            // what the given flank touches is the convex arc that it came from
            if (piece.kind == "flank" && p.y() > tooth.pitch_line + from) {
                trip.worst = std::max(trip.worst, std::abs(away));
                ++trip.seen;
            }
        }
    }
    return trip;
}

}  // namespace

TEST_CASE("round trip: a flank that was solved for, given and solved back, is the one it came from", "[reverse]")
{
    // what the second conjugate zone made
    Solution const there = hdconj::solve(hdconj::builtin_scene({"solver.tolerance=1e-9"}));
    std::vector<Vec2> const flank = solved_flank(there, -0.186, -0.06);
    REQUIRE(flank.size() > 1000);
    std::vector<double> errors;
    for (std::size_t const count : {9, 17, 33, 65}) {
        RoundTrip const trip = compared(solved_back(there, flank, count, 0.17), 0);
        CHECK(trip.seen > 100);
        CHECK(trip.deepest <= trip.worst);
        errors.push_back(trip.worst);
        std::cout << "round trip through " << count << " points: " << trip.worst << " mm, " << trip.seen
                  << " points compared\n";
    }
    // a cubic spline tends to fourth order
    for (std::size_t i = 1; i < errors.size(); ++i)
        CHECK(errors[i] < errors[i - 1] / 6);
    CHECK(errors[3] < errors[1] / 128);
    CHECK(errors.back() < 5e-9);
}

TEST_CASE("round trip: both conjugate zones at once", "[reverse]")
{
    // each zone touches the whole solved flank: two branches side by side, as near as the spline is good
    Solution const there = hdconj::solve(hdconj::builtin_scene({"solver.tolerance=1e-9"}));
    std::vector<Vec2> const flank = solved_flank(there, -1, 1);
    double before = 1;
    for (std::size_t const count : {17, 19, 21}) {
        Solution const back = solved_back(there, flank, count, 0.157);
        RoundTrip const trip = compared(back, 0.07);
        std::cout << "round trip through " << count << " points of both zones: " << trip.worst << " mm, clearance "
                  << back.check->smallest_clearance << " mm\n";
        CHECK(trip.seen > 50);
        CHECK(trip.worst < before);
        // not farther inside than the written error says
        CHECK(back.check->smallest_clearance >= -2 * back.error.largest());
        CHECK(back.check->smallest_clearance >= -back.scene.solver.tolerance / 4);
        CHECK(back.error.largest() <= 1.1 * back.scene.solver.tolerance);
        before = trip.worst;
    }
    CHECK(before < 2e-6);
}

TEST_CASE("a given tooth of arcs is solved in closed form, and as a spline gives the same", "[reverse]")
{
    Solution const arcs = hdconj::solve(given_scene());
    hdconj::Faults faults;
    Scene const scene = given_scene();
    hdconj::profile::Profile const tooth = hdconj::profile::build_profile(
        *scene.circular_spline.profile, {scene.drive.module, 202, 0, 0, "", true, 2, 2}, faults);
    REQUIRE(faults.empty());
    for (auto const& piece : tooth.pieces)
        CHECK_FALSE(std::holds_alternative<hdconj::profile::CurvePiece>(piece.shape));

    // the same flank as points of a spline
    hdconj::test::TemporaryFolder const folder;
    std::ofstream file(folder / "flank.csv");
    file.precision(17);
    for (auto const& piece : tooth.pieces) {
        if (tooth.segment_names[static_cast<std::size_t>(piece.segment)] != "right convex arc" || piece.corner)
            continue;
        constexpr int count = 100;
        for (int i = 0; i <= count; ++i) {
            Vec2 const p = hdconj::profile::point_at(piece.shape, static_cast<double>(i) / count);
            file << p.x() << "," << p.y() - tooth.pitch_line << "\n";
        }
    }
    file.close();
    std::string text = arcs.scene.text;
    std::size_t const from = text.find("[circular_spline.profile]");
    text.replace(from, text.find("[solver]") - from,
                 "[circular_spline.profile]\nfamily = \"points\"\nfile = \"flank.csv\"\n");
    text.replace(text.find("addendum = 0.2250"), 17, "addendum = 0.02  ");
    Solution const spline = hdconj::solve(hdconj::parse_scene(text, "as points", folder.path()));
    // the spline tooth ends where its convex arc ends, so only what that arc makes can be compared
    double worst = 0;
    std::size_t seen = 0;
    auto const& fine = arcs.flexspline_outline;
    for (auto const& piece : spline.flexspline_pieces) {
        if (piece.kind != "flank")
            continue;
        for (std::size_t i = piece.first; i <= piece.last; ++i) {
            Vec2 const p = spline.flexspline_outline[i];
            double nearest = 1;
            for (std::size_t k = 0; k + 1 < fine.size(); ++k) {
                Vec2 const d = fine[k + 1] - fine[k];
                double const share = std::clamp((p - fine[k]).dot(d) / d.squaredNorm(), 0.0, 1.0);
                nearest = std::min(nearest, (p - fine[k] - share * d).norm());
            }
            worst = std::max(worst, nearest);
            ++seen;
        }
    }
    CHECK(seen > 50);
    CHECK(worst < 1.1e-6);  // the chord error of the polygon that it is measured against
}

}  // namespace hdconj::test::reverse_round_trip_cases
