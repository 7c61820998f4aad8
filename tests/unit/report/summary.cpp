// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "hdconj/inspect_files.hpp"
#include "hdconj/result_files.hpp"
#include "support/catch.hpp"
#include "support/json_keys.hpp"
#include "support/sample_solution.hpp"
#include "support/temporary_folder.hpp"

namespace hdconj::test::summary_cases {

using test::collect_keys;

TEST_CASE("the text names what a designer looks for")
{
    auto const text = summary_text(sample::solution(), {{"hdf5", "out/type-50.h5", 0.0021}}, SummaryDetail::zones);
    for (auto const* part :
         {"type-50", "200/202", "ratio -100", "24.347000 mm", "-2.567 um", "convex arc right", "outer  yes", "inner  -",
          "the teeth touch", "+- 0.00032 um", "+- 4e-09 um", "by at most 1.7e-11 deg of phi and 5.0e-14 of t", "error",
          "total", "out/type-50.h5", "2.100 ms"}) {
        CHECK_THAT(text, ContainsSubstring(part));
    }
    auto const brief = summary_text(sample::solution());
    CHECK_THAT(brief, ContainsSubstring("--verbose lists them") && !ContainsSubstring("t from"));
    CHECK(brief.find("the teeth touch") < brief.find("conjugate zones"));
}

TEST_CASE("the text says when the pair was not checked, and when it interferes")
{
    auto solution = sample::solution();
    solution.check->smallest_clearance = -0.0781;
    CHECK_THAT(summary_text(solution), ContainsSubstring("-78.1 um   +- 1.3e-09 um, the teeth interfere"));
    solution.check.reset();
    CHECK_THAT(summary_text(solution), ContainsSubstring("not computed"));
    CHECK_FALSE(summary_text(Solution{}).empty());
}

TEST_CASE("JSON carries the same figures under its documented keys")
{
    auto const solution = sample::solution();
    auto const json = nlohmann::json::parse(summary_json(solution, {{"dxf", "a.dxf", 0.5}}));
    CHECK(json.at("format") == "hdconj-summary");
    CHECK(json.at("geometry").at("r_m_mm") == solution.geometry.r_m);
    CHECK(json.at("geometry").at("r_0_less_r_m_um").get<double>() == Approx(-2.567));
    CHECK(json.at("conjugate_zones").size() == solution.zones.size());
    CHECK(json.at("clearance").at("checked_points") == solution.check->points);
    CHECK(json.at("clearance").at("smallest_clearance_mm") == solution.check->smallest_clearance);
    CHECK(json.at("circular_spline").at("landmarks").size() == 5);
    CHECK(json.at("timing").at("total_s").get<double>() == Approx(0.01371));
    CHECK(json.at("files").at("dxf").at("path") == "a.dxf");
    CHECK(json.at("branches").at("count") == solution.branches.size());
}

TEST_CASE("JSON has null where there is no number, and no clearance where none was computed")
{
    auto solution = sample::solution();
    solution.error.chord = std::numeric_limits<double>::quiet_NaN();
    solution.geometry.ratio = -std::numeric_limits<double>::infinity();
    solution.check.reset();
    auto const json = nlohmann::json::parse(summary_json(solution));
    CHECK(json.at("error").at("error_chord_mm").is_null());
    CHECK(json.at("geometry").at("ratio").is_null());
    CHECK_FALSE(json.contains("clearance"));
    CHECK(nlohmann::json::parse(summary_json(Solution{})).at("conjugate_zones").empty());
}

TEST_CASE("text and JSON say whether all roots are certified, and where not")
{
    auto solution = sample::solution();
    CHECK_THAT(summary_text(solution),
               ContainsSubstring("not certified: 1 place where") && ContainsSubstring("a contact touches the end"));
    auto const doubted = nlohmann::json::parse(summary_json(solution)).at("certificate");
    CHECK(doubted.at("certified") == false);
    CHECK(doubted.at("undecided").at(0).at("reach_mm") == 2e-17);
    CHECK(doubted.at("undecided").at(0).at("u_width_deg").get<double>() == Approx(3e-7 * 180 / 3.14159265358979));
    solution.certificate = {};
    CHECK_THAT(summary_text(solution), ContainsSubstring("certified: all 67 roots found, none lost"));
    CHECK(nlohmann::json::parse(summary_json(solution)).at("certificate").at("certified") == true);
}

TEST_CASE("a file name that is not UTF-8 does not break the JSON")
{
    std::string const text = summary_json(Solution{}, {{"hdf5", "a\xff.h5", 0}});
    CHECK(nlohmann::json::accept(text));
}

TEST_CASE("docs/reference/json.md names every key")
{
    auto const document = test::content(HDCONJ_SOURCE_DIR "/docs/reference/json.md");
    std::set<std::string> keys;
    collect_keys(nlohmann::json::parse(summary_json(sample::solution(), {{"hdf5", "a", 0}, {"dxf", "b", 0}})), keys);
    CHECK(keys.size() > 60);
    for (auto const& key : keys)
        CHECK_THAT(document, ContainsSubstring("`" + key + "`"));
}

TEST_CASE("what is measured of a circular spline are its tooth spaces")
{
    Inspection inspection;
    inspection.planes.emplace_back();
    CHECK_THAT(summary_text(inspection, {}), ContainsSubstring("\nteeth at z = ") && !ContainsSubstring("tooth space"));
    inspection.options.part = InspectedPart::circular_spline;
    CHECK_THAT(summary_text(inspection, {}),
               ContainsSubstring("\ntooth spaces at z = ") && ContainsSubstring("width of the space"));
}

}  // namespace hdconj::test::summary_cases
