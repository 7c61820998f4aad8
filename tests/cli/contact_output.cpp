// SPDX-License-Identifier: GPL-3.0-or-later
// `hdconj contact` as a user meets it: the same figures in all that it writes. What holds for other verbs too:
// every_verb.cpp.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>
#include <sstream>

#include "figures/summary_figures.hpp"
#include "hdconj_run.hpp"
#include "support/catch.hpp"
#include "support/read_hdf5.hpp"

namespace hdconj::test::contact_output_cases {

using hdconj::figures::degrees_of;
using hdconj::test::Outcome;
using hdconj::test::TemporaryFolder;
using nlohmann::json;

namespace {

/// Few slices and points: what is looked at here does not depend on them.
std::string const coned =
    "'" HDCONJ_SOURCE_DIR "/data/scenes/type-50-coned.toml' --set slices.count=3 --set contact.flank_points=40 ";

Outcome contact(std::string const& arguments, TemporaryFolder const& folder)
{
    return hdconj::test::hdconj_run("contact " + arguments, folder.path());
}

std::string two_places(double value)
{
    std::ostringstream text;
    text << std::fixed << std::setprecision(2) << value;
    return text.str();
}

}  // namespace

TEST_CASE("contact names its result after the drive and says so", "[contact]")
{
    TemporaryFolder const folder;
    auto const done = contact(coned, folder);
    CHECK(done.status == 0);
    CHECK(done.err.empty());
    CHECK_THAT(done.out, ContainsSubstring("type-50-coned") && ContainsSubstring("per-slice") &&
                             ContainsSubstring("type-50-coned-contact.h5"));
    CHECK(folder.names() == std::vector<std::string>{"type-50-coned-contact.h5"});
}

TEST_CASE("contact: JSON text and HDF5 say the same", "[contact]")
{
    TemporaryFolder const folder;
    std::string const run = coned + "--surface tilted --kind radial,draft --tilt=-0.2,0,0.2 -o a.h5 ";
    auto const summary = contact(run + "--json", folder);
    REQUIRE(summary.status == 0);
    auto const text = contact(run, folder);
    REQUIRE(text.status == 0);
    json const found = json::parse(summary.out).at("contact");
    auto const& cases = found.at("cases");
    REQUIRE(cases.size() == 6);
    auto const file = hdconj::test::open_file(folder / "a.h5");
    auto const doubles = [&](char const* name) { return hdconj::test::read(file, name).values; };
    constexpr double um = 1e3, arcmin = 60 * 180 / std::numbers::pi;
    auto const tilt = doubles("/contact/tilt"), offset = doubles("/contact/backlash_offset"),
               clearing = doubles("/contact/least_side_clearance");
    auto const share = doubles("/contact/contact_fraction"), area = doubles("/contact/contact_area"),
               play = doubles("/contact/backlash");
    auto const clearance = doubles("/contact/flank_clearance");
    REQUIRE(tilt.size() == cases.size());
    for (std::size_t i = 0; i < cases.size(); ++i) {
        INFO(cases[i].dump(1));
        json const& state = cases[i].at("state");
        CHECK(cases[i].at("tilt_deg").get<double>() == Approx(tilt[i] * arcmin / 60).margin(1e-12));
        CHECK(cases[i].at("backlash_offset_um").get<double>() == Approx(offset[i] * um).epsilon(1e-12));
        CHECK(cases[i].at("least_side_clearance_um").get<double>() == Approx(clearing[i] * um).epsilon(1e-12));
        CHECK(state.at("contact_fraction").get<double>() == Approx(share[i]).epsilon(1e-12));
        CHECK(state.at("contact_area_mm2").get<double>() == Approx(area[i]).epsilon(1e-12));
        CHECK(state.at("backlash_arcmin").get<double>() == Approx(play[i] * arcmin).margin(1e-9));
        CHECK(cases[i].at("closest_flank").at("clearance_um").get<double>() ==
              Approx(clearance[i] * um).epsilon(1e-12));
        CHECK(state.at("contact_fraction").get<double>() * cases[i].at("flank_area_mm2").get<double>() ==
              Approx(state.at("contact_area_mm2").get<double>()));
        CHECK_THAT(text.out, ContainsSubstring(two_places(cases[i].at("least_side_clearance_um"))));
        CHECK_THAT(text.out, ContainsSubstring(two_places(cases[i].at("closest_flank").at("clearance_um"))));
    }
    // the case with most contact is the one that map and outline are of
    auto const shown = found.at("written_case").get<std::size_t>();
    CHECK(std::max_element(share.begin(), share.end()) - share.begin() == static_cast<std::ptrdiff_t>(shown));
    auto const gap = doubles("/contact/map/gap");
    CHECK(gap.size() == doubles("/contact/map/angle").size() * 2 * 3 * doubles("/contact/map/flank_position").size());
    CHECK(*std::min_element(gap.begin(), gap.end()) == Approx(0).margin(1e-9));
}

TEST_CASE("contact: a tilt comes back as it was asked", "[contact]")
{
    TemporaryFolder const folder;
    auto const summary = contact(coned + "--surface tilted --tilt 0.07,0.29,1.15 -o a.h5 --json", folder);
    INFO(summary.err);
    REQUIRE(summary.status == 0);
    std::vector<std::string> found;
    json const study = json::parse(summary.out).at("contact");
    for (auto const& each : study.at("cases"))
        found.push_back(each.at("tilt_deg").dump());
    CHECK(found == std::vector<std::string>{"0.07", "0.29", "1.15"});
    // every number that a user types, and no digit of one that nobody did
    constexpr double rad_per_deg = std::numbers::pi / 180;
    std::mt19937_64 draw(7);
    std::uniform_real_distribution<double> angles(-0.7, 0.7);
    for (int i = -4500; i <= 4500; ++i) {
        double const typed = i / 100.0;
        CHECK(degrees_of(typed * rad_per_deg) == typed);
    }
    for (int i = 0; i < 1000; ++i) {
        double const angle = angles(draw);
        CHECK(std::abs(degrees_of(angle) * rad_per_deg - angle) <= 0x1p-52 * std::abs(angle));
    }
}

TEST_CASE("contact of a drive without axial effects is one slice", "[contact]")
{
    TemporaryFolder const folder;
    auto const done = contact("--quiet --json -o a.h5 --set contact.flank_points=40", folder);
    REQUIRE(done.status == 0);
    json const found = json::parse(done.out).at("contact");
    REQUIRE(found.at("cases").size() == 1);
    json const& only = found.at("cases")[0];
    CHECK(only.at("slices").size() == 1);
    CHECK(only.at("kind") == "");
    CHECK(std::abs(only.at("least_side_clearance_um").get<double>()) <= 1e-6);
    CHECK(std::abs(only.at("closest_flank").at("clearance_um").get<double>()) <= 1e-6);
    CHECK(only.at("state").at("teeth").get<int>() > 0);
}

TEST_CASE("contact: --best answers for each kind and says where it looked", "[contact]")
{
    TemporaryFolder const folder;
    auto const done =
        contact(coned +
                    "--surface tilted --kind radial,draft --best --tilt=-0.5,0.5 --set solver.tolerance=1e-4 "
                    "--quiet --json -o a.h5",
                folder);
    INFO(done.err);
    REQUIRE(done.status == 0);
    json const found = json::parse(done.out).at("contact");
    REQUIRE(found.at("best").size() == 4);
    for (auto const& best : found.at("best")) {
        INFO(best.dump());
        CHECK(best.at("from_deg").get<double>() == Approx(-0.5));
        CHECK(best.at("to_deg").get<double>() == Approx(0.5));
        CHECK(best.at("tilt_deg").get<double>() >= -0.5);
        CHECK(best.at("tilt_deg").get<double>() <= 0.5);
        bool const area = best.at("goal") == "contact area";
        for (auto const& each : found.at("cases")) {
            if (each.at("kind") != best.at("kind"))
                continue;
            // nothing that was computed on the way is better
            if (area) {
                CHECK(best.at("contact_fraction").get<double>() >=
                      each.at("state").at("contact_fraction").get<double>() * (1 - 1e-12));
            } else {
                CHECK(best.at("least_side_clearance_um").get<double>() <=
                      each.at("least_side_clearance_um").get<double>() * (1 + 1e-12));
            }
        }
    }
}

TEST_CASE("contact: a case that cannot be made is named and leaves the others as they are", "[contact]")
{
    TemporaryFolder const folder;
    std::string const run = coned + "--surface tilted --kind radial,draft --tilt 0,4 -o a.h5 ";
    auto const done = contact(run + "--json", folder);
    INFO(done.err);
    CHECK(done.status == 1);
    std::string const reason = "no result for tilt 4 deg, kind \"draft\", surface \"tilted\": ";
    CHECK_THAT(done.err, ContainsSubstring("hdconj: 1 result is missing") && ContainsSubstring(reason));
    json const summary = json::parse(done.out);
    json const& cases = summary.at("contact").at("cases");
    REQUIRE(cases.size() == 3);
    std::string notes;
    for (auto const& note : summary.at("notes"))
        notes += note.get<std::string>();
    CHECK_THAT(notes, ContainsSubstring(reason));
    auto const file = hdconj::test::open_file(folder / "a.h5");
    CHECK(hdconj::test::read(file, "/contact/tilt").values.size() == 3);
    CHECK(H5Aexists_by_name(file, "/", "notes", H5P_DEFAULT) > 0);
    // the others are those of a run without it
    auto const without = contact(coned + "--surface tilted --kind radial --tilt 0,4 -o b.h5 --json", folder);
    REQUIRE(without.status == 0);
    json const alone = json::parse(without.out).at("contact").at("cases").back();
    for (auto const* key : {"tilt_deg", "backlash_offset_um", "least_side_clearance_um", "state"})
        CHECK(alone.at(key) == cases[1].at(key));
    // none at all is an error, and leaves nothing behind
    auto const none = contact(coned + "--surface tilted --kind draft --tilt 4,5 -o none.h5", folder);
    CHECK(none.status == 1);
    CHECK_THAT(none.err, ContainsSubstring("draft"));
    CHECK_FALSE(std::filesystem::exists(folder / "none.h5"));
}

}  // namespace hdconj::test::contact_output_cases
