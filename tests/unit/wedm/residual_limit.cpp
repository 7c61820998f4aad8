// SPDX-License-Identifier: GPL-3.0-or-later
// What a round wire leaves in the corners of a space against the limit: the note of a solution, and the wire program.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "hdconj/error.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/solve.hpp"
#include "hdconj/wedm.hpp"
#include "hdconj/wire_files.hpp"
#include "support/catch.hpp"

namespace hdconj::test::residual_limit_cases {

namespace {

using Keys = std::vector<std::string>;

/// Teeth with a root wall beside the land of the root: two corners closer to each other than the wire is thick.
Scene drive(Keys const& sets)
{
    auto const reading = examine_scene(R"([drive]
name = "two corners"
module = 1.0
flexspline_teeth = 64
circular_spline_teeth = 66
[flexspline]
wall = 1.2
[flexspline.profile]
family = "double-circular-arc"
addendum = 0.9
dedendum = 1.212
convex_radius = 1.0804
convex_offset = 0.3928
concave_radius = 2.058
concave_offset = "tangent"
concave_rise = 0.2684
tip_line_from = 0.76
[wave_generator]
family = "cosine"
radial_deformation = 0.95
waves = 2
[circular_spline]
width = 12
backlash_offset = 0.03
root_clearance = 0.05
[wedm]
wire_diameter = 0.25
spark_gap = 0.012
)",
                                       "two corners", {}, sets);
    REQUIRE(reading.faults.empty());
    return reading.scene;
}

/// The note on what the wire leaves.
std::optional<Note> corner(Scene const& scene)
{
    Notes const notes = solve(scene).judgement;
    auto const found = std::ranges::find(notes, NoteCode::sharp_corner, &Note::code);
    return found == notes.end() ? std::nullopt : std::optional(*found);
}

/// The number behind @p words in @p text, as text.
std::string number_behind(std::string const& words, std::string const& text)
{
    auto const at = text.find(words);
    REQUIRE(at != std::string::npos);
    return std::to_string(std::stod(text.substr(at + words.size())));
}

/// What is refused of a wire program.
Fault refusal(Scene const& scene)
{
    try {
        (void)wire_program(scene);
    } catch (InputError const& error) {
        REQUIRE(error.faults().size() == 1);
        return error.faults().front();
    }
    FAIL("was accepted");
    return {};
}

}  // namespace

TEST_CASE("the note on what the wire leaves is what wedm finds, and wedm takes the wire that it names", "[wedm]")
{
    for (Keys const& sets : {Keys{}, Keys{"circular_spline.backlash_offset=0"}, Keys{"circular_spline.width=9"},
                             Keys{"tilt.angle_deg=0.5", "slices.count=3", "slices.surface=tilted"}}) {
        INFO((sets.empty() ? "as given" : sets.front()));
        auto const note = corner(drive(sets));
        REQUIRE(note);
        Keys with = sets;
        with.emplace_back("wedm.residual_limit=1");
        WireProgram const left = wire_program(drive(with));
        CHECK(0.01 * note->figure == Approx(left.figures.residual + left.residual_error).epsilon(1e-9));
        CHECK(note->figure > 2);
        with.back() = "wedm.wire_diameter=" + number_behind("of at most ", note->advice);
        CHECK_NOTHROW(wire_program(drive(with)));
        CHECK_FALSE(corner(drive(with)));
    }
}

TEST_CASE("the note on what the wire leaves looks at both ends of the teeth", "[wedm]")
{
    Keys sets{"wedm.wire_diameter=0.10", "tilt.angle_deg=3", "slices.count=3", "slices.surface=tilted",
              "circular_spline.width=7"};
    WireProgram const left = wire_program(drive([&] {
        Keys with = sets;
        with.emplace_back("wedm.residual_limit=1");
        return with;
    }()));
    double lower = 0, upper = 0;
    for (Residual const& residual : left.residuals)
        (residual.upper ? upper : lower) = std::max(residual.upper ? upper : lower, residual.height);
    REQUIRE(std::abs(upper - lower) > 1e-6);
    // a limit between both faces
    sets.push_back("wedm.residual_limit=" + std::to_string((lower + upper) / 2 + left.residual_error));
    auto const note = corner(drive(sets));
    REQUIRE(note);
    CHECK_THAT(note->place, ContainsSubstring(upper > lower ? "upper face" : "lower face"));
}

TEST_CASE("the limit of what the wire leaves contains the error of that", "[wedm]")
{
    WireProgram const left = wire_program(drive({"wedm.residual_limit=1"}));
    CHECK(left.residual_error == Approx(left.tolerance + left.contour_error));
    double const bound = left.figures.residual + left.residual_error;
    CHECK_NOTHROW(wire_program(drive({"wedm.residual_limit=" + std::to_string(bound + 1e-5)})));
    CHECK(refusal(drive({"wedm.residual_limit=" + std::to_string(left.figures.residual + 1e-5)})).path ==
          "wedm.wire_diameter");
}

TEST_CASE("a tolerance that hides more than the limit is refused, and both ways out work", "[wedm]")
{
    Keys const sets{"wedm.tolerance=0.02", "wedm.wire_diameter=0.08"};
    for (std::string const limit : {"0.01", "0"}) {
        Keys with = sets;
        with.push_back("wedm.residual_limit=" + limit);
        Fault const fault = refusal(drive(with));
        CHECK(fault.path == "wedm.tolerance");
        CHECK_THAT(fault.reason, ContainsSubstring("what the wire leaves is known to 0.020"));
        with.back() = "wedm.residual_limit=" + number_behind("residual_limit = ", fault.remedy);
        CHECK_NOTHROW(wire_program(drive(with)));
        if (limit == "0")
            continue;
        with = sets;
        with.front() = "wedm.tolerance=" + number_behind("wedm.tolerance = ", fault.remedy);
        CHECK_NOTHROW(check_wedm(drive(with)));
        CHECK(check_wedm(drive(with)).empty());
    }
}

TEST_CASE("what is below the tolerance is told as no more than that", "[wedm]")
{
    WireSetUps const programs{
        wire_program(drive({"wedm.tolerance=0.02", "wedm.wire_diameter=0.10", "wedm.residual_limit=0.1"}))};
    REQUIRE(programs.front().residuals.empty());
    CHECK_THAT(summary_text(programs), ContainsSubstring("<= 20") &&
                                           ContainsSubstring("no residual material above 20 um") &&
                                           !ContainsSubstring("0.000\n"));
    CHECK_THAT(summary_json(programs), ContainsSubstring("\"residual_error_um\": 20"));
}

}  // namespace hdconj::test::residual_limit_cases
