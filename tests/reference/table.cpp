// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The stored table of envelope points against the oracle that made it, and the solver's branches
/// against the table.
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <map>
#include <string>
#include <utility>

#include "support/catch.hpp"
#include "support/oracle/chain.hpp"
#include "support/oracle/reference_table.hpp"
#include "support/oracle/run.hpp"

namespace hdconj::test::table_cases {

using namespace oracle;
using hdconj::BranchRecord;
using hdconj::Kinematics;
using hdconj::Solution;

namespace {

constexpr char stored_table[] = HDCONJ_SOURCE_DIR "/data/reference/type-50-envelope.csv";

std::vector<TableRow> stored_rows()
{
    return read_rows(stored_table);
}

/// How far the branch's polygon passes from a table row: only where the branch is at the row's position
/// @p u and at its profile parameter @p t there.
double passing(BranchRecord const& branch, double u, double t, Point<double> const& point)
{
    double best = 1e300;
    for (std::size_t i = 0; i + 1 < branch.u.size(); ++i) {
        auto const [u_low, u_high] = std::minmax(branch.u[i], branch.u[i + 1]);
        auto const [t_low, t_high] = std::minmax(branch.t[i], branch.t[i + 1]);
        // A fold of t(u) may pass between two samples.
        double const slack = 0.1 * (t_high - t_low) + 1e-6;
        if (u < u_low - 1e-9 || u > u_high + 1e-9 || t < t_low - slack || t > t_high + slack)
            continue;
        best = std::min(best, distance_to_side(point, {branch.point[i].x(), branch.point[i].y()},
                                               {branch.point[i + 1].x(), branch.point[i + 1].y()}));
    }
    return best;
}

}  // namespace

TEST_CASE("reference table: is what the oracle computes", "[reference]")
{
    auto const rows = stored_rows();
    std::size_t at = 0;
    for (auto const kinematics : hdconj::all_kinematics)
        for (auto const& row : computed_rows(hdconj::builtin_scene(), kinematics)) {
            REQUIRE(at < rows.size());
            auto const& stored = rows[at++];
            INFO(table_line(row));
            INFO(table_line(stored));
            REQUIRE(stored.kinematics == kinematics);
            REQUIRE(stored.segment == row.segment);
            REQUIRE(stored.piece == row.piece);
            REQUIRE(stored.t == row.t);
            // u has to be found: printed place for place; the point is as good as u.
            CHECK(static_cast<double>(abs(stored.u - row.u)) < 2e-30);
            CHECK(static_cast<double>(abs(stored.phi - row.phi)) < 2e-30);
            CHECK(static_cast<double>(length(stored.point - row.point)) < 2e-30);
        }
    CHECK(at == rows.size());
    CHECK(at > 400);
}

TEST_CASE("reference table: its rows fulfil the condition of contact, angle by quadrature", "[reference]")
{
    // Not through the root finder: n.v of the stored row itself, and the stored angle by the other quadrature.
    GaussLegendre<Fifty> const rule(30);
    std::size_t looked = 0;
    for (auto const& row : stored_rows()) {
        if (++looked % 5)
            continue;
        hdconj::Scene scene = hdconj::builtin_scene();
        scene.solver.kinematics = row.kinematics;
        Tooth<Fifty> const tooth(scene);
        Motion<Fifty> const motion(scene);
        auto const on = tooth.on_whole(row.segment, row.t);
        Fifty const s = motion.exact ? row.u : row.phi;
        INFO(table_line(row));
        CHECK(static_cast<double>(abs(motion.phi_by_quadrature(s, rule) - row.phi)) < 2e-30);
        CHECK(static_cast<double>(abs(normal_velocity(motion, on, s))) < 1e-28);
        CHECK(static_cast<double>(abs(normal_velocity(motion, on, Fifty(s + Fifty("1e-20"))))) > 1e-23);
        CHECK(static_cast<double>(length(motion.pose(s).to_circular_spline(on.point) - row.point)) < 1e-28);
    }
}

TEST_CASE("reference table: the solver's branches pass through every row", "[reference]")
{
    double const lobe = pi<double>(), tolerance = 1e-8;
    for (auto const kinematics : hdconj::all_kinematics) {
        hdconj::Scene scene = type_50(kinematics);
        scene.solver.tolerance = tolerance;
        Solution const solution = solved(scene);
        std::size_t rows = 0, missed = 0, strangers = 0;
        double worst = 0;
        auto const nearest = [&](TableRow const& row, std::size_t segment) {
            double best = 1e300;
            for (auto const& branch : solution.branches) {
                if (branch.kind != "regular" || branch.segment != static_cast<int>(segment))
                    continue;
                // The lobe's end may be told on either side; the point is then a pitch further.
                for (int const side : {0, -1, 1}) {
                    auto const point = turned_clockwise(as<double>(row.point), side * 2 * pi<double>() / 202);
                    best = std::min(best, passing(branch, static_cast<double>(row.u) + side * lobe,
                                                  static_cast<double>(row.t), point));
                }
            }
            return best;
        };
        for (auto const& row : stored_rows()) {
            if (row.kinematics != kinematics)
                continue;
            ++rows;
            double const distance = nearest(row, row.segment);
            if (distance > tolerance) {
                ++missed;
                UNSCOPED_INFO("missed by " << distance << " mm: " << table_line(row));
            } else
                worst = std::max(worst, distance);
            // Negative controls: on no branch of another piece, and on none with t told wrong (the straight
            // pieces pass through all their t between two samples).
            bool const curved =
                row.piece.find("conv") != std::string::npos || row.piece.find("conc") != std::string::npos;
            TableRow wrong = row;
            wrong.t += Fifty(wrong.t > Fifty(0.5) ? -0.03 : 0.03);
            strangers += nearest(row, (row.segment + 2) % 7) <= tolerance;
            strangers += curved && nearest(wrong, row.segment) <= tolerance;
        }
        std::cout << "table rows passed: " << rows - missed << " of " << rows << ", worst " << worst << " mm\n";
        CHECK(rows > 200);
        CHECK(missed == 0);
        CHECK(strangers == 0);
    }
}

TEST_CASE("reference table: the other motion models against the exact one", "[reference]")
{
    // Not a judgement of the solver: the size of the effect, printed.
    using Key = std::pair<std::size_t, double>;
    auto const key_of = [](TableRow const& row) { return Key{row.segment, static_cast<double>(row.t)}; };
    std::map<std::pair<Key, int>, TableRow> exact;
    std::map<Key, int> count;
    for (auto const& row : computed_rows(hdconj::builtin_scene(), Kinematics::exact))
        exact[{key_of(row), count[key_of(row)]++}] = row;
    for (auto const kinematics : {Kinematics::first_order, Kinematics::material}) {
        count.clear();
        hdconj::Scene const scene = type_50(kinematics);
        Tooth<Fifty> const tooth(scene);
        Motion<Fifty> const motion(scene);
        double largest = 0, along = 0;
        std::printf("%s less exact, right half of the tooth, um\n%-16s %6s %9s %9s %9s\n",
                    std::string(hdconj::to_string(kinematics)).c_str(), "piece", "t", "phi deg", "normal", "whole");
        for (auto const& row : computed_rows(scene, kinematics)) {
            double const t = static_cast<double>(row.t);
            auto const partner = exact.find({key_of(row), count[key_of(row)]++});
            if (row.segment < tooth.pieces_of_whole() / 2 || partner == exact.end())
                continue;
            auto const pose = motion.pose(row.phi);
            auto const on = tooth.on_whole(row.segment, row.t);
            auto const normal = on.normal.x * pose.along + on.normal.y * pose.outward;
            auto const difference = row.point - partner->second.point;
            double const across = 1e3 * static_cast<double>(dot(difference, normal));
            double const whole = 1e3 * static_cast<double>(length(difference));
            largest = std::max(largest, std::abs(across));
            along = std::max(along, whole);
            if (static_cast<int>(t * table_steps) % 4 == 0)
                std::printf("%-16s %6.3f %9.3f %9.3f %9.3f\n", row.piece.c_str(), t,
                            static_cast<double>(row.phi) * 180 / pi<double>(), across, whole);
        }
        std::printf("largest: %.3f across the profile, %.3f at the same profile point\n", largest, along);
        CHECK(largest > 2);
        CHECK(largest < 4);
    }
}

TEST_CASE("writes the stored table", "[.][reference-table]")
{
    std::ofstream out(stored_table);
    out << "# Envelope points of type-50 (data/scenes/type-50.toml), made by tests/reference/table.cpp.\n"
           "# Pieces of the whole tooth from the left root over the tip to the right root; t from 0 to 1 along the\n"
           "# piece, proportional to arc length; u and phi in rad, x and y in mm in the circular-spline frame.\n"
        << table_header << "\n";
    for (auto const kinematics : all_kinematics)
        for (TableRow const& row : computed_rows(builtin_scene(), kinematics))
            out << table_line(row) << "\n";
}

}  // namespace hdconj::test::table_cases
