// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Hard cases of tooth families: pieces that all but vanish, corners, crossings, too much data.
#include <fstream>

#include "row.hpp"
#include "support/temporary_folder.hpp"

namespace hdconj::test::families_cases {

namespace {

/// The tooth of data/scenes/arc-chain.toml with other pieces.
Overrides chain(std::string const& pieces, std::string const& tip_thickness = "0.2",
                std::string const& tip_angle = "38")
{
    return {"!flexspline.profile",
            "flexspline.profile.family=arc-chain",
            "flexspline.profile.addendum=0.2",
            "flexspline.profile.dedendum=0.28",
            "flexspline.profile.tip_thickness=" + tip_thickness,
            "flexspline.profile.tip_angle_deg=" + tip_angle,
            "flexspline.profile.pieces=" + pieces,
            "!circular_spline.inner_radius"};
}

Overrides curve(std::string const& family, std::string const& points)
{
    return {"!flexspline.profile", "flexspline.profile.family=" + family, "flexspline.profile.points=" + points,
            "!circular_spline.inner_radius"};
}

double distance_of_landmarks(Solution const& a, Solution const& b)
{
    double worst = 0;
    for (std::size_t k = 0; k < a.circular_spline.landmarks.size(); ++k)
        worst =
            std::max(worst, (a.circular_spline.outline[0][static_cast<std::size_t>(a.circular_spline.landmarks[k])] -
                             b.circular_spline.outline[0][static_cast<std::size_t>(b.circular_spline.landmarks[k])])
                                .norm());
    return worst;
}

std::string const usual = "[[0.16, 20.0], [0.35, 9.0], [0.06], [-0.5, 60.0]]";

}  // namespace

HARD_ROW("arc of radius 1e-9", "a joint rounded by a nanometre's millionth: its sweep of 10 degrees stays",
         "right answer")
{
    right_answer(chain("[[0.16, 20.0], [1e-9, 10.0], [0.35, 2.0], [0.06], [-0.5, 60.0]]"));
}

HARD_ROW("arc of radius 1e-15", "shorter than the roundings of the tooth", "the tooth with a corner in its place")
{
    Solution const small = right_answer(chain("[[0.16, 20.0], [1e-15, 10.0], [0.35, 2.0], [0.06], [-0.5, 60.0]]"));
    Solution const larger = right_answer(chain("[[0.16, 20.0], [1e-10, 10.0], [0.35, 2.0], [0.06], [-0.5, 60.0]]"));
    CHECK(distance_of_landmarks(small, larger) < 1e-8);
}

HARD_ROW("arc of radius 1e5 mm", "its centre is 4000 radii of the gear away", "right answer")
{
    right_answer(chain("[[0.16, 20.0], [0.35, 9.0], [1e5, 3.4e-5], [-0.5, 60.0]]"));
}

HARD_ROW("arc of sweep 0 and line of length 0", "pieces that are not there", "the same bits as without them")
{
    Solution const with = right_answer(chain("[[0.16, 20.0], [0.2, 0.0], [0.35, 9.0], [0.0], [0.06], [-0.5, 60.0]]"));
    CHECK(same_bits(with, solve(builtin_scene(chain(usual)))));
}

HARD_ROW("arc of sweep 1e-12 degrees and line of 1e-12 mm", "pieces shorter than the gear's roundings",
         "the tooth without them to 1e-8")
{
    Solution const with =
        right_answer(chain("[[0.16, 20.0], [0.2, 1e-12], [0.35, 9.0], [1e-12], [0.06], [-0.5, 60.0]]"));
    CHECK(distance_of_landmarks(with, solve(builtin_scene(chain(usual)))) < 1e-8);
}

HARD_ROW("joint without curvature", "G1: convex to concave with no line between", "right answer")
{
    right_answer(chain("[[0.16, 20.0], [0.35, 14.0], [-0.7, 60.0]]"));
}

HARD_ROW("round tip", "no tip land: the flanks meet on the axis with a common tangent", "right answer")
{
    right_answer(chain("[[0.09, 80.0], [0.1], [-0.5, 60.0]]", "0", "90"));
}

HARD_ROW("corner on the flank", "G0: an arc of radius 1e-14 turns the flank by 15 degrees",
         "right answer: the corner sweeps a path of its own")
{
    Solution const s = right_answer(chain("[[0.16, 20.0], [1e-14, 15.0], [0.1], [-0.7, 60.0]]"));
    bool corner = false;
    for (BranchRecord const& branch : s.branches)
        corner = corner || (branch.kind == "corner" && branch.segment_name.find("tip land") == std::string::npos);
    CHECK(corner);
}

HARD_ROW("self-crossing flank", "a Bezier curve with a loop", "refused with the reason")
{
    refused(curve("bezier", "[[0.06, 0.2], [0.6, -0.5], [-0.4, -0.5], [0.29, -0.28]]"), "flexspline.profile");
}

HARD_ROW("points out of order", "the spline goes up and down and crosses itself", "refused with the reason")
{
    TemporaryFolder const folder;
    std::ofstream(folder / "points.csv") << "0.05,0.2\n0.24,-0.1\n0.12,0.1\n0.3,0.02\n0.2,-0.15\n0.3,-0.28\n";
    refused({"!flexspline.profile", "flexspline.profile.family=points",
             "flexspline.profile.file=" + (folder / "points.csv").string(), "!circular_spline.inner_radius"},
            "flexspline.profile");
}

HARD_ROW("half a tooth as a whole one", "side = full with one flank only - found by fuzzing: an open region",
         "refused: where it begins and ends")
{
    TemporaryFolder const folder;
    std::ofstream(folder / "points.csv") << "0.05,0.2\n0.1,0.12\n0.16,0\n0.2,-0.1\n0.25,-0.2\n0.3,-0.28\n";
    refused({"!flexspline.profile", "flexspline.profile.family=points",
             "flexspline.profile.file=" + (folder / "points.csv").string(), "flexspline.profile.side=full",
             "!circular_spline.inner_radius"},
            "left of its centre line");
}

HARD_ROW("a million measured points", "an hour of work for noise", "refused in time with how many would do")
{
    TemporaryFolder const folder;
    std::ofstream out(folder / "points.csv");
    out.precision(12);
    for (int i = 0; i <= 1000000; ++i) {
        double const s = i * 1e-6;
        out << 0.06 + 0.23 * s * s << "," << 0.2 - 0.48 * s << "\n";
    }
    out.close();
    refused({"!flexspline.profile", "flexspline.profile.family=points",
             "flexspline.profile.file=" + (folder / "points.csv").string(), "!circular_spline.inner_radius"},
            "write at most 10000");
}

HARD_ROW("two thousand measured points", "each piece is 0.3 um long", "right answer")
{
    TemporaryFolder const folder;
    std::ofstream out(folder / "points.csv");
    out.precision(17);
    for (int i = 0; i <= 2000; ++i) {
        double const s = i / 2000.0;
        out << 0.06 + 0.23 * s * s << "," << 0.2 - 0.48 * s << "\n";
    }
    out.close();
    Scene scene =
        builtin_scene({"!flexspline.profile", "flexspline.profile.family=points",
                       "flexspline.profile.file=" + (folder / "points.csv").string(), "!circular_spline.inner_radius"});
    Solution const solution = solve(scene);
    CHECK(all_finite(solution));
    CHECK(solution.check->smallest_clearance > -1e-10);
    // the same flank as one parabola
    Solution const exact = solve(builtin_scene(curve("bezier", "[[0.06, 0.2], [0.06, -0.04], [0.29, -0.28]]")));
    CHECK(distance_of_landmarks(solution, exact) < 1e-8);
    say(std::to_string(solution.branches.size()) + " branches");
}

HARD_ROW("involute tooth", "transcendental flank as polynomials of degree 9", "right answer")
{
    right_answer_of(read_scene(std::string(HDCONJ_SOURCE_DIR) + "/data/scenes/involute.toml"), "");
}

HARD_ROW("S-tooth with deviation", "the locus has an inflection", "right answer")
{
    right_answer_of(read_scene(std::string(HDCONJ_SOURCE_DIR) + "/data/scenes/s-tooth-deviated.toml"), "");
}

}  // namespace hdconj::test::families_cases
