// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The verbs contact, load and run state the dimensions of the ring that solve makes of the scene, and write a part
/// with the side clearance that they compute with.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "hdconj/contact.hpp"
#include "hdconj/load.hpp"
#include "hdconj/running.hpp"
#include "hdconj/units.hpp"
#include "support/catch.hpp"
#include "support/coned_drive.hpp"
#include "support/polyline.hpp"

namespace hdconj::test::ring_of_studies_cases {

using Keys = std::vector<std::string>;

ContactStudy contact_of(Scene const& scene)
{
    ContactOptions options;
    options.errors = false;
    return study_contact(scene, options);
}

LoadStudy load_of(Scene const& scene, bool errors = false)
{
    LoadOptions options;
    options.torque = 20 * newton_metre;
    options.curve = false;
    options.errors = errors;
    return study_load(scene, options);
}

RunStudy run_of(Scene const& scene)
{
    RunOptions options;
    options.torque = 0;
    options.positions = 4;
    options.errors = false;
    return study_run(scene, options);
}

void check_same_ring(Solution const& told, Solution const& made)
{
    PairGeometry const &a = told.geometry, &b = made.geometry;
    auto const close = [](double value) { return Approx(value).margin(1e-9); };
    CHECK(a.circular_spline_inner_radius == close(b.circular_spline_inner_radius));
    CHECK(a.space_depth == close(b.space_depth));
    CHECK(a.land_half_angle == close(b.land_half_angle));
    CHECK(told.error.side_clearance == made.error.side_clearance);
    CHECK(told.error.land == close(made.error.land));
    CHECK(told.error.clearance == close(made.error.clearance));
    REQUIRE(told.check);
    CHECK(told.check->smallest_clearance == close(made.check->smallest_clearance));
}

/// The dimensions told against the outline in the middle of the face width.
void check_outline(Solution const& told)
{
    CircularSplineOutline const& spline = told.circular_spline;
    std::vector<Vec2> const& middle = spline.outline[spline.outline.size() / 2];
    auto const at = [&](std::size_t landmark) { return middle[static_cast<std::size_t>(spline.landmarks[landmark])]; };
    auto const angle = [](Vec2 const& p) { return std::abs(std::atan2(p.x(), p.y())); };
    double const pitch = 2 * std::numbers::pi / told.scene.drive.circular_spline_teeth;
    CHECK(middle.front().norm() == Approx(told.geometry.circular_spline_inner_radius).margin(1e-9));
    double bottom = 0;
    for (Vec2 const& p : middle)
        bottom = std::max(bottom, p.norm());
    CHECK(bottom - middle.front().norm() == Approx(told.geometry.space_depth).margin(1e-6));
    CHECK((pitch - angle(at(0)) - angle(at(4))) / 2 == Approx(told.geometry.land_half_angle).margin(1e-8));
}

TEST_CASE("studies: contact and run state the ring of solve, and write it", "[law][contact]")
{
    Keys const quick{"contact.flank_points=40"};
    Keys const sliced{"slices.count=3", "slices.surface=tilted"};
    for (Keys const& keys :
         {Keys{}, Keys{"circular_spline.backlash_offset=0.02"}, Keys{"circular_spline.backlash_offset=auto"},
          with(sliced, {"circular_spline.backlash_offset=0.03", "tilt.angle_deg=0.05"}),
          with(sliced, {"circular_spline.backlash_offset=auto", "tilt.angle_deg=0.2"})}) {
        INFO((keys.empty() ? "as built in" : keys.back()) << ", " << keys.size());
        Scene const scene = builtin_scene(with(keys, quick));
        Solution const made = solve(scene);
        for (Solution const& told : {contact_of(scene).solution, run_of(scene).solution}) {
            check_same_ring(told, made);
            check_outline(told);
        }
    }
}

TEST_CASE("studies: of a coned drive the ring is that of solve, whatever part the teeth need", "[law][contact]")
{
    for (std::string const offset : {"0", "0.02", "auto"}) {
        INFO("side clearance " << offset);
        Scene const scene =
            builtin_scene(with(coned("mapped"), {"circular_spline.backlash_offset=" + offset, "contact.flank_points=40",
                                                 "slices.count=3", "slices.surface=tilted"}));
        ContactStudy const study = contact_of(scene);
        check_same_ring(study.solution, solve(scene));
        CHECK(study.cases.front().backlash_offset > 0.03);
        if (offset == "auto")
            check_outline(study.solution);
    }
}

TEST_CASE("studies: load and run say that a bent cup has another ring, and the keys with which solve makes it",
          "[law][load]")
{
    Keys const quick{"contact.flank_points=40",
                     "slices.count=3",
                     "slices.surface=tilted",
                     "bearing.circles=5",
                     "load.torque=28",
                     "circular_spline.inner_radius=25.1",
                     "circular_spline.backlash_offset=0.06"};
    Scene const scene = builtin_scene(quick);
    Solution const told = load_of(scene, false).solution;
    REQUIRE(told.notes.size() == 1);
    CHECK_THAT(told.notes.front(),
               ContainsSubstring("write coning.model = \"elastic\" and coning.bottom_to_middle = 9 into the scene"));
    Scene const bent = builtin_scene(with(quick, {"coning.model=elastic", "coning.bottom_to_middle=9"}));
    check_same_ring(told, solve(bent));
    CHECK(std::abs(told.geometry.space_depth - solve(scene).geometry.space_depth) > 1e-4);
    CHECK(load_of(bent, false).solution.notes.empty());
    RunOptions first_contact;
    first_contact.torque = 0;
    first_contact.positions = 4;
    CHECK(study_run(scene, first_contact).solution.notes.empty());  // in the shape of the cam
    RunOptions under_torque;
    under_torque.positions = 4;
    under_torque.errors = false;
    CHECK(study_run(scene, under_torque).solution.notes == told.notes);
}

TEST_CASE("studies: load states the ring of solve, and how well the cup is known where errors are asked for",
          "[law][load]")
{
    for (std::string const offset : {"0.02", "auto", "0"}) {
        INFO("side clearance " << offset);
        Scene const scene =
            read_scene(file_of("type-50-elastic"),
                       {"circular_spline.backlash_offset=" + offset, "contact.flank_points=40", "slices.count=3",
                        "slices.surface=tilted", "bearing.circles=5", "circular_spline.inner_radius=25.1"});
        Solution const made = solve(scene);
        bool const errors = offset == "0";
        Solution const told = load_of(scene, errors).solution;
        check_same_ring(told, made);
        REQUIRE(made.error.cup > 0);
        if (errors)
            CHECK(told.error.cup == made.error.cup);
        else
            CHECK(std::isnan(told.error.cup));
    }
}

TEST_CASE("studies: a ring that needs a wider tip circle for its side clearance is stated with it", "[law][contact]")
{
    Keys const given{"circular_spline.backlash_offset=0.045", "contact.flank_points=40"};
    CHECK_THROWS_AS(solve(builtin_scene(given)), NumericalError);
    ContactStudy const study = contact_of(builtin_scene(given));
    REQUIRE(study.solution.notes.size() == 1);
    CHECK(study.solution.geometry.circular_spline_inner_radius == study.cases.front().tip);
    check_outline(study.solution);
}

TEST_CASE("studies: slices with outlines of their own are those of solve, with the same tip circle", "[law][contact]")
{
    for (std::string const surface : {"ruled", "per-slice"})
        for (std::string const offset : {"0", "0.03"}) {
            INFO(surface << ", side clearance " << offset);
            Scene const scene =
                builtin_scene(with(coned(), {"slices.count=3", "slices.surface=" + surface, "contact.flank_points=40",
                                             "circular_spline.backlash_offset=" + offset}));
            ContactStudy const study = contact_of(scene);
            REQUIRE(study.cases.front().backlash_offset == scene.circular_spline.backlash_offset);
            Solution const made = solve(scene);
            CHECK(study.cases.front().tip == made.geometry.circular_spline_inner_radius);
            CHECK(study.solution.circular_spline.outline == made.circular_spline.outline);
        }
}

TEST_CASE("studies: the part that is written has the side clearance of its case", "[law][contact]")
{
    auto const written = [](std::string const& offset) {
        ContactStudy study = contact_of(
            read_scene(file_of("type-50-elastic"), {"slices.count=3", "slices.surface=ruled", "contact.flank_points=40",
                                                    "bearing.circles=5", "circular_spline.backlash_offset=" + offset}));
        CHECK(study.cases.front().backlash_offset == Approx(std::stod(offset)));
        return study.solution.circular_spline;
    };
    CircularSplineOutline const bare = written("0");
    for (std::string const offset : {"0.005", "0.02"}) {
        INFO("side clearance " << offset);
        CircularSplineOutline const part = written(offset);
        // between the ends of the flank; the rulings lean, so that the middle plane moves by a little less
        for (std::size_t k = 0; k < part.z.size(); ++k) {
            auto const first = part.outline[k].begin() + part.landmarks[3],
                       last = part.outline[k].begin() + part.landmarks[4];
            Vec2 const p = *(first + (last - first) / 2);
            CHECK(distance_to_polyline(bare.outline[k], p) == Approx(std::stod(offset)).epsilon(0.02));
        }
    }
}

TEST_CASE("studies: a part that cannot be made with its side clearance is missing", "[law][contact]")
{
    Scene const scene =
        builtin_scene({"slices.count=3", "circular_spline.backlash_offset=0.1", "contact.flank_points=40"});
    ContactOptions options;
    options.errors = false;
    options.kinds = {TiltKind::draft};
    options.tilts = {3 * deg, 0.5 * deg};
    ContactStudy const study = study_contact(scene, options);
    CHECK(study.cases.size() == 1);
    CHECK(study.missing.size() == 1);
}

}  // namespace hdconj::test::ring_of_studies_cases
