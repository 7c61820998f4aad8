// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "hdconj/error.hpp"
#include "hdconj/file/atomic_file.hpp"
#include "hdconj/load_files.hpp"
#include "report/plots/colour_bands.hpp"
#include "report/plots/plots.hpp"
#include "support/catch.hpp"
#include "support/gnuplot.hpp"
#include "support/plot_data.hpp"
#include "support/rig_loop.hpp"
#include "support/temporary_folder.hpp"

namespace hdconj::test::load_picture_cases {

using sample::minute;
using test::content;
using test::EmptyPath;
using test::no_gnuplot;
using test::plot_rows;
using test::TemporaryFolder;

namespace {

using FileNames = std::vector<std::string>;

FileNames names_of(std::vector<WrittenFile> const& written)
{
    FileNames result;
    for (auto const& each : written)
        result.push_back(each.kind + ": " + each.file.filename().string());
    return result;
}

Measurement measurement()
{
    Measurement measured;
    sample::Rig rig;
    rig.offset = 5 * minute;
    measured.curve = sample::rig_loop(rig);
    measured.found = measured_stiffness(measured.curve);
    return measured;
}

}  // namespace

TEST_CASE("pictures of a load study are drawn as SVG and PNG under names of their own", "[load][picture]")
{
    if (no_gnuplot())
        return;
    TemporaryFolder const folder;
    auto study = sample::load_study();
    study.solution.scene.drive.name = "it's <a> \"drive\" & {co} \\n";
    auto const measured = measurement();
    auto const written = write_load_pictures(study, folder / "a.b.svg", &measured);
    CHECK(names_of(written) == FileNames{"picture_curve: a.b-curve.svg", "picture_stiffness: a.b-stiffness.svg",
                                         "picture_residual: a.b-residual.svg", "picture_pressure: a.b-pressure.svg",
                                         "picture_flank: a.b-flank.svg", "picture_cup: a.b-cup.svg",
                                         "picture_stress: a.b-stress.svg"});
    for (auto const& each : written) {
        auto const svg = content(each.file);
        INFO(each.file);
        CHECK(svg.rfind("<?xml", 0) == 0);
        CHECK_THAT(svg, ContainsSubstring("</svg>") && ContainsSubstring("it's &lt;a"));
        CHECK_THAT(svg, !ContainsSubstring("$") && !ContainsSubstring(folder.path().string()));
    }
    CHECK_THAT(content(written[0].file), ContainsSubstring("backlash 6.2′") &&
                                             ContainsSubstring("measured, 4 cycles:  backlash 6.20 ± 0.00′") &&
                                             ContainsSubstring("98.7 and 182.8 N m/°"));
    CHECK_THAT(content(written[1].file),
               ContainsSubstring("stiffness [N m/°]") && ContainsSubstring("K1 5.6,  K2 10.5,  K3 12.0 ·10³ N m/rad"));
    CHECK_THAT(content(written[2].file), ContainsSubstring("two straight lines") && ContainsSubstring("simulation"));
    CHECK_THAT(content(written[3].file),
               ContainsSubstring("no force") && ContainsSubstring("6.11 N/mm") && ContainsSubstring("repeats 2 times"));
    CHECK_THAT(content(written[4].file),
               ContainsSubstring("which carries most") && ContainsSubstring("line load [N/mm]"));
    CHECK_THAT(content(written[5].file),
               ContainsSubstring("minor axis, 90°") && ContainsSubstring("displaced by 2 times"));
    CHECK_THAT(content(written[6].file),
               ContainsSubstring("largest over all angles") && ContainsSubstring("z = -4.65 mm"));
    for (auto const& each : write_load_pictures(study, folder / "c.PNG", nullptr))
        CHECK(content(each.file).rfind("\x89PNG", 0) == 0);
    CHECK(folder.names().size() == 13);
}

TEST_CASE("forces of single balls are drawn around the whole ring", "[load][picture]")
{
    if (no_gnuplot())
        return;
    TemporaryFolder const folder;
    auto study = sample::load_study();
    study.balls = 6;
    study.sectors = 2;
    study.cases[study.written_case].bearing = {{0.0}, {0.0}, {10.0}, {0.0, 1.0, 2.0}, {313, 0, 12.5}};
    auto const written = write_load_pictures(study, folder / "a.svg");
    CHECK(names_of(written).back() == "picture_balls: a-balls.svg");
    CHECK_THAT(content(written.back().file),
               ContainsSubstring("forces of the 6 balls on the outer ring; 2 carry nothing (grey)") &&
                   ContainsSubstring("force of a ball [N]"));
    auto const script = report::load_ball_script(study);
    std::vector<std::vector<double>> const carrying{{0, 313}, {180, 313}, {114.592, 12.5}, {-65.4084, 12.5}};
    auto const found = plot_rows(script, "carrying");
    REQUIRE(found.size() == carrying.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        CHECK(found[i][0] == Approx(carrying[i][0]).epsilon(six_digits));
        CHECK(found[i][1] == carrying[i][1]);
    }
    CHECK(plot_rows(script, "idle").size() == 2);
}

TEST_CASE("only what a load study holds is drawn", "[load][picture]")
{
    if (no_gnuplot())
        return;
    TemporaryFolder const folder;
    auto study = sample::load_study(1);
    for (auto& each : study.cases) {
        each.curve = {each.curve[each.rated]};
        each.rated = 0;
        each.stages = {};
    }
    study.shape.stress.clear();
    CHECK_FALSE(report::has_curve(study));
    CHECK(names_of(write_load_pictures(study, folder / "a.svg")) ==
          FileNames{"picture_pressure: a-pressure.svg", "picture_flank: a-flank.svg", "picture_cup: a-cup.svg"});
    auto const measured = measurement();
    CHECK(names_of(write_load_pictures(study, folder / "b.svg", &measured)).front() == "picture_curve: b-curve.svg");
    // No load at all, one angle, one tooth: still a picture.
    for (auto& pressure : study.cases[study.written_case].map.pressure)
        pressure = 0;
    for (auto& force : study.cases[study.written_case].map.force)
        force = 0;
    std::fill(study.shape.u_r.begin(), study.shape.u_r.end(), 0.0);
    std::fill(study.shape.u_z.begin(), study.shape.u_z.end(), 0.0);
    study.shape.stress.assign(study.shape.u_r.size(), 0.0);
    CHECK(write_load_pictures(study, folder / "c.svg").size() == 3);
    CHECK(write_load_pictures(LoadStudy{}, folder / "d.svg").empty());
}

TEST_CASE("the flank that carries most is drawn with the strips of its contacts", "[load][picture]")
{
    auto study = sample::load_study(3);
    LoadCase& shown = study.cases[study.written_case];
    LoadMap& map = shown.map;
    std::ranges::fill(map.force, 0);
    std::size_t const space = 7;
    map.force[map.index(space, GapMap::left, 1)] = 12;
    map.force[map.index(space, GapMap::left, 0)] = 3;
    map.force[map.index(space + 1, GapMap::right, 1)] = 14;  // less than both of the other flank
    study.edge_radius = 0.01;
    // the middle slice inside the flank, the first at an end of the width; the normal is half radial
    Vec2 const at(0, shown.tip + 0.1), normal(std::sqrt(0.75), 0.5);
    shown.contacts = {{7, GapMap::left, 1, at, normal, 0, 12, 0.008},
                      {7, GapMap::left, 0, at, normal, 0, 3, 0.004},
                      {8, GapMap::right, 1, at, normal, 0, 14, 0.008}};
    REQUIRE(report::has_loaded_flank(study));
    auto const script = report::load_flank_script(study);
    auto const strips = plot_rows(script, "strips");
    REQUIRE(strips.size() == 2);
    double const height = 0.125 * study.solution.scene.drive.circular_spline_teeth - at.y();
    CHECK(strips[0][0] == Approx(height - std::sqrt(0.75) * 0.008).epsilon(1e-4));
    CHECK(strips[0][1] == Approx(height + std::sqrt(0.75) * 0.008).epsilon(1e-4));
    double const slice = strips[0][3] - strips[0][2];
    auto const sure = plot_rows(script, "sure"), unsure = plot_rows(script, "unsure");
    REQUIRE(sure.size() == 1);
    REQUIRE(unsure.size() == 1);
    CHECK(sure[0][1] == Approx(2 * 12 / slice / (std::numbers::pi * 0.008)).epsilon(1e-4));
    CHECK(unsure[0][0] == Approx(map.z.front()).epsilon(1e-4));
    shown.contacts.clear();
    CHECK_FALSE(report::has_loaded_flank(study));
}

TEST_CASE("a rig that follows its two lines has no residual, and one beside the simulation its distance",
          "[load][picture]")
{
    auto study = sample::load_study(3);
    auto const measured = measurement();
    auto const script = report::load_residual_script(study, measured);
    auto const lines = plot_rows(script, "lines"), curve = plot_rows(script, "curve");
    REQUIRE(lines.size() > 20);
    REQUIRE(curve.size() > 20);
    // the rig's own noise
    double worst = 0;
    for (auto const& row : lines)
        worst = std::max(worst, std::abs(row[1]));
    CHECK(worst < 0.1);
    // rig and sample are the same two stages but for the play
    auto other = measured;
    for (std::size_t i = 0; i < other.curve.twist.size(); ++i)
        other.curve.twist[i] += 2 * minute;
    auto const shifted = plot_rows(report::load_residual_script(study, other), "curve");
    REQUIRE(shifted.size() == curve.size());
    for (std::size_t i = 0; i < curve.size(); i += 10)
        CHECK(shifted[i][1] - curve[i][1] == Approx(2).epsilon(1e-3));
}

TEST_CASE("load pictures that cannot be drawn are refused before the work", "[load][picture]")
{
    TemporaryFolder const folder;
    CHECK_THROWS_AS(check_load_pictures(folder / "a.pdf"), InputError);
    EmptyPath const nothing;
    CHECK_THROWS_WITH(check_load_pictures(folder / "a.svg"), ContainsSubstring("gnuplot-nox"));
    CHECK_THROWS_AS(write_load_pictures(sample::load_study(3), folder / "a.svg"), FileError);
    CHECK(folder.names().empty());
}

TEST_CASE("the drawn curve is level over the play and its two lines are those of the stages", "[load][picture]")
{
    auto const study = sample::load_study(3);
    auto const measured = measurement();
    auto const script = report::load_curve_script(study, &measured);
    for (std::size_t i = 0; i < study.cases.size(); ++i) {
        auto const& each = study.cases[i];
        double level = 0;
        auto const curve = plot_rows(script, "curves", static_cast<int>(i));
        REQUIRE(curve.size() >= each.curve.size());
        for (std::size_t k = 0; k + 1 < curve.size(); ++k) {
            bool const crosses = curve[k][0] * curve[k + 1][0] < 0;
            if (crosses) {
                CHECK(curve[k][1] == 0);
                CHECK(curve[k + 1][1] == 0);
                level = std::max(level, std::abs(curve[k + 1][0] - curve[k][0]));
            }
        }
        CHECK(level == Approx(each.backlash / minute).epsilon(six_digits));
        auto const lines = plot_rows(script, "stages", static_cast<int>(i));
        REQUIRE(lines.size() == 4);
        constexpr double per_degree = 60;  // arcmin
        CHECK((lines[1][1] - lines[0][1]) / (lines[1][0] - lines[0][0]) * per_degree ==
              Approx(each.stages.first * 1e-3 * sample::degree).epsilon(six_digits));
        CHECK((lines[3][1] - lines[2][1]) / (lines[3][0] - lines[2][0]) * per_degree ==
              Approx(each.stages.second * 1e-3 * sample::degree).epsilon(six_digits));
    }
    // Without torque the drive may also be said to lie in the middle of its play, which is no point to go to.
    auto middle = study;
    for (auto& state : middle.cases[0].curve)
        state.twist = state.torque == 0 ? 0 : state.twist;
    auto const drawn = plot_rows(report::load_curve_script(middle, nullptr), "curves");
    REQUIRE(drawn.size() >= middle.cases[0].curve.size());
    for (auto const& point : drawn)
        CHECK(std::abs(point[0]) >= middle.cases[0].backlash / 2 / minute * (1 - six_digits));
    // The measured play lies about the same middle as the computed one.
    auto const points = plot_rows(script, "measured");
    double low = 0, high = 0;
    for (auto const& point : points) {
        low = std::min(low, point[0]);
        high = std::max(high, point[0]);
    }
    CHECK(low == Approx(-high).epsilon(six_digits));
    CHECK(plot_rows(report::load_curve_script(study, nullptr), "measured").empty());
}

TEST_CASE("the line load's cells cover the sector and the width once", "[load][picture]")
{
    for (int const slices : {1, 5}) {
        auto const study = sample::load_study(slices);
        auto const& map = study.cases[study.written_case].map;
        auto const script = report::load_pressure_script(study);
        auto const cells = plot_rows(script, "cells");
        double area = 0, coloured = 0;
        for (auto const& cell : cells) {
            REQUIRE(cell.size() == 5);
            double const here = (cell[1] - cell[0]) * (cell[3] - cell[2]);
            area += here;
            coloured += static_cast<int>(cell[4]) != report::ColourScale(0).colour(0) ? here : 0;
        }
        CHECK(area == Approx(180 * 7.0).epsilon(1e-4));
        // In colour is what carries: slices at the ends stand for half a step.
        double carries = 0;
        for (std::size_t s = 0; s < map.angle.size(); ++s) {
            for (std::size_t k = 0; k < map.z.size(); ++k) {
                double const width = slices == 1 ? 7 : 7.0 / 4 * (k == 0 || k + 1 == map.z.size() ? 0.5 : 1);
                carries += map.line_load[map.index(s, GapMap::right, k)] > 0 ? 180.0 / 101 * width : 0;
            }
        }
        CHECK(carries > 0);
        CHECK(coloured == Approx(carries).epsilon(1e-4));
        double drawn = 0, carried = 0;
        for (auto const& row : plot_rows(script, "forces")) {
            drawn += row[1];
            CHECK(row[2] == 0);
        }
        for (double const force : map.force)
            carried += force;
        CHECK(drawn == Approx(carried).epsilon(1e-4));
    }
    // The other flanks, where they carry as well, hang down.
    auto study = sample::load_study(3);
    auto& map = study.cases[study.written_case].map;
    map.force[map.index(4, GapMap::left, 1)] = 2;
    CHECK(plot_rows(report::load_pressure_script(study), "forces")[4][2] == -2);
}

TEST_CASE("sections of the cup are drawn displaced by a round number of times", "[load][picture]")
{
    auto const study = sample::load_study(3);
    auto const& shape = study.shape;
    auto const script = report::load_cup_script(study);
    auto const made = plot_rows(script, "made"), bent = plot_rows(script, "major");
    REQUIRE(made.size() == shape.cells.size() * 5);
    REQUIRE(bent.size() == made.size());
    for (std::size_t i = 0; i < made.size(); ++i) {
        auto const& cell = shape.cells[i / 5];
        auto const p = static_cast<std::size_t>(cell[i % 5 % cell.size()]);
        CHECK(made[i][0] == Approx(shape.r[p]).epsilon(six_digits));
        CHECK(bent[i][0] - made[i][0] == Approx(2 * shape.u_r[p]).margin(1e-4));
        CHECK(bent[i][1] - made[i][1] == Approx(2 * shape.u_z[p]).margin(1e-4));
    }
    auto const minor = plot_rows(script, "minor");
    CHECK(minor.back()[0] < made.back()[0]);
}

TEST_CASE("colours darken evenly with the value and nothing is a colour of its own", "[load][picture]")
{
    report::ColourScale const scale(1186);
    CHECK(scale.count() == 12);
    CHECK(scale.band_of(0) == 0);
    CHECK(scale.band_of(-1) == 0);
    CHECK(scale.band_of(1e-9) == 1);
    CHECK(scale.band_of(99.9) == 1);
    CHECK(scale.band_of(100) == 2);
    CHECK(scale.band_of(1186) == 12);
    CHECK(scale.band_of(1e9) == 12);
    double last = 256;
    for (std::size_t band = 1; band <= scale.count(); ++band) {
        int const colour = scale.colour(band);
        double const luma = 0.2126 * (colour >> 16) + 0.7152 * (colour >> 8 & 0xff) + 0.0722 * (colour & 0xff);
        CHECK(luma < last - 5);
        last = luma;
    }
    CHECK(report::ColourScale(0).count() == 1);
    CHECK(report::ColourScale(1e-300).count() >= 1);
}

}  // namespace hdconj::test::load_picture_cases
