// SPDX-License-Identifier: GPL-3.0-or-later
// Which flanks the picture of an inspection draws.
#include <fmt/format.h>

#include "hdconj/inspect.hpp"
#include "report/plots/plots.hpp"
#include "support/catch.hpp"

namespace hdconj::test::inspect_picture_cases {
namespace {

/// A ring of level flanks; the right flank of tooth 4 has a bump of 20 um.
Inspection ring_with_bump(int teeth)
{
    Inspection ring;
    ring.nominal.push_back({0, 0.6, 25, 0.7, 0});
    for (int tooth = 1; tooth <= teeth; ++tooth)
        for (bool const right : {false, true}) {
            double const bump = right && tooth == 4 ? 0.02 : 0;
            for (double const s : {0.1, 0.3, 0.5})
                ring.points.push_back({1, 0, tooth, right, s, s == 0.3 ? bump : 0});
            FlankFigures flank;
            flank.tooth = tooth;
            flank.right = right;
            flank.form.value = bump;
            ring.flanks.push_back(flank);
        }
    return ring;
}

/// The rows of a block of data.
std::string block(std::string const& script, std::string const& name)
{
    auto const from = script.find('$' + name + " <<");
    REQUIRE(from != std::string::npos);
    return script.substr(from, script.find('$', from + 1) - from);
}

}  // namespace

TEST_CASE("the picture of an inspection draws the worst flank and says that it leaves out others", "[inspect][plot]")
{
    std::string const script = report::inspect_chart_script(ring_with_bump(100));
    CHECK(block(script, "right_traces").find("0.3 20\n") != std::string::npos);
    CHECK(block(script, "right_band").find("0.3 0 20\n") != std::string::npos);
    CHECK(script.find("21 of 100 flanks drawn, grey: all") != std::string::npos);
    CHECK(script.find("20 of 100 flanks drawn, grey: all") != std::string::npos);
    CHECK(report::inspect_chart_script(ring_with_bump(14)).find("flanks drawn") == std::string::npos);
}

}  // namespace hdconj::test::inspect_picture_cases
