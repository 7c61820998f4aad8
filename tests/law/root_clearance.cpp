// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Clearance around the bottom of the space against the outline that is written, which is solved for the offset tooth,
/// and what a drive needs against the same drive with it.
#include <algorithm>
#include <limits>
#include <string>

#include "hdconj/contact.hpp"
#include "support/catch.hpp"
#include "support/coned_drive.hpp"
#include "support/run/full_run.hpp"

namespace hdconj::test::root_clearance_cases {

namespace {

using Keys = std::vector<std::string>;

Scene drive_of(std::string const& name, std::string const& surface, double side_clearance, Keys const& more)
{
    Keys const keys = with(coned(), {"slices.count=3", "slices.surface=" + surface, "circular_spline.width=7.0",
                                     "circular_spline.backlash_offset=" + std::to_string(side_clearance)});
    return read_scene(file_of(name), with(keys, more));
}

/// The least clearance of slice @p k between the ends of the written flanks, on points close to each other.
double written_clearance(ConedDrive& drive, CircularSplineOutline const& written, std::size_t k)
{
    distance::FullTurnClearance<motion::AnyMotion> const turn(drive.tooth, drive.maker->motion(k).motion, drive.pitch(),
                                                              drive::pitches_per_lobe(drive.scene));
    constexpr double step = 2e-3;  // mm
    double least = std::numeric_limits<double>::infinity();
    for (auto i = static_cast<std::size_t>(written.landmarks[1]); i < static_cast<std::size_t>(written.landmarks[3]);
         ++i) {
        Vec2 const from = written.outline[k][i], to = written.outline[k][i + 1];
        int const parts = 1 + static_cast<int>((to - from).norm() / step);
        for (int part = 0; part <= parts; ++part)
            least = std::min(least, turn(from + (to - from) * part / parts).distance);
    }
    return least;
}

}  // namespace

TEST_CASE("roots: with side clearance the distance is that of the outline that is written", "[law][contact]")
{
    for (auto const& [name, side_clearance] : {std::pair("type-50", 0.08), {"cycloid", 0.1}, {"s-tooth", 0.1}})
        for (char const* const surface : {"tilted", "per-slice"}) {
            // each tooth on one of both surfaces
            if (!full_run() && (name == std::string("cycloid")) != (surface == std::string("per-slice")))
                continue;
            Scene const scene = drive_of(name, surface, side_clearance, {});
            ContactStudy const study = study_contact(scene);
            ContactCase const& found = study.cases.front();
            ConedDrive drive(scene, 3, 1, 2 * found.slices.back().z);
            REQUIRE(found.backlash_offset == side_clearance);
            for (std::size_t k = 0; k < found.slices.size(); ++k) {
                double const written = written_clearance(drive, study.solution.circular_spline, k);
                CAPTURE(name, surface, k, written, found.slices[k].root.clearance, found.slices[k].root_error);
                CHECK(std::abs(found.slices[k].root.clearance - written) <=
                      found.slices[k].root_error + 2 * scene.solver.tolerance);
            }
        }
}

TEST_CASE("roots: a drive that gets the root clearance that it needs does not need any", "[law][contact]")
{
    for (auto const& [name, side_clearance] : {std::pair("type-50", 0.0), {"type-50", 0.04}, {"type-50", 0.08}}) {
        ContactCase const before = study_contact(drive_of(name, "tilted", side_clearance, {})).cases.front();
        CAPTURE(side_clearance, before.least_root_clearance);
        REQUIRE(before.least_root_clearance > 0.01);
        double const given = before.least_root_clearance + 2 * before.least_root_clearance_error;
        ContactCase const after = study_contact(drive_of(name, "tilted", side_clearance,
                                                         {"circular_spline.root_clearance=" + std::to_string(given)}))
                                      .cases.front();
        CHECK(after.least_root_clearance == 0);
        for (SliceClearance const& slice : after.slices)
            CHECK(slice.root.clearance >= -slice.root_error);
        // half of it is not enough, by the other half
        ContactCase const half =
            study_contact(drive_of(name, "tilted", side_clearance,
                                   {"circular_spline.root_clearance=" + std::to_string(given / 2)}))
                .cases.front();
        CHECK(half.least_root_clearance ==
              Approx(given / 2).margin(2 * before.least_root_clearance_error + half.least_root_clearance_error));
    }
}

}  // namespace hdconj::test::root_clearance_cases
