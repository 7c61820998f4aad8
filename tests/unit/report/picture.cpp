// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <stdexcept>

#include "hdconj/error.hpp"
#include "hdconj/file/atomic_file.hpp"
#include "hdconj/result_files.hpp"
#include "report/plots/gnuplot.hpp"
#include "report/plots/plot.hpp"
#include "report/plots/plot_templates.hpp"
#include "support/catch.hpp"
#include "support/gnuplot.hpp"
#include "support/sample_solution.hpp"
#include "support/temporary_folder.hpp"

namespace hdconj::test::picture_cases {

using test::content;
using test::EmptyPath;
using test::no_gnuplot;
using test::TemporaryFolder;

TEST_CASE("pictures are drawn as SVG and PNG")
{
    if (no_gnuplot())
        return;
    TemporaryFolder const folder;
    auto solution = sample::solution();
    solution.scene.drive.name = "it's <a> \"drive\" & {co} \\n";
    write_picture(solution, folder / "a.svg");
    auto const svg = content(folder / "a.svg");
    CHECK(svg.rfind("<?xml", 0) == 0);
    CHECK(svg.find("</svg>") != std::string::npos);
    CHECK(svg.find("it's &lt;a") != std::string::npos);
    write_picture(solution, folder / "b.PNG");
    CHECK(content(folder / "b.PNG").rfind("\x89PNG", 0) == 0);
    CHECK(folder.names().size() == 2);
}

TEST_CASE("a solution without branches or family still has a picture")
{
    if (no_gnuplot())
        return;
    TemporaryFolder const folder;
    auto solution = sample::solution();
    solution.branches.clear();
    solution.tooth_family.clear();
    write_picture(solution, folder / "a.svg");
    CHECK(content(folder / "a.svg").find("circular spline") != std::string::npos);
}

TEST_CASE("other endings are bad input, a missing gnuplot is said by name")
{
    TemporaryFolder const folder;
    CHECK_THROWS_AS(check_picture(folder / "a.jpg"), InputError);
    CHECK_THROWS_AS(check_picture(folder / "a"), InputError);
    EmptyPath const nothing;
    CHECK_THROWS_AS(write_picture(sample::solution(), folder / "a.svg"), FileError);
    CHECK_THROWS_WITH(check_picture(folder / "a.svg"), ContainsSubstring("gnuplot-nox"));
    CHECK_THROWS_WITH(report::gnuplot::draw(""), ContainsSubstring("gnuplot-nox"));
}

TEST_CASE("what gnuplot complains about is passed on")
{
    if (no_gnuplot())
        return;
    CHECK_THROWS_WITH(report::gnuplot::draw("set terminal no_such_terminal\n"),
                      ContainsSubstring("unknown or ambiguous terminal"));
}

TEST_CASE("thinning keeps ends and stays within its tolerance")
{
    std::vector<Vec2> circle;
    for (int i = 0; i <= 1000; ++i)
        circle.push_back(direction(i / 1000.0));
    auto const few = report::thinned(circle, 1e-3);
    CHECK(few.size() < 20);
    CHECK(few.size() > 5);
    CHECK(few.front() == circle.front());
    CHECK(few.back() == circle.back());
    for (std::size_t i = 0; i + 1 < few.size(); ++i)
        CHECK(((few[i] + few[i + 1]) / 2).norm() > 1 - 1.01e-3);
    CHECK(report::thinned(std::vector<Vec2>{}, 1).empty());
    CHECK(report::thinned(std::vector<Vec2>{{1, 2}, {1, 2}, {1, 2}}, 1).size() == 2);
}

TEST_CASE("every plot template says what it draws, and ends with a whole line")
{
    CHECK(report::plot_templates.size() == 23);
    for (auto const& each : report::plot_templates) {
        INFO(each.name);
        CHECK(each.text.starts_with("# SPDX-License-Identifier: GPL-3.0-or-later\n# "));
        CHECK(each.text.ends_with("\n"));
    }
    CHECK_THROWS_AS(report::plot_script("no_such", report::PlotData("a")), std::logic_error);
}

TEST_CASE("plot data is written as gnuplot reads it")
{
    report::PlotColumns columns;
    columns.row(1, 0.25, 5e-6);
    columns.end_line();
    columns.named_row("a \"b\"\n", 2, std::numeric_limits<double>::quiet_NaN());
    report::PlotData data("it's\ta");
    data.set("whole", 3);
    data.set("small", 1e-7);
    data.set("columns", columns);
    CHECK(data.commands() ==
          "heading = 'it''s a'\nwhole = 3\nsmall = 1e-07\n"
          "$columns << EOD\n1 0.25 5.0e-06\n\n2 NaN \"a 'b' \"\nEOD\n");
}

}  // namespace hdconj::test::picture_cases
