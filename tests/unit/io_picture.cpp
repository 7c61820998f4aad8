// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/io/atomic_file.hpp"
#include "hdconj/io/result_files.hpp"
#include "hdconj/scene/fault.hpp"
#include "io/picture_gnuplot.hpp"
#include "io/picture_lines.hpp"
#include "support/catch.hpp"
#include "support/gnuplot.hpp"
#include "support/sample_solution.hpp"
#include "support/temporary_folder.hpp"

using namespace hdconj;
using test::content;
using test::EmptyPath;
using test::no_gnuplot;
using test::TemporaryFolder;

TEST_CASE("pictures are drawn as SVG and PNG")
{
    if (no_gnuplot()) {
        return;
    }
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
    if (no_gnuplot()) {
        return;
    }
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
    CHECK_THROWS_WITH(gnuplot::draw(""), ContainsSubstring("gnuplot-nox"));
}

TEST_CASE("what gnuplot complains about is passed on")
{
    if (no_gnuplot()) {
        return;
    }
    CHECK_THROWS_WITH(gnuplot::draw("set terminal no_such_terminal\n"),
                      ContainsSubstring("unknown or ambiguous terminal"));
}

TEST_CASE("thinning keeps ends and stays within its tolerance")
{
    std::vector<Vec2> circle;
    for (int i = 0; i <= 1000; ++i) {
        circle.push_back(direction(i / 1000.0));
    }
    auto const few = thinned(circle, 1e-3);
    CHECK(few.size() < 20);
    CHECK(few.size() > 5);
    CHECK(few.front() == circle.front());
    CHECK(few.back() == circle.back());
    for (std::size_t i = 0; i + 1 < few.size(); ++i) {
        CHECK(((few[i] + few[i + 1]) / 2).norm() > 1 - 1.01e-3);
    }
    CHECK(thinned({}, 1).empty());
    CHECK(thinned({{1, 2}, {1, 2}, {1, 2}}, 1).size() == 2);
}
