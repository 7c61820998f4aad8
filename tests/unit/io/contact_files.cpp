// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "hdconj/contact_files.hpp"
#include "hdconj/file/atomic_file.hpp"
#include "hdconj/units.hpp"
#include "io/hdf5/hdf5_handle.hpp"
#include "support/catch.hpp"
#include "support/former_names.hpp"
#include "support/json_keys.hpp"
#include "support/read_hdf5.hpp"
#include "support/sample_contact_study.hpp"
#include "support/temporary_folder.hpp"

namespace hdconj::test::contact_files_cases {

using test::collect_keys;
using test::has_link;
using test::open_file;
using test::read;
using test::TemporaryFolder;

namespace {

}  // namespace

TEST_CASE("contact numbers come back from HDF5 bit for bit, one row per case")
{
    TemporaryFolder const folder;
    auto const study = sample::contact_study();
    write_hdf5(study, folder / "a.h5");
    auto const file = open_file(folder / "a.h5");
    std::size_t const cases = study.cases.size();
    struct Column
    {
        char const* name;
        double (*value)(ContactCase const&);
    };
    for (auto const& [name, value] : std::vector<Column>{
             {"tilt", [](auto const& c) { return c.tilt; }},
             {"backlash_offset", [](auto const& c) { return c.backlash_offset; }},
             {"least_side_clearance", [](auto const& c) { return c.least_side_clearance; }},
             {"side_clearance_increased", [](auto const& c) { return c.side_clearance_increased ? 1.0 : 0.0; }},
             {"tip_radius", [](auto const& c) { return c.tip; }},
             {"least_tip_radius", [](auto const& c) { return c.least_tip_radius; }},
             {"least_root_clearance", [](auto const& c) { return c.least_root_clearance; }},
             {"backlash_of_least_side_clearance", [](auto const& c) { return c.backlash_of_least_side_clearance; }},
             {"flank_area", [](auto const& c) { return c.state.flank_area; }},
             {"ruled_deviation", [](auto const& c) { return c.ruled_deviation; }},
             {"seconds", [](auto const& c) { return c.seconds; }},
             {"flank_clearance", [](auto const& c) { return c.closest_flank().clearance; }},
             {"flank_phi", [](auto const& c) { return c.closest_flank().phi; }},
             {"flank_z", [](auto const& c) { return c.closest_slice().z; }},
             {"wave_generator", [](auto const& c) { return c.state.wave_generator; }},
             {"turn_to_contact", [](auto const& c) { return c.state.turn_to_contact; }},
             {"reverse_turn_to_contact", [](auto const& c) { return c.state.reverse_turn_to_contact; }},
             {"backlash", [](auto const& c) { return c.state.turn_to_contact + c.state.reverse_turn_to_contact; }},
             {"contact_area", [](auto const& c) { return c.state.contact_area; }},
             {"contact_area_error", [](auto const& c) { return c.state.contact_area_error; }},
             {"flank_area_error", [](auto const& c) { return c.state.flank_area_error; }},
             {"contact_fraction", [](auto const& c) { return c.state.contact_fraction; }},
             {"contact_fraction_error", [](auto const& c) { return c.state.contact_fraction_error; }},
             {"smallest_gap", [](auto const& c) { return c.state.smallest_gap; }},
             {"smallest_z", [](auto const& c) { return c.state.smallest_z; }},
             {"smallest_gap_error", [](auto const& c) { return c.state.smallest_gap_error; }},
             {"turn_to_contact_error", [](auto const& c) { return c.state.turn_to_contact_error; }},
             {"reverse_turn_to_contact_error", [](auto const& c) { return c.state.reverse_turn_to_contact_error; }},
             {"backlash_error",
              [](auto const& c) { return c.state.turn_to_contact_error + c.state.reverse_turn_to_contact_error; }},
             {"teeth_least", [](auto const& c) { return static_cast<double>(c.state.teeth_least); }},
             {"teeth_most", [](auto const& c) { return static_cast<double>(c.state.teeth_most); }},
             {"flank_clearance_error", [](auto const& c) { return c.clearance_error; }},
             {"root_clearance_error", [](auto const& c) { return c.root_clearance_error; }},
             {"least_side_clearance_error", [](auto const& c) { return c.least_side_clearance_error; }},
             {"least_tip_radius_error", [](auto const& c) { return c.least_tip_radius_error; }},
             {"least_root_clearance_error", [](auto const& c) { return c.least_root_clearance_error; }},
             {"backlash_of_least_side_clearance_error",
              [](auto const& c) { return c.backlash_of_least_side_clearance_error; }},
             {"ruled_deviation_error", [](auto const& c) { return c.ruled_deviation_error; }},
             {"teeth", [](auto const& c) { return static_cast<double>(c.state.teeth); }},
             {"smallest_space", [](auto const& c) { return static_cast<double>(c.state.smallest_space); }}}) {
        INFO(name);
        auto const column = read(file, ("/contact/" + std::string(name)).c_str());
        REQUIRE(column.shape == std::vector<hsize_t>{cases});
        for (std::size_t i = 0; i < cases; ++i)
            REQUIRE(column.values[i] == value(study.cases[i]));
    }
    CHECK(read(file, "/contact/flank_where").shape == std::vector<hsize_t>{cases, 2});
    auto const where = read(file, "/contact/case_002/flank_where");
    REQUIRE(where.shape == std::vector<hsize_t>{9, 2});
    CHECK(where.values[7] == study.cases[2].slices[3].flank.where.y());
    CHECK(read(file, "/contact/case_002/flank_clearance_error").values[3] == study.cases[2].slices[3].flank_error);
    CHECK(read(file, "/contact/case_002/root_clearance_error").values[3] == study.cases[2].slices[3].root_error);
    CHECK(read(file, "/contact/case_002/amplitude").values[8] == study.cases[2].slices[8].amplitude);
    CHECK(read(file, "/contact/case_002/root_clearance").values[4] == study.cases[2].slices[4].root.clearance);
    CHECK(read(file, "/contact/case_003/revolution/share").values.size() == 5);
    CHECK_FALSE(has_link(file, "/contact/case_002/revolution"));
}

TEST_CASE("the gap map lies in HDF5 as it is indexed")
{
    TemporaryFolder const folder;
    auto const study = sample::contact_study(3);
    write_hdf5(study, folder / "a.h5");
    auto const file = open_file(folder / "a.h5");
    auto const gap = read(file, "/contact/map/gap");
    REQUIRE(gap.shape == std::vector<hsize_t>{202, 2, 3, 41});
    CHECK(gap.values == study.map.gap);
    CHECK(gap.values[((5 * 2 + GapMap::right) * 3 + 2) * 41 + 7] == study.map.at(5, GapMap::right, 2, 7));
    CHECK(read(file, "/contact/map/angle").values == study.map.angle);
    CHECK(read(file, "/contact/best/interval").shape == std::vector<hsize_t>{3, 2});
    CHECK(read(file, "/contact/best/value_error").values == std::vector<double>{0.004, 1e-5, 0.004});
    CHECK(read(file, "/contact/best/on_bound").values == std::vector<double>{0, 0, 1});
}

TEST_CASE("only a contact result has the contact group and a mesh and only what was computed is in it")
{
    TemporaryFolder const folder;
    auto study = sample::contact_study();
    write_hdf5(study.solution, folder / "solve.h5");
    CHECK_FALSE(has_link(open_file(folder / "solve.h5"), "/contact"));
    CHECK_FALSE(has_link(open_file(folder / "solve.h5"), "/circular_spline/surface"));
    study.best.clear();
    study.map = {};
    write_hdf5(study, folder / "a.h5");
    auto const file = open_file(folder / "a.h5");
    CHECK_FALSE(has_link(file, "/contact/best"));
    CHECK_FALSE(has_link(file, "/contact/map"));
    CHECK(read(file, "/circular_spline/outline").values ==
          read(open_file(folder / "solve.h5"), "/circular_spline/outline").values);
    write_hdf5(ContactStudy{}, folder / "empty.h5");
    CHECK(read(open_file(folder / "empty.h5"), "/contact/tilt").shape == std::vector<hsize_t>{0});
}

TEST_CASE("a contact study that contradicts itself is not written")
{
    TemporaryFolder const folder;
    auto study = sample::contact_study(3);
    study.map.gap.pop_back();
    CHECK_THROWS_AS(write_hdf5(study, folder / "a.h5"), std::logic_error);
    study = sample::contact_study(3);
    study.cases[1].slices.clear();
    CHECK_THROWS_AS(write_hdf5(study, folder / "a.h5"), std::logic_error);
    CHECK(folder.names().empty());
    CHECK_THROWS_AS(write_hdf5(sample::contact_study(3), folder / "none/a.h5"), FileError);
}

TEST_CASE("the contact text has a row for each case and the places of interference")
{
    auto study = sample::contact_study();
    study.cases[1].state.reverse_turn_to_contact = -1.5 * study.cases[1].state.turn_to_contact;
    auto const text = summary_text(study, {{"hdf5", "out/contact.h5", 0.0021}});
    for (auto const* part :
         {"type-50", "gap is 1 um or less", "z -3.5 ... 3.5 mm", "tilted    radial", "tilted    draft", "per-slice -",
          "where the teeth come closest", "flanks     -43.65   -0.2100   25.3100   -3.500    12.892   interfere",
          "touch", "press on both flanks", "best tilt", "0.7700 deg", "contact area 22 %", "least side clearance 9 um",
          "an end of this interval", "over a revolution, 5 angles", "ruled: up to 3.4 +- 0.01 um off",
          "in the result file: tilted, radial 0.6 deg", "out/contact.h5"}) {
        CHECK_THAT(text, ContainsSubstring(part));
    }
    std::size_t rows = 0;
    for (std::size_t at = text.find("\n  tilted    "); at != std::string::npos;
         at = text.find("\n  tilted    ", at + 1)) {
        ++rows;
    }
    CHECK(rows == 44);
    CHECK_FALSE(summary_text(ContactStudy{}).empty());
}

TEST_CASE("a row of the contact table is in the units of its heading")
{
    ContactStudy study;
    study.pitch_radius = 25;
    ContactCase each;
    each.surface = ToothSurface::tilted;
    each.kind = TiltKind::draft;
    each.tilt = 0.25 * sample::degree;
    each.slices.resize(1);
    each.slices[0].flank.clearance = -0.07812;
    each.least_side_clearance = 0.08123;
    each.backlash_of_least_side_clearance = 12.34 * arcmin;
    each.backlash_offset = 0.09;
    each.state.turn_to_contact = 10 * arcmin;
    each.state.reverse_turn_to_contact = 1 * arcmin;
    each.state.teeth = 17;
    each.state.contact_fraction = 0.12343;
    each.state.contact_fraction_error = 0.0003;
    each.clearance_error = 2e-5;
    each.least_side_clearance_error = 0.3e-3;
    each.backlash_of_least_side_clearance_error = 0.4 * arcmin;
    each.state.turn_to_contact_error = 0.06 * arcmin;
    each.state.reverse_turn_to_contact_error = 0.04 * arcmin;
    each.state.teeth_least = 16;
    each.state.teeth_most = 18;
    study.cases = {each};
    // 11 arcmin at 25 mm are 79.99 um
    CHECK_THAT(summary_text(study),
               ContainsSubstring(
                   "tilted    draft    0.25     -78.12     81.23     12.34     90.00      11.00"
                   "     79.99     17     12.34 +- 0.03\n"
                   "                             +- 0.02    +- 0.3    +- 0.4               +- 0.1    +- 0.7  16-18\n"));
    study.cases[0].state.turn_to_contact = study.cases[0].least_side_clearance = -1e-12;
    study.cases[0].state.reverse_turn_to_contact = 0;
    CHECK_THAT(summary_text(study), ContainsSubstring("     0.00     12.34     90.00       0.00      0.00     17"));
    study.cases[0].state.turn_to_contact = 11 * arcmin;
    study.cases[0].side_clearance_increased = true;
    study.cases[0].least_tip_radius = study.cases[0].tip = 25.1;
    study.cases[0].least_tip_radius_error = 1e-6;
    study.solution.geometry.circular_spline_inner_radius = 25;
    CHECK_THAT(
        summary_text(study),
        ContainsSubstring("12.34     90.00*     11.00") &&
            ContainsSubstring("more side clearance than the scene gives") &&
            ContainsSubstring("draft 0.25 deg: needs a tip circle of 25.1000 +- 1e-06 mm instead of 25.0000 mm"));
}

TEST_CASE("JSON of a contact study has the figures of the solution and of each case")
{
    auto const study = sample::contact_study();
    auto const json = nlohmann::json::parse(summary_json(study, {{"xdmf", "a.xdmf", 0.5}}));
    CHECK(json.at("format") == "hdconj-summary");
    CHECK(json.at("geometry").at("r_m_mm") == study.solution.geometry.r_m);
    CHECK(json.at("files").at("xdmf").at("path") == "a.xdmf");
    auto const& contact = json.at("contact");
    CHECK(contact.at("contact_gap_um").get<double>() == Approx(1));
    CHECK(contact.at("written_case") == 3);
    REQUIRE(contact.at("cases").size() == study.cases.size());
    auto const& third = contact.at("cases").at(3);
    auto const& given = study.cases[3];
    CHECK(third.at("tilt_deg").get<double>() == Approx(0.6));
    CHECK(third.at("least_side_clearance_um").get<double>() == Approx(given.least_side_clearance * 1000));
    CHECK(third.at("closest_flank").at("clearance_um").get<double>() == Approx(given.closest_flank().clearance * 1000));
    CHECK(third.at("closest_flank").at("z_mm") == given.closest_slice().z);
    CHECK(third.at("state").at("contact_fraction") == given.state.contact_fraction);
    CHECK(third.at("state").at("backlash_arcmin").get<double>() == Approx(given.state.backlash() / arcmin));
    CHECK(third.at("state").at("backlash_um").get<double>() == Approx(given.state.backlash() * 25000));
    CHECK(third.at("least_side_clearance_error_um").get<double>() == Approx(given.least_side_clearance_error * 1000));
    CHECK(third.at("state").at("backlash_error_arcmin").get<double>() == Approx(given.state.backlash_error() / arcmin));
    CHECK(third.at("state").at("backlash_error_um").get<double>() == Approx(given.state.backlash_error() * 25000));
    CHECK(third.at("state").at("teeth_most") == given.state.teeth_most);
    CHECK(third.at("slices").size() == 9);
    CHECK(third.at("revolution").size() == 5);
    CHECK(contact.at("best").at(0).at("contact_fraction") == 0.22);
    CHECK(contact.at("best").at(1).at("least_side_clearance_um").get<double>() == Approx(9));
    CHECK(contact.at("best").at(0).at("contact_fraction_error") == 0.004);
    CHECK(contact.at("best").at(1).at("least_side_clearance_error_um").get<double>() == Approx(0.01));
    CHECK(contact.at("best").at(2).at("on_bound") == true);
    CHECK_FALSE(nlohmann::json::parse(summary_json(study.solution)).contains("contact"));
}

TEST_CASE("JSON of a contact study has null where there is no number")
{
    auto study = sample::contact_study(3);
    study.cases[0].state.contact_fraction_error = std::numeric_limits<double>::quiet_NaN();
    study.cases[0].least_root_clearance = std::numeric_limits<double>::infinity();
    study.cases[1].slices.clear();
    auto const cases = nlohmann::json::parse(summary_json(study)).at("contact").at("cases");
    CHECK(cases.at(0).at("state").at("contact_fraction_error").is_null());
    CHECK(cases.at(0).at("least_root_clearance_um").is_null());
    CHECK(cases.at(1).at("closest_flank").is_null());
    CHECK(nlohmann::json::parse(summary_json(ContactStudy{})).at("contact").at("cases").empty());
}

TEST_CASE("docs/reference/json.md names every key of a contact study")
{
    auto const document = test::content(HDCONJ_SOURCE_DIR "/docs/reference/json.md");
    std::set<std::string> keys;
    collect_keys(nlohmann::json::parse(summary_json(sample::contact_study(), {{"hdf5", "a", 0}})), keys);
    CHECK(keys.size() > 100);
    auto const names = test::renamed("contact");
    for (auto const& key : keys)
        if (!test::is_former(key, names))
            CHECK_THAT(document, ContainsSubstring("`" + key + "`"));
}

}  // namespace hdconj::test::contact_files_cases
