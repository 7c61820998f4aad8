// SPDX-License-Identifier: GPL-3.0-or-later
// Lists of a scene that stand in a CSV file.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "hdconj/error.hpp"
#include "hdconj/inspect.hpp"
#include "hdconj/inspect_files.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/units.hpp"
#include "support/catch.hpp"
#include "support/measured_ring.hpp"
#include "support/temporary_folder.hpp"

namespace hdconj::test::rows_file_cases {

namespace {

/// The built-in drive with one key that names a file.
scene::SceneReading examined(TemporaryFolder const& folder, std::string const& key, std::string const& content)
{
    write(folder / "list.csv", content);
    return examine_scene(builtin_scene().text, "scene", folder.path(), {key + "=\"list.csv\""});
}

constexpr int z_f = 200;

/// A file of places [um] of all teeth but @p without; odd teeth stand 2 um behind.
std::string places(std::string const& header, int without = 0)
{
    std::string text = header + "\n";
    for (int tooth = z_f; tooth > 0; --tooth)
        if (tooth != without)
            text += std::to_string(tooth) + (tooth % 2 == 0 ? ", 0.5\n" : ", -2\n");
    return text;
}

struct WrongFile
{
    char const* what;
    std::string content, reason, remedy;
};

}  // namespace

TEST_CASE("places of teeth are read from a file by their numbers", "[scene]")
{
    TemporaryFolder const folder;
    for (std::string const header : {"tooth,place [um]", "Tooth, place_um", "tooth;place (um)"}) {
        CAPTURE(header);
        bool const semicolons = header.find(';') != std::string::npos;
        std::string text = places(header);
        if (semicolons)
            std::ranges::replace(text, ',', ';');
        auto const reading = examined(folder, "errors.flexspline.pitch", text);
        REQUIRE(reading.faults.empty());
        std::vector<double> const& pitch = reading.scene.errors->flexspline->pitch;
        REQUIRE(pitch.size() == z_f);
        for (std::size_t i = 0; i < pitch.size(); ++i)
            CHECK(pitch[i] == Approx(i % 2 == 1 ? 0.5e-3 : -2e-3).epsilon(1e-14));  // tooth i + 1 of the file
    }
}

TEST_CASE("rows of numbers are read by the names of their columns, with units", "[scene]")
{
    TemporaryFolder const folder;
    auto const cam = examined(folder, "errors.wave_generator.cam_deviation",
                              "# measured\nexcess [um],angle [rad],temperature\n1,0,20\n-1,1,20\n2,2.5,21\n0,5,21\n");
    REQUIRE(cam.faults.empty());
    auto const& rows = cam.scene.errors->wave_generator->cam_deviation;
    REQUIRE(rows.size() == 4);
    CHECK(rows[2][0] == Approx(2.5).epsilon(1e-14));
    CHECK(rows[2][1] == Approx(0.002).epsilon(1e-14));
    auto const form = examined(folder, "errors.circular_spline.profile_form",
                               "height [mm],excess [um]\n-0.3,0\n0,1\n0.1,2\n0.2,-1\n");
    REQUIRE(form.faults.empty());
    CHECK(form.scene.errors->circular_spline->profile_form[3] == std::vector<double>{0.2, -1e-3});
}

TEST_CASE("a wrong file of a list is refused with its line and what to write", "[scene]")
{
    TemporaryFolder const folder;
    std::string const key = "errors.flexspline.pitch";
    for (WrongFile const& each : std::vector<WrongFile>{
             {"no unit", places("tooth,place"), "line 1", "tooth,place [um]"},
             {"unit of angles", places("tooth,place [deg]"), "unit is not known", "[um]"},
             {"no such column", places("tooth,pitch [um]"), "names no column place", "tooth,place [um]"},
             {"no header", "1,0.5\n2,0.5\n", "line 1", "tooth,place [um]"},
             {"a tooth less", places("tooth,place [um]", 17), "leaves out tooth 17", "each tooth"},
             {"a tooth twice", places("tooth,place [um]") + "3,1\n", "line 202 of", "each tooth once"},
             {"no number", "tooth,place [um]\n1,abc\n", "line 2 of", "decimal point"},
             {"no whole number", "tooth,place [um]\n1.5,1\n", "tooth is no whole number", "from 1"},
             {"too few teeth", "tooth,place [um]\n1,1\n2,1\n", "2 places for 200 teeth", "each tooth"},
             {"places of another drive", places("tooth,place [mm]"), "more than a tenth of the module", "0.025"},
             {"nothing", "", "has no rows", "tooth,place [um]"}}) {
        CAPTURE(each.what);
        auto const reading = examined(folder, key, each.content);
        REQUIRE(reading.faults.size() == 1);
        Fault const& fault = reading.faults.front();
        CHECK(fault.path == key);
        CHECK(fault.reason.find(each.reason) != std::string::npos);
        CHECK(fault.remedy.find(each.remedy) != std::string::npos);
        CAPTURE(fault.reason, fault.remedy);
    }
    auto const missing = examine_scene(builtin_scene().text, "scene", folder.path(), {key + "=\"other.csv\""});
    REQUIRE(missing.faults.size() == 1);
    CHECK(missing.faults.front().reason.find("cannot be read") != std::string::npos);
    auto const endless = examine_scene(builtin_scene().text, "scene", folder.path(), {key + "=\"/dev/zero\""});
    REQUIRE(endless.faults.size() == 1);
    CHECK(endless.faults.front().reason.find("no file of numbers") != std::string::npos);
}

TEST_CASE("the places of teeth that an inspection finds are those of the scene that reads them", "[scene][inspect]")
{
    TemporaryFolder const folder;
    designs::Draws draws(77);
    MeasuredRing ring;
    ring.points = 12;
    ring.turn = 1e-3;
    std::vector<double> made(z_f);
    for (double& place : made) {
        place = draws.between(-4e-3, 4e-3);  // at the pitch circle
        double const at_reference = place * ring.reference_radius() / ring.pitch_radius();
        double const thicker = draws.between(-1e-3, 1e-3);
        ring.left.push_back({at_reference - thicker, 0, 0, 0});
        ring.right.push_back({at_reference + thicker, 0, 0, 0});
    }
    write_pitch(inspected(ring, draws, Registration::turn), folder / "pitch.csv");
    auto const reading =
        examine_scene(builtin_scene().text, "scene", folder.path(), {"errors.flexspline.pitch=\"pitch.csv\""});
    REQUIRE(reading.faults.empty());
    std::vector<double> const& found = reading.scene.errors->flexspline->pitch;
    REQUIRE(found.size() == made.size());
    // the registration turns the ring so that the mean deviation is none
    double mean = 0;
    for (std::size_t i = 0; i < made.size(); ++i)
        mean += (found[i] - made[i]) / z_f;
    for (std::size_t i = 0; i < made.size(); ++i)
        CHECK(std::abs(found[i] - made[i] - mean) < 2e-6);
}

}  // namespace hdconj::test::rows_file_cases
