// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What a side clearance does to flanks that touched without one, corners of the outline included; and where a smallest
/// value may lie.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "contact/clearance/side_clearance_search.hpp"
#include "hdconj/contact.hpp"
#include "support/catch.hpp"
#include "support/coned_drive.hpp"
#include "support/oracle/touch.hpp"

namespace hdconj::test::moved_flank_cases {

TEST_CASE("contact law: conjugate flanks clear by their side clearance, however they are looked at", "[law][contact]")
{
    // the end planes of a ruled surface have a corner between two branches, which overlap when they are moved
    std::vector<std::string> const drive =
        with(coned("none", 10.8787),
             {"wave_generator.radial_deformation=0.243807", "flexspline.profile.convex_radius=0.26706",
              "contact.contact_gap=0.003", "slices.surface=ruled", "slices.count=3"});
    struct Row
    {
        double offset;
        int points;
    };
    for (auto const& [offset, points] : {Row{0.0046, 50}, Row{0.012, 80}}) {
        ContactCase const found =
            study_contact(builtin_scene(with(drive, {"circular_spline.backlash_offset=" + std::to_string(offset),
                                                     "contact.flank_points=" + std::to_string(points)})))
                .cases.front();
        INFO(offset << " mm, " << points << " points: clearance " << found.closest_flank().clearance << " +- "
                    << found.clearance_error);
        CHECK(found.closest_flank().clearance == Approx(offset).margin(found.clearance_error));
        CHECK(found.state.smallest_gap == Approx(offset).margin(found.state.smallest_gap_error));
        CHECK(found.state.teeth_least <= found.state.teeth);
        CHECK(found.state.teeth <= found.state.teeth_most);
        // both end planes clear by as much
        CHECK(found.closest_z_from == -3.5);
        CHECK(found.closest_z_to == 3.5);
        CHECK(found.state.smallest_z_from == -3.5);
        CHECK(found.state.smallest_spaces > 100);
    }
}

TEST_CASE("contact law: of the part as written no tooth enters a flank, from its tip circle on", "[law][contact]")
{
    // side clearance lifts the land corner off the tip circle: what is cut between the two is entered first
    struct Row
    {
        std::vector<std::string> keys;
        double at_least;  // of the side clearance [mm]
    };
    for (Row const& row :
         {Row{coned("none"), 0.05}, Row{with(coned("none"), {"tilt.kind=radial", "tilt.angle_deg=0.8"}), 0.05},
          Row{{"tilt.kind=radial", "tilt.angle_deg=0.2"}, 0.005},
          Row{{"tilt.kind=draft", "tilt.angle_deg=0.2"}, 0.005}}) {
        Scene const scene =
            builtin_scene(with(row.keys, {"slices.surface=tilted", "slices.count=3",
                                          "circular_spline.backlash_offset=auto", "circular_spline.root_clearance=0"}));
        ContactStudy const made = study_contact(scene);
        CircularSplineOutline const& spline = made.solution.circular_spline;
        ConedDrive drive(scene, 3);
        INFO(row.keys.front() << ", " << row.keys.back() << ": side clearance " << made.cases.front().backlash_offset
                              << " mm, tip circle " << made.cases.front().least_tip_radius << " mm");
        CHECK(made.cases.front().backlash_offset > row.at_least);
        double least = 1;
        for (std::size_t k = 0; k < 3; ++k) {
            oracle::TouchScan scan(drive.slice_scene(k), 1200);
            auto const& points = spline.outline[k];
            auto const land = static_cast<std::size_t>(spline.landmarks[4]),
                       end = static_cast<std::size_t>(spline.landmarks[3]);
            for (std::size_t i = end; i <= land; i += std::max<std::size_t>(1, std::min((land - end) / 40, land - i)))
                least = std::min(least, scan.nearest({points[i].x(), points[i].y()}).distance);
        }
        // none enters, and one comes close to a point that is looked at: no more is taken away than that
        CHECK(least > -2 * scene.solver.tolerance);
        CHECK(least < 1e-4);
    }
}

TEST_CASE("contact law: flank area is that of the part as written", "[law][contact]")
{
    for (std::vector<std::string> const& drive :
         {std::vector<std::string>{}, std::vector<std::string>{"circular_spline.backlash_offset=0.02"},
          with(coned("none"), {"slices.surface=tilted", "slices.count=3"}),
          std::vector<std::string>{"tilt.kind=radial", "tilt.angle_deg=0.2", "slices.surface=tilted",
                                   "slices.count=3"}}) {
        std::vector<std::string> const keys = with(drive, {"contact.flank_points=50"});
        Scene const scene = builtin_scene(keys);
        ContactStudy const study = study_contact(scene);
        CircularSplineOutline const& spline = study.solution.circular_spline;
        std::vector<double> length;
        for (auto const& points : spline.outline) {
            length.push_back(0);
            for (auto i = static_cast<std::size_t>(spline.landmarks[3]);
                 i < static_cast<std::size_t>(spline.landmarks[4]); ++i)
                length.back() += (points[i + 1] - points[i]).norm();
        }
        double area = 0;
        for (std::size_t k = 0; k + 1 < length.size(); ++k)
            area += 0.5 * (length[k] + length[k + 1]) * *scene.circular_spline.width /
                    static_cast<double>(length.size() - 1);
        if (length.size() == 1)
            area = length.front() * *scene.circular_spline.width;
        INFO(keys.front() << ", side clearance " << study.cases.front().backlash_offset << " mm");
        // of a tilted one lengths between the slices are nearly straight lines
        CHECK(study.cases.front().state.flank_area == Approx(area * scene.drive.circular_spline_teeth).epsilon(3e-6));
    }
}

TEST_CASE("contact law: one plane alone decides where tilted teeth come closest", "[law][contact]")
{
    ContactCase const found =
        study_contact(
            builtin_scene(with(coned("none"), {"slices.surface=tilted", "slices.count=5", "contact.flank_points=40"})))
            .cases.front();
    CHECK(found.closest_slice().z == -3.5);
    CHECK(found.closest_z_from == -3.5);
    CHECK(found.closest_z_to == -1.75);
}

TEST_CASE("place range: planes as good as the least and their neighbours", "[contact]")
{
    std::vector<double> const z{-2, -1, 0, 1, 2};
    auto const range = [&](std::vector<double> const& excess, double error) {
        contact::PlaceRange const found = contact::place_range(z, excess, error);
        return std::pair(found.from, found.to);
    };
    CHECK(range({4, 1, 0, 1, 4}, 0.5) == std::pair(-1.0, 1.0));
    CHECK(range({4, 1, 0, 1, 4}, 1) == std::pair(-2.0, 2.0));
    CHECK(range({0, 1, 2, 3, 4}, 0) == std::pair(-2.0, -1.0));
    CHECK(range({0, 9, 9, 9, 0}, 0) == std::pair(-2.0, 2.0));
    CHECK(range({9, 9, 0, 0, 9}, 0) == std::pair(-1.0, 2.0));
    contact::PlaceRange const one = contact::place_range({0}, {0}, 0);
    CHECK(one.from == 0);
    CHECK(one.to == 0);
}

}  // namespace hdconj::test::moved_flank_cases
