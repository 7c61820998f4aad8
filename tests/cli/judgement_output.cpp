// SPDX-License-Identifier: GPL-3.0-or-later
// Notes on a design as a user meets them: in each summary, in JSON, and as an exit status.
#include <nlohmann/json.hpp>

#include "hdconj_run.hpp"
#include "support/catch.hpp"
#include "support/read_hdf5.hpp"
#include "support/temporary_folder.hpp"

namespace hdconj::test::judgement_output_cases {
namespace {

/// The built-in drive with a wall that bends too stiffly: a warning of the scene alone, which changes no outline.
char const* const stiff =
    " --set flexspline.wall=3.5 --set '!circular_spline.inner_radius' --set '!wedm' --set '!flexspline.cup' --set "
    "'!bearing'";

}  // namespace

TEST_CASE("a warning is printed and leaves the exit status, unless --strict is given", "[judgement]")
{
    std::string const verb = GENERATE("check", "solve", "contact");
    TemporaryFolder const folder;
    auto const plain = hdconj_run(verb + stiff, folder.path());
    INFO(plain.out << plain.err);
    CHECK(plain.status == 0);
    CHECK_THAT(plain.out, ContainsSubstring("judgement: 1 warning") && ContainsSubstring("WARNING [wall-stress]") &&
                              ContainsSubstring("write flexspline.wall = "));
    auto const strict = hdconj_run(verb + stiff + " --strict --json", folder.path());
    CHECK(strict.status == 1);
    CHECK_THAT(strict.err, ContainsSubstring("1 warning, and --strict is given"));
    auto const json = nlohmann::json::parse(strict.out);  // one object and no more
    CHECK(json.at("judgement").front().at("code") == "wall-stress");
    CHECK(json.at("judgement").front().at("severity") == "warning");
}

TEST_CASE("a design without a warning passes --strict", "[judgement]")
{
    TemporaryFolder const folder;
    CHECK(hdconj_run("solve --strict", folder.path()).status == 0);
    CHECK(hdconj_run("wedm --strict -o cut", folder.path()).status == 0);
    CHECK_THAT(hdconj_run("solve", folder.path()).out, !ContainsSubstring("judgement"));
}

TEST_CASE("load judges the part that it writes, not the scene's tip circle without side clearance", "[judgement]")
{
    TemporaryFolder const folder;
    auto const loaded = hdconj_run("load --no-curve --torque 28 --strict --json", folder.path());
    INFO(loaded.out << loaded.err);
    REQUIRE(loaded.status == 0);
    auto const result = nlohmann::json::parse(loaded.out);
    CHECK(result.at("load").at("cases").at(0).at("tip_radius_mm") > 25.1);  // the scene has 25.025
}

TEST_CASE("teeth that press on both flanks without torque are a warning with the side clearance to write",
          "[judgement]")
{
    TemporaryFolder const folder;
    auto const note_of = [&](std::string const& command) {
        auto const done = hdconj_run(command + " --json --quiet -o a.h5", folder.path());
        INFO(done.err);
        REQUIRE(done.status == 0);
        auto const result = nlohmann::json::parse(done.out);
        for (auto const& note : result.at("judgement"))
            if (note.at("code") == "backlash")
                return note;
        return nlohmann::json();
    };
    std::string const load = "load --no-curve --no-errors --set slices.count=3",
                      run = "run --torque 0 --positions 4 --no-errors --set errors.circular_spline.eccentricity=0.01";
    CHECK(note_of(load).is_null());
    for (auto const& [command, place] : {std::pair(load + " --set errors.flexspline.eccentricity=0.01", "flexspline"),
                                         std::pair(run, "circular_spline")}) {
        auto const note = note_of(command);
        REQUIRE(note.is_object());
        CHECK(note.at("severity") == "warning");
        CHECK(note.at("figure") < 0);
        CHECK(note.at("place") == std::string("errors.") + place + ".eccentricity");
        CHECK_THAT(note.at("cause").get<std::string>(), ContainsSubstring("teeth press on both flanks"));
        CHECK(note_of(command + " --set " + note.at("set").at(0).get<std::string>()).is_null());
    }
    CHECK(hdconj_run(run + " --strict --quiet -o a.h5", folder.path()).status == 1);
}

TEST_CASE("HDF5 has a row for each note", "[judgement]")
{
    TemporaryFolder const folder;
    CHECK(hdconj_run("solve -o stiff.h5" + std::string(stiff), folder.path()).status == 0);
    auto const file = open_file(folder.path() / "stiff.h5");
    CHECK(read(file, "notes/figure").shape == std::vector<hsize_t>{1});
    CHECK(read(file, "notes/figure").values.front() > read(file, "notes/limit").values.front());
    for (char const* name :
         {"notes/code", "notes/severity", "notes/unit", "notes/place", "notes/cause", "notes/advice", "notes/set"})
        CHECK(has_link(file, name));
}

TEST_CASE("a refusal says first what is unusual, and JSON how to set it", "[judgement]")
{
    TemporaryFolder const folder;
    auto const large =
        hdconj_run("solve --json --set wave_generator.radial_deformation=2.5 --set '!circular_spline.inner_radius'",
                   folder.path());
    CHECK(large.status == 1);
    CHECK_THAT(large.err, ContainsSubstring("likely because the radial deformation 2.5 mm is 10 times the usual") &&
                              !ContainsSubstring("a larger wave_generator.radial_deformation"));
    auto const set = nlohmann::json::parse(large.out).at("error").at("set");
    CHECK(set.front() == "wave_generator.radial_deformation=0.25");
    auto const teeth = hdconj_run("check --json --set drive.circular_spline_teeth=203", folder.path());
    CHECK(teeth.status == 2);
    CHECK(nlohmann::json::parse(teeth.out).at("faults").front().at("set").front() == "drive.circular_spline_teeth=202");
}

TEST_CASE("what the wire leaves in a corner is what the verb wedm finds", "[judgement]")
{
    TemporaryFolder const folder;
    auto const solved = hdconj_run("solve --json --set wedm.residual_limit=1e-4", folder.path());
    auto const note = nlohmann::json::parse(solved.out).at("judgement").front();
    CHECK(note.at("code") == "sharp-corner");
    auto const cut = nlohmann::json::parse(hdconj_run("wedm --json --dialect csv -o cut", folder.path()).out);
    auto const pass = cut.at("set_ups").front().at("passes").front();
    double const height_um = pass.at("residual_um"), error_um = pass.at("residual_error_um");
    CHECK(1e3 * 1e-4 * note.at("figure").get<double>() == Approx(height_um + error_um).epsilon(1e-6));
}

}  // namespace hdconj::test::judgement_output_cases
