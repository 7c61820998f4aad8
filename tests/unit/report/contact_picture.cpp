// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/contact_files.hpp"
#include "hdconj/error.hpp"
#include "hdconj/file/atomic_file.hpp"
#include "report/plots/colour_bands.hpp"
#include "report/plots/plots.hpp"
#include "support/catch.hpp"
#include "support/gnuplot.hpp"
#include "support/plot_data.hpp"
#include "support/sample_contact_study.hpp"
#include "support/temporary_folder.hpp"

namespace hdconj::test::contact_picture_cases {

using test::content;
using test::EmptyPath;
using test::no_gnuplot;
using test::six_digits;
using test::TemporaryFolder;

namespace {

struct Cell
{
    double left = 0, right = 0, low = 0, high = 0;
    int colour = 0;
    [[nodiscard]] double area() const { return (right - left) * (high - low); }
};

/// The rectangles of a data block.
std::vector<Cell> cells(std::string const& script, std::string const& name)
{
    std::vector<Cell> found;
    for (auto const& row : test::plot_rows(script, name)) {
        REQUIRE(row.size() == 5);
        Cell const cell{row[0], row[1], row[2], row[3], static_cast<int>(row[4])};
        REQUIRE(cell.left < cell.right);
        REQUIRE(cell.low < cell.high);
        found.push_back(cell);
    }
    return found;
}

/// All of it, or what has the colour of a band.
double area(std::vector<Cell> const& of, int band = -1)
{
    double sum = 0;
    for (auto const& cell : of)
        sum += band < 0 || cell.colour == report::GapBands::colour(static_cast<std::size_t>(band)) ? cell.area() : 0;
    return sum;
}

/// The names, with the kind that each has.
std::vector<std::string> kinds_and_names(std::vector<WrittenFile> const& written)
{
    std::vector<std::string> result;
    for (auto const& each : written) {
        result.push_back(each.kind + ": " + each.file.filename().string());
        CHECK(each.seconds > 0);
    }
    return result;
}

using Names = std::vector<std::string>;

constexpr int interference = 0, contact = 1, next_to_contact = 2;

}  // namespace

TEST_CASE("pictures of a contact study are drawn as SVG and PNG under names of their own")
{
    if (no_gnuplot())
        return;
    TemporaryFolder const folder;
    auto study = sample::contact_study();
    study.solution.scene.drive.name = "it's <a> \"drive\" & {co} \\n";
    auto const written = write_contact_pictures(study, folder / "a.b.svg");
    CHECK(kinds_and_names(written) ==
          Names{"picture_tilt: a.b-tilt.svg", "picture_map: a.b-map.svg", "picture_flank: a.b-flank.svg"});
    for (auto const& [kind, file, seconds] : written) {
        auto const svg = content(file);
        INFO(file);
        CHECK(svg.rfind("<?xml", 0) == 0);
        CHECK_THAT(svg, ContainsSubstring("</svg>") && ContainsSubstring("it's &lt;a"));
        // Neither data blocks nor files are named.
        CHECK_THAT(svg, !ContainsSubstring("$") && !ContainsSubstring(folder.path().string()));
    }
    CHECK_THAT(content(written[0].file), ContainsSubstring("least side clearance: tilted, draft") &&
                                             ContainsSubstring("0.77°, 9 µm") &&
                                             ContainsSubstring("0.21° (on the bound)"));
    CHECK_THAT(content(written[1].file), ContainsSubstring("most contact") && ContainsSubstring("left flanks") &&
                                             ContainsSubstring("radial 0.6 deg"));
    CHECK_THAT(content(written[2].file), ContainsSubstring("along the flank") && ContainsSubstring("slices computed"));
    for (auto const& each : write_contact_pictures(study, folder / "c.PNG"))
        CHECK(content(each.file).rfind("\x89PNG", 0) == 0);
    CHECK(folder.names().size() == 6);
}

TEST_CASE("only what a contact study holds is drawn")
{
    if (no_gnuplot())
        return;
    TemporaryFolder const folder;
    auto study = sample::contact_study(1);
    study.best.clear();
    study.cases.erase(study.cases.begin() + 1, study.cases.end() - 2);  // one tilt, and two without
    study.written_case = 0;
    CHECK_FALSE(report::has_tilt_curve(study));
    CHECK(kinds_and_names(write_contact_pictures(study, folder / "a.svg")) ==
          Names{"picture_map: a-map.svg", "picture_flank: a-flank.svg"});
    study = sample::contact_study(3);
    study.map = {};
    CHECK(kinds_and_names(write_contact_pictures(study, folder / "b.svg")) == Names{"picture_tilt: b-tilt.svg"});
    CHECK(write_contact_pictures(ContactStudy{}, folder / "c.svg").empty());
    CHECK(folder.names().size() == 3);
}

TEST_CASE("a case without tilt begins the curves of all kinds of its surface")
{
    auto study = sample::contact_study(1);
    auto const curve = [&](int number) { return test::plot_rows(report::tilt_script(study), "curves", number).size(); };
    CHECK(curve(0) == 11);
    study.cases[0].kind.reset();                  // tilted radial 0 deg
    study.cases.erase(study.cases.begin() + 11);  // tilted draft 0 deg
    CHECK(curve(0) == 11);
    CHECK(curve(1) == 11);
    CHECK(curve(3) == 2);  // per-slice, across the whole picture
    CHECK(curve(4) == 0);
}

TEST_CASE("contact pictures that cannot be drawn are refused before the work")
{
    TemporaryFolder const folder;
    CHECK_THROWS_AS(check_contact_pictures(folder / "a.pdf"), InputError);
    EmptyPath const nothing;
    CHECK_THROWS_WITH(check_contact_pictures(folder / "a.svg"), ContainsSubstring("gnuplot-nox"));
    CHECK_THROWS_AS(write_contact_pictures(sample::contact_study(3), folder / "a.svg"), FileError);
    CHECK(folder.names().empty());
}

TEST_CASE("bands of gaps end at multiples of the contact gap and get lighter with the gap")
{
    report::GapBands const bands(2e-3, 1e-6);
    CHECK(bands.band_of(-1) == interference);
    CHECK(bands.band_of(-2e-6) == interference);
    CHECK(bands.band_of(-0.5e-6) == contact);
    CHECK(bands.band_of(2e-3) == contact);
    CHECK(bands.band_of(2.0001e-3) == next_to_contact);
    CHECK(bands.band_of(0.2) == report::GapBands::count() - 2);
    CHECK(bands.band_of(0.2001) == report::GapBands::count() - 1);
    CHECK(bands.band_of(1e9) == report::GapBands::count() - 1);
    double last = 0;
    for (std::size_t band = next_to_contact; band < report::GapBands::count(); ++band) {
        int const colour = report::GapBands::colour(band);
        double const luma = 0.2126 * (colour >> 16) + 0.7152 * (colour >> 8 & 0xff) + 0.0722 * (colour & 0xff);
        CHECK(luma > last + 15);
        last = luma;
    }
}

TEST_CASE("the map's cells cover all angles and the width once, in the colour of the smallest gap")
{
    auto study = sample::contact_study(5);
    auto script = report::map_script(study);
    for (auto const* flank : {"right", "left"})
        CHECK(area(cells(script, flank)) == Approx(360 * 7.0).epsilon(six_digits));
    // One deep place in one slice of one space: a cell of its own.
    study.map.gap.assign(study.map.gap.size(), 0.03);
    study.map.gap[study.map.index(50, GapMap::left, 2, 17)] = -0.002;
    script = report::map_script(study);
    CHECK(area(cells(script, "right"), interference) == 0);
    auto const left = cells(script, "left");
    CHECK(area(left, interference) == Approx(360.0 / 202 * 7 / 4).epsilon(1e-4));
    for (auto const& cell : left) {
        if (cell.colour == report::GapBands::colour(interference)) {
            double const degrees = study.map.angle[50] / sample::degree;
            CHECK((cell.left < degrees && degrees < cell.right));
            CHECK((cell.low < 0 && 0 < cell.high));
        }
    }
    // One slice stands for the whole width.
    CHECK(area(cells(report::map_script(sample::contact_study(1)), "right")) == Approx(360 * 7.0).epsilon(six_digits));
}

TEST_CASE("the flank's bands end where the gap passes their ends, exactly where it is linear")
{
    auto study = sample::contact_study(3);
    study.solution.circular_spline.outline.assign(3, study.solution.circular_spline.outline.front());
    study.map.gap.assign(study.map.gap.size(), 1.0);
    auto const set = [&](auto gap) {
        for (std::size_t k = 0; k < 3; ++k) {
            for (std::size_t p = 0; p < study.map.station.size(); ++p)
                study.map.gap[study.map.index(7, GapMap::right, k, p)] = gap(study.map.z[k], study.map.station[p]);
        }
        return cells(report::flank_script(study), "cells");
    };
    // -2 um at the land corner, 8 um at the end: 20 % interference but for the rounding, 10 % contact, 10 % up to 2 um.
    auto found = set([](double, double station) { return -2e-3 + 10e-3 * station; });
    double const whole = area(found);
    CHECK(area(found, interference) / whole == Approx(0.2 - 1e-4).epsilon(1e-4));
    CHECK(area(found, contact) / whole == Approx(0.1 + 1e-4).epsilon(1e-4));
    CHECK(area(found, next_to_contact) / whole == Approx(0.1).epsilon(1e-4));
    // Down as well as up, several bands at one step.
    found = set([](double, double station) { return station < 0.5 ? 1.0 : 0.0; });
    CHECK(area(found) == Approx(whole).epsilon(six_digits));
    CHECK(area(found, contact) / whole == Approx(0.5).epsilon(0.06));
    // Across the slices: half of it in contact, to the height of a row.
    found = set([](double z, double) { return 1e-3 + 1e-3 * z; });
    CHECK(area(found, contact) / whole + area(found, interference) / whole == Approx(0.5).epsilon(0.01));
    // Widest where the flank is.
    double length = 0;
    auto const& spline = study.solution.circular_spline;
    for (int i = spline.landmarks[3]; i < spline.landmarks[4]; ++i) {
        auto const at = static_cast<std::size_t>(i);
        length += (spline.outline[0][at + 1] - spline.outline[0][at]).norm();
    }
    CHECK(whole == Approx(7 * length).epsilon(six_digits));
}

}  // namespace hdconj::test::contact_picture_cases
