// SPDX-License-Identifier: GPL-3.0-or-later
// A program of a stored result says all that the program of its scene says.
#include <string>
#include <vector>

#include "hdconj/read_scene.hpp"
#include "hdconj/result_files.hpp"
#include "hdconj/solve.hpp"
#include "hdconj/wedm.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

namespace hdconj::test::stored_solution_cases {
namespace {

using Sets = std::vector<std::string>;

/// A scene of data/scenes, the keys with which it is solved, and those with which it is cut.
struct Stored
{
    std::string scene;
    Sets solved, cut;
};

void check_same(Notes const& a, Notes const& b)
{
    REQUIRE(a.size() == b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        CHECK(to_string(a[i].code) == to_string(b[i].code));
        CHECK(a[i].severity == b[i].severity);
        CHECK(a[i].figure == Approx(b[i].figure).epsilon(1e-9));
        CHECK(a[i].limit == b[i].limit);
        CHECK(a[i].unit == b[i].unit);
        CHECK(a[i].place == b[i].place);
        CHECK(a[i].cause == b[i].cause);
        CHECK(a[i].advice == b[i].advice);
        CHECK(a[i].set == b[i].set);
    }
}

}  // namespace

TEST_CASE("a program of a stored result has the errors, notes and judgement of its scene's", "[wedm]")
{
    Sets const wire{"wedm.wire_diameter=0.1", "wedm.spark_gap=0.006", "wedm.surface_limit=0.1"};
    std::size_t noted = 0, judged = 0;
    for (auto const& [name, solved, cut] :
         {Stored{"type-50-elastic", {"slices.count=3"}, {}},
          {"type-50", {"tilt.angle_deg=0.2", "slices.count=3", "circular_spline.backlash_offset=\"auto\""}, {}},
          {"type-50", {"wave_generator.radial_deformation=0.15", "circular_spline.inner_radius=25.1"}, {}},
          {"type-50", {}, {"wedm.wire_diameter=0.33", "wedm.residual_limit=0.05"}},
          {"type-50", {"wedm.wire_diameter=0.3", "wedm.residual_limit=0.012"}, {"wedm.wire_diameter=0.05"}}}) {
        INFO(name << (solved.empty() ? "" : " " + solved.front()) << (cut.empty() ? "" : " " + cut.front()));
        std::string const file = HDCONJ_SOURCE_DIR "/data/scenes/" + name + ".toml";
        Sets sets = wire;
        sets.insert(sets.end(), solved.begin(), solved.end());
        TemporaryFolder const folder;
        write_hdf5(solve(read_scene(file, sets)), folder / "a.h5");
        sets.insert(sets.end(), cut.begin(), cut.end());
        Scene const scene = read_scene(file, sets);
        WireProgram const from = wire_program(scene, read_outline(folder / "a.h5").solution),
                          direct = wire_program(scene);
        CHECK((from.cup_error > 0) == scene.coning.has_value());
        CHECK(from.cup_error == direct.cup_error);
        CHECK((from.contour_error > scene.solver.tolerance) == scene.circular_spline.automatic_backlash);
        CHECK(from.contour_error == direct.contour_error);
        CHECK(from.notes == direct.notes);
        check_same(from.judgement, direct.judgement);
        noted += from.notes.size();
        judged += from.judgement.size();
    }
    CHECK(noted > 2);
    CHECK(judged > 2);
}

}  // namespace hdconj::test::stored_solution_cases
