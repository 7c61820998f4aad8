// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What a report keeps of a drive whose parts are not all computed.
#include <algorithm>
#include <string>
#include <vector>

#include "hdconj/error.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/report.hpp"
#include "support/catch.hpp"

namespace hdconj::test::drive_report_cases {
namespace {

/// Why a part that was asked for is missing; empty: it is not.
std::string why_missing(ReportedDrive const& drive, std::string const& part)
{
    auto const found =
        std::ranges::find_if(drive.left_out, [&](LeftOut const& each) { return each.failed && each.part == part; });
    return found == drive.left_out.end() ? "" : found->why;
}

}  // namespace

TEST_CASE("a report that is stopped keeps the parts before, and names the rest", "[report]")
{
    ReportOptions options;
    options.parts = {ReportPart::design, ReportPart::load, ReportPart::contact};
    options.load.curve = options.load.errors = false;
    options.load.torque = 1000;
    int asked = 0, allowed = 0;
    options.stop = [&] { return asked++ >= allowed; };
    Scene const scene = builtin_scene({"slices.count=3", "contact.flank_points=20", "!load"});
    SECTION("before any part")
    {
        ReportedDrive const drive = report_drive(scene, options);
        for (char const* part : {"contact", "load", "design"})
            CHECK(why_missing(drive, part) == "the run was stopped before");
        CHECK_FALSE(drive.contact);
        CHECK(drive.teeth);
        CHECK_FALSE(drive.solution.circular_spline.outline.empty());
        CHECK(why_missing(drive, "run").empty());  // not asked for
    }
    SECTION("during load")
    {
        allowed = 2;  // contact, load
        ReportedDrive const drive = report_drive(scene, options);
        CHECK(drive.contact);
        CHECK(why_missing(drive, "contact").empty());
        CHECK_FALSE(drive.load);
        CHECK(why_missing(drive, "load").find("stopped") != std::string::npos);
        CHECK_FALSE(drive.design);
    }
    SECTION("after all")
    {
        allowed = 1000000;
        ReportedDrive const drive = report_drive(scene, options);
        CHECK(drive.contact);
        CHECK(drive.load);
        CHECK(drive.design);
        CHECK(std::ranges::none_of(drive.left_out, &LeftOut::failed));
    }
}

TEST_CASE("a drive of a report that is not begun any more is named", "[report]")
{
    Report const report = report_drives(
        std::vector{1, 2}, [](int number) { return "drive " + std::to_string(number); },
        [](int number) {
            if (number == 2)
                throw NumericalError(ErrorCode::stopped, "report", "drive 2", "the run was stopped before");
            return ReportedDrive();
        });
    CHECK(report.drives.size() == 1);
    REQUIRE(report.failed.size() == 1);
    CHECK(report.failed.front().name == "drive 2");
}

}  // namespace hdconj::test::drive_report_cases
