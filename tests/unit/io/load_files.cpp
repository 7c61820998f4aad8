// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "hdconj/file/atomic_file.hpp"
#include "hdconj/load_files.hpp"
#include "io/hdf5/hdf5_handle.hpp"
#include "support/catch.hpp"
#include "support/former_names.hpp"
#include "support/json_keys.hpp"
#include "support/read_hdf5.hpp"
#include "support/rig_loop.hpp"
#include "support/temporary_folder.hpp"

namespace hdconj::test::load_files_cases {

using sample::minute;
using sample::nm;
using test::collect_keys;
using test::content;
using test::has_link;
using test::open_file;
using test::read;
using test::TemporaryFolder;

namespace {

Measurement measurement(bool from_motor = false)
{
    Measurement measured;
    measured.curve = sample::rig_loop({});
    if (from_motor) {
        measured.curve.columns = "current [A], position [counts]";
        measured.curve.rig = {0.119, 2000, 100, 0.9};
    }
    measured.found = measured_stiffness(measured.curve);
    return measured;
}

}  // namespace

TEST_CASE("load numbers come back from HDF5 bit for bit", "[load]")
{
    TemporaryFolder const folder;
    auto study = sample::load_study();
    study.cases[2].tips = TipInterference{0.0003, 25.0303};
    write_hdf5(study, folder / "a.h5");
    auto const file = open_file(folder / "a.h5");
    std::size_t const cases = study.cases.size();
    struct Column
    {
        char const* name;
        double (*value)(LoadCase const&);
    };
    for (auto const& [name, value] : std::vector<Column>{
             {"tilt", [](auto const& c) { return c.tilt; }},
             {"backlash", [](auto const& c) { return c.backlash; }},
             {"backlash_offset", [](auto const& c) { return c.backlash_offset; }},
             {"first_stage", [](auto const& c) { return c.stages.first; }},
             {"first_stage_error", [](auto const& c) { return c.stages.first_error; }},
             {"second_stage", [](auto const& c) { return c.stages.second; }},
             {"second_stage_error", [](auto const& c) { return c.stages.second_error; }},
             {"knee", [](auto const& c) { return c.stages.knee; }},
             {"knee_error", [](auto const& c) { return c.stages.knee_error; }},
             {"knee_twist", [](auto const& c) { return c.stages.knee_twist; }},
             {"knee_twist_error", [](auto const& c) { return c.stages.knee_twist_error; }},
             {"stages_rms", [](auto const& c) { return c.stages.rms; }},
             {"side_clearance_increased", [](auto const& c) { return c.side_clearance_increased ? 1.0 : 0.0; }},
             {"cleared", [](auto const& c) { return c.cleared ? 1.0 : 0.0; }},
             {"tip_interference", [](auto const& c) { return c.tips ? c.tips->depth : 0.0; }},
             {"given_tip_interference", [](auto const& c) { return c.given_tips ? c.given_tips->depth : 0.0; }},
             {"stages_found", [](auto const& c) { return c.stages.found ? 1.0 : 0.0; }},
             {"seconds", [](auto const& c) { return c.seconds; }},
             {"twist", [](auto const& c) { return c.curve[c.rated].twist; }},
             {"largest_pressure", [](auto const& c) { return c.curve[c.rated].largest_pressure; }},
             {"teeth", [](auto const& c) { return static_cast<double>(c.curve[c.rated].teeth); }}}) {
        INFO(name);
        auto const column = read(file, ("/load/" + std::string(name)).c_str());
        REQUIRE(column.shape == std::vector<hsize_t>{cases});
        for (std::size_t i = 0; i < cases; ++i)
            CHECK(column.values[i] == value(study.cases[i]));
    }
    struct State
    {
        char const* name;
        double (*value)(LoadedState const&);
    };
    auto const& curve = study.cases[2].curve;
    for (auto const& [name, value] :
         std::vector<State>{{"torque", [](auto const& s) { return s.torque; }},
                            {"twist", [](auto const& s) { return s.twist; }},
                            {"stiffness", [](auto const& s) { return s.stiffness; }},
                            {"contact_area", [](auto const& s) { return s.contact_area; }},
                            {"contact_fraction", [](auto const& s) { return s.contact_fraction; }},
                            {"fraction_within_gap", [](auto const& s) { return s.fraction_within_gap; }},
                            {"carrying_fraction", [](auto const& s) { return s.carrying_fraction; }},
                            {"largest_pressure", [](auto const& s) { return s.largest_pressure; }},
                            {"pressure_z", [](auto const& s) { return s.pressure_z; }},
                            {"largest_force", [](auto const& s) { return s.largest_force; }},
                            {"largest_line_load", [](auto const& s) { return s.largest_line_load; }},
                            {"flank_pressure", [](auto const& s) { return s.flank_pressure; }},
                            {"edge_force", [](auto const& s) { return s.edge_force; }},
                            {"edge_fraction", [](auto const& s) { return s.edge_fraction; }},
                            {"flowing_fraction", [](auto const& s) { return s.flowing_fraction; }},
                            {"wave_generator_force", [](auto const& s) { return s.wave_generator_force; }},
                            {"wave_generator_torque", [](auto const& s) { return s.wave_generator_torque; }},
                            {"largest_stress", [](auto const& s) { return s.largest_stress; }},
                            {"stress_z", [](auto const& s) { return s.stress_z; }},
                            {"stress_r", [](auto const& s) { return s.stress_r; }},
                            {"stress_phi", [](auto const& s) { return s.stress_phi; }},
                            {"gap_mismatch", [](auto const& s) { return s.gap_mismatch; }},
                            {"complementarity", [](auto const& s) { return s.complementarity; }},
                            {"teeth", [](auto const& s) { return static_cast<double>(s.teeth); }},
                            {"pressure_space", [](auto const& s) { return static_cast<double>(s.pressure_space); }},
                            {"iterations", [](auto const& s) { return static_cast<double>(s.iterations); }},
                            {"steps", [](auto const& s) { return static_cast<double>(s.steps); }}}) {
        INFO(name);
        auto const column = read(file, ("/load/case_002/curve/" + std::string(name)).c_str());
        REQUIRE(column.shape == std::vector<hsize_t>{curve.size()});
        for (std::size_t i = 0; i < curve.size(); ++i)
            CHECK(column.values[i] == value(curve[i]));
    }
    auto const& map = study.cases[1].map;
    auto const pressure = read(file, "/load/case_001/map/pressure");
    REQUIRE(pressure.shape == std::vector<hsize_t>{101, 2, 9});
    CHECK(pressure.values == map.pressure);
    CHECK(pressure.values[(60 * 2 + 1) * 9 + 4] == map.pressure[map.index(60, GapMap::right, 4)]);
    CHECK(read(file, "/load/case_001/map/gap").values == map.gap);
    CHECK(read(file, "/load/case_001/map/flank_position").values == map.height);
    CHECK(read(file, "/load/cup/w_minor").values == study.cup.w_minor);
    CHECK(read(file, "/load/shape/u_t").values == study.shape.u_t);
    CHECK(read(file, "/load/shape/u_t").shape == std::vector<hsize_t>{36, study.shape.r.size()});
    CHECK(read(file, "/load/shape/stress").values == study.shape.stress);
    CHECK(read(file, "/load/shape/cells").shape == std::vector<hsize_t>{study.shape.cells.size(), 4});
    CHECK_FALSE(has_link(file, "/load/measured"));
}

TEST_CASE("a measured curve lies in HDF5 beside the simulation", "[load][measured]")
{
    TemporaryFolder const folder;
    auto const measured = measurement();
    write_hdf5(sample::load_study(3), folder / "a.h5", &measured);
    auto const file = open_file(folder / "a.h5");
    CHECK(read(file, "/load/measured/twist").values == measured.curve.twist);
    CHECK(read(file, "/load/measured/torque").values == measured.curve.torque);
    CHECK(read(file, "/load/measured/first_stage").values ==
          std::vector<double>{measured.found.first.value, measured.found.first.error});
    CHECK(read(file, "/load/measured/loop_width_count").values == std::vector<double>{4});
}

TEST_CASE("only what a load study holds is written and what contradicts itself is not", "[load]")
{
    TemporaryFolder const folder;
    auto study = sample::load_study(1);
    study.shape = {};
    study.cases[0].map = {};
    write_hdf5(study, folder / "a.h5");
    {
        auto const file = open_file(folder / "a.h5");
        CHECK_FALSE(has_link(file, "/load/shape"));
        CHECK_FALSE(has_link(file, "/load/case_000/map"));
        CHECK(has_link(file, "/load/case_001/map"));
    }
    study = sample::load_study(3);
    study.shape.stress.clear();
    write_hdf5(study, folder / "a.h5");
    CHECK_FALSE(has_link(open_file(folder / "a.h5"), "/load/shape/stress"));
    write_hdf5(LoadStudy{}, folder / "empty.h5");
    CHECK(read(open_file(folder / "empty.h5"), "/load/tilt").shape == std::vector<hsize_t>{0});
    auto const refused = [&](auto change) {
        auto broken = sample::load_study(3);
        change(broken);
        CHECK_THROWS_AS(write_hdf5(broken, folder / "b.h5"), std::logic_error);
    };
    refused([](LoadStudy& s) { s.cases[1].map.force.pop_back(); });
    refused([](LoadStudy& s) { s.cases[1].rated = 1000; });
    refused([](LoadStudy& s) { s.shape.u_z.pop_back(); });
    refused([](LoadStudy& s) { s.shape.cells[0].pop_back(), s.shape.cells[0].pop_back(); });
    refused([](LoadStudy& s) { s.cup.w_major.pop_back(); });
    CHECK(folder.names().size() == 2);
}

TEST_CASE("a row of the load table is in the units of its heading", "[load]")
{
    auto study = sample::load_study();
    auto const text = summary_text(study, {{"hdf5", "out/load.h5", 0.0021}});
    for (auto const* part :
         {"coning, major axis            1.2440 deg",
          "wave generator force            3992.0 N",
          "over 212 contact points",
          "at 28 N m",
          "  tilted    radial    0.2    9.00      6.20     5600    10500    12000     15.65     58      2.3       11   "
          " "
          "  24.0    31.5      494\n",
          "two straight lines instead: 98.7 and 183 N m/deg, knee at 12.0 N m",
          "  tilted    -           0    9.00*     7.80        -",
          "carry 40 % of all force, up to 8.00 N of a flank",
          "stress 494 MPa at z = -4.40 mm, r = 24.40 mm, 5.7 deg",
          "within: flank with a gap up to 1 um",
          "*: with the side clearance and tip circle of the scene",
          "clear the unloaded cup's teeth over a full turn:\n",
          "tip circle 25.107695 mm, enlarged by 0.00 um\n",
          "*: with the tip circle of the scene a slice would have no",
          "clearance over a full turn not checked:\n",
          "tip circle 25.030000 mm, enlarged by 82.70 um\n",
          "converged after at most 4 iterations: gaps agree with the loaded shape to 0.0002 um",
          "at most 3.0e-12",
          "in the result file: tilted, radial 0.2 deg",
          "out/load.h5"}) {
        INFO(part << "\n" << text);
        CHECK_THAT(text, ContainsSubstring(part));
    }
    CHECK_THAT(text, !ContainsSubstring("measured") && !ContainsSubstring("below zero"));
    study.cases[0].stages.found = false;
    study.cases[0].stages.second = study.cases[0].stages.first;
    study.cases[1].stages = {};
    study.cases[1].backlash = -0.4 * minute;
    study.cases[2].curve.clear();
    CHECK_THAT(summary_text(study), ContainsSubstring("5.10        -        -        -") &&
                                        ContainsSubstring("not computed") && ContainsSubstring("press on both flanks"));
    study.cases[0].given_tips = {0.00046, 25.02946};
    study.cases[1].tips = {0.0003, 25.1};
    CHECK_THAT(summary_text(study), ContainsSubstring("tips would interfere by 0.46 um along the radius; with "
                                                      "circular_spline.inner_radius = 25.0295 they pass") &&
                                        ContainsSubstring("below zero: tips interfere along the radius") &&
                                        !ContainsSubstring("below zero: the assembled teeth press"));
    study.cases[0].cleared = false;
    CHECK_THAT(summary_text(study), !ContainsSubstring("that clear the unloaded cup's teeth"));
    CHECK_FALSE(summary_text(LoadStudy{}).empty());
}

TEST_CASE("text and JSON lay the measurement beside the simulation", "[load][measured]")
{
    auto const study = sample::load_study();
    auto const measured = measurement(true);
    auto const text = summary_text(study, {}, &measured);
    INFO(text);
    CHECK_THAT(text, ContainsSubstring("measured: curve.csv (current [A], position [counts], 0.119 N m/A, efficiency "
                                       "0.9, 2000 counts per turn, ratio 100)"));
    CHECK_THAT(text, ContainsSubstring("3208 samples, 4 load cycles up to 28 N m"));
    CHECK_THAT(text, ContainsSubstring("simulated: tilted, radial 0.2 deg") &&
                         ContainsSubstring("first stage [N m/deg]              98.7 +- "));
    auto const json = nlohmann::json::parse(summary_json(study, {}, &measured)).at("load").at("measured");
    CHECK(json.at("first_stage").at("value_Nm_per_deg").get<double>() == Approx(98.7).epsilon(1e-6));
    CHECK(json.at("backlash").at("value_arcmin").get<double>() == Approx(6.2).epsilon(1e-6));
    CHECK(json.at("knee").at("value_Nm").get<double>() == Approx(12).epsilon(1e-4));
    CHECK(json.at("cycles") == 4);
    CHECK(json.at("first_stage").at("count") == 8);
    CHECK(json.at("torque_constant_Nm_per_A") == 0.119);
    auto straight = measured;
    straight.found.first = {};
    CHECK(nlohmann::json::parse(summary_json(study, {}, &straight))
              .at("load")
              .at("measured")
              .at("first_stage")
              .is_null());
}

TEST_CASE("a simulation is laid beside the loop of its own cup at the cup", "[load][measured]")
{
    auto const study = sample::load_study();
    constexpr double cup = 32.0 / 30;  // z_c/z_f
    sample::Rig rig;
    rig.per_branch = 200;
    auto const of_spline = sample::rig_loop(rig);
    Measurement at_cup{of_spline, {}};
    for (double& twist : at_cup.curve.twist)
        twist *= cup;
    for (double& torque : at_cup.curve.torque)
        torque /= cup;
    at_cup.curve.rig.angle_per_spline = cup;
    at_cup.found = measured_stiffness(at_cup.curve);
    auto const text = summary_text(study, {}, &at_cup);
    INFO(text);
    auto const says = [&text](char const* line) { return std::regex_search(text, std::regex(line)); };
    CHECK(at_cup.found.backlash.value == Approx(cup * study.cases[1].backlash).epsilon(1e-6));
    CHECK(at_cup.found.first.value == Approx(study.cases[1].stages.first / cup / cup).epsilon(1e-6));
    CHECK(says("backlash \\[arcmin\\] +6\\.613 \\+-[^\n]* 6\\.613\n"));
    CHECK(says("first stage \\[N m/deg\\] +86\\.75 \\+-[^\n]* 86\\.75\n"));
    CHECK(says("knee between them \\[N m\\] +11\\.25 \\+-[^\n]* 11\\.25\n"));
    CHECK_THAT(text, ContainsSubstring("its angles are 1.06667 times"));
    CHECK(nlohmann::json::parse(summary_json(study, {}, &at_cup))
              .at("load")
              .at("measured")
              .at("angle_per_spline")
              .get<double>() == cup);
}

TEST_CASE("JSON of a load study has the figures of the solution and of each case", "[load]")
{
    auto const study = sample::load_study();
    auto const json = nlohmann::json::parse(summary_json(study, {{"vtu", "a.vtu", 0.5}}));
    CHECK(json.at("format") == "hdconj-summary");
    CHECK(json.at("files").at("vtu").at("path") == "a.vtu");
    auto const& load = json.at("load");
    CHECK(load.at("rated_torque_Nm").get<double>() == Approx(28));
    CHECK(load.at("cup").at("coning_major_deg").get<double>() == Approx(1.244));
    CHECK(load.at("cup").at("slices").size() == 9);
    REQUIRE(load.at("cases").size() == 3);
    auto const& second = load.at("cases").at(1);
    CHECK(second.at("tilt_deg").get<double>() == Approx(0.2));
    CHECK(second.at("backlash_arcmin").get<double>() == Approx(6.2));
    CHECK(second.at("first_stage_Nm_per_deg").get<double>() == Approx(98.7));
    CHECK(second.at("first_stage_Nm_per_rad").get<double>() == Approx(98.7 * 180 / std::numbers::pi));
    CHECK(second.at("knee_Nm").get<double>() == Approx(12));
    CHECK(second.at("curve").size() == study.cases[1].curve.size());
    auto const& rated = second.at("rated");
    CHECK(rated.at("torque_Nm").get<double>() == Approx(28));
    CHECK(rated.at("twist_arcmin").get<double>() == Approx(study.cases[1].curve[study.cases[1].rated].twist / minute));
    CHECK(rated.at("stiffness_Nm_per_deg").get<double>() == Approx(182.8));
    CHECK(rated.at("largest_pressure_MPa").get<double>() == Approx(1210));
    CHECK(rated.at("largest_line_load_N_per_mm").get<double>() == Approx(24));
    CHECK(rated.at("flank_pressure_MPa").get<double>() == Approx(850));
    CHECK(rated.at("edge_fraction").get<double>() == Approx(0.4));
    CHECK_FALSE(load.contains("measured"));
}

TEST_CASE("every figure of a case whose error exceeds a third of it is marked", "[load][errors]")
{
    auto study = sample::load_study();
    LoadCase& each = study.cases[1];
    each.estimated = true;
    auto const marked = [&] {
        auto const object = nlohmann::json::parse(summary_json(study)).at("load").at("cases").at(1);
        return object.at("not_converged").get<std::vector<std::string>>();
    };
    CHECK(marked().empty());
    each.backlash_error = 0.34 * each.backlash;
    each.stages.second_error = 0.34 * each.stages.second;
    each.stages.knee_error = 0.34 * each.stages.knee;
    each.error.teeth = each.curve[each.rated].teeth;
    CHECK(marked() == std::vector<std::string>{"backlash", "second_stage", "knee", "teeth"});
    auto const text = summary_text(study);
    CHECK_THAT(text, ContainsSubstring("and 183 +- 62? N m/deg, knee at 12.0 +- 4.1? N m"));
    CHECK_THAT(text, ContainsSubstring("?: more than a third of the figure"));
    each.backlash_error = 0.33 * each.backlash;
    CHECK(marked().front() == "second_stage");
}

TEST_CASE("estimates and balls stand in text and JSON and HDF5 alike", "[load][errors]")
{
    auto study = sample::load_study();
    study.balls = 4;
    study.sectors = 2;
    study.edge_radius = 0.01;
    study.pitch_errors.flexspline = {0.001, -0.002};
    study.sharp_steps = true;
    study.cup.estimated = true;
    study.cup.coning_major_error = 0.0125 * sample::degree;
    study.cup.ball_force = 77;
    study.cup.balls = 4;
    LoadCase& each = study.cases[1];
    each.estimated = true;
    each.pressure_at_edge = true;
    each.backlash_error = 0.25 * minute;
    each.error.twist = 0.5 * minute;
    each.curve_error.assign(each.curve.size(), std::nullopt);
    each.curve_error[2].emplace().twist = 0.75 * minute;
    each.curve_error[2]->teeth = 3;
    each.error.largest_force = 1.5;
    each.error.largest_line_load = 3;
    each.error.flank_pressure = 75;
    each.error.edge_force = 2;
    each.error.teeth = 6;
    each.error.balls = 1;
    each.error.lobe_force = 11;
    each.curve[each.rated].lobe_force = 1640;
    each.curve[each.rated].ball_force = 313;
    each.curve[each.rated].balls = 3;
    each.bearing = {{0.0, 1.0}, {-3.0, 3.0}, {10, 20, 30, 40}, {0.0, 0.5}, {313, 12.5}};
    auto const text = summary_text(study);
    for (auto const* part :
         {"1.2440 deg   +- 0.013 deg; slope", "    +-                                 0.25", "       0.5      6",
          "         3     1.5", "lobe at the major axis 1640 +- 11 N", "balls up to 313", "3 +- 1 of 4 carry",
          "313.0 at 0.0, 12.5 at 28.6", "10 um   radius under load",
          "850 +- 75 MPa away from edges and ends, which carry 40 % of all force, up to 8.00 +- 2 N of a flank",
          "pressure not determined (about 850 MPa)", "sharp corners", "77.0 N"}) {
        INFO(part << "\n" << text);
        CHECK_THAT(text, ContainsSubstring(part));
    }
    CHECK_THAT(text, ContainsSubstring("no error estimate"));  // of the other cases
    auto const load = nlohmann::json::parse(summary_json(study)).at("load");
    auto const& second = load.at("cases").at(1);
    CHECK(load.at("cases").at(0).at("rated_error").is_null());
    CHECK(load.at("cases").at(0).at("backlash_error_arcmin").is_null());
    CHECK(load.at("edge_radius_um").get<double>() == Approx(10));
    CHECK(load.at("flexspline_pitch_errors_um").get<std::vector<double>>() == std::vector<double>{1, -2});
    CHECK_FALSE(load.contains("circular_spline_pitch_errors_um"));
    CHECK(load.at("cup").at("error").at("coning_major_deg").get<double>() == Approx(0.0125));
    CHECK(second.at("rated_error").at("twist_arcmin").get<double>() == Approx(0.5));
    CHECK(second.at("backlash_error_arcmin").get<double>() == Approx(0.25));
    CHECK(second.at("curve").at(2).at("error").at("twist_arcmin").get<double>() == Approx(0.75));
    CHECK(second.at("curve").at(2).at("error").at("teeth").get<int>() == 3);
    CHECK(second.at("curve").at(3).at("error").is_null());
    CHECK(load.at("cases").at(0).at("curve").at(2).at("error").is_null());
    CHECK(second.at("pressure_at_edge").get<bool>());
    CHECK(second.at("rated").at("ball_force_N").get<double>() == 313);
    CHECK(second.at("bearing").at("force_N").get<std::vector<double>>() == std::vector<double>{30, 70});
    CHECK(second.at("bearing").at("ball_force_N").get<std::vector<double>>() == std::vector<double>{313, 12.5});
    TemporaryFolder const folder;
    write_hdf5(study, folder / "a.h5");
    {
        auto const file = open_file(folder / "a.h5");
        CHECK(read(file, "/load/error/twist").values == std::vector<double>{0, 0.5 * minute, 0});
        CHECK(read(file, "/load/error/estimated").values == std::vector<double>{0, 1, 0});
        std::vector<double> twist(each.curve.size(), 0), estimated = twist;
        twist[2] = 0.75 * minute;
        estimated[2] = 1;
        CHECK(read(file, "/load/case_001/curve/error/twist").values == twist);
        CHECK(read(file, "/load/case_001/curve/error/estimated").values == estimated);
        CHECK(read(file, "/load/flexspline_pitch_errors").values == study.pitch_errors.flexspline);
        CHECK_FALSE(has_link(file, "/load/circular_spline_pitch_errors"));
        CHECK(read(file, "/load/case_001/bearing/force").shape == std::vector<hsize_t>{2, 2});
        CHECK(read(file, "/load/case_001/bearing/ball_force").values == each.bearing.ball_force);
        CHECK_FALSE(has_link(file, "/load/case_000/bearing"));
    }
    study.cases[1].bearing.force.pop_back();
    CHECK_THROWS_AS(write_hdf5(study, folder / "b.h5"), std::logic_error);
    study.balls = 0;
    CHECK_THAT(summary_text(study), ContainsSubstring("77.0 N/mm"));
}

TEST_CASE("JSON of a load study has null where there is no number", "[load]")
{
    auto study = sample::load_study(3);
    study.cases[0].curve[3].stiffness = std::numeric_limits<double>::infinity();
    study.cases[1].curve.clear();
    study.cup.coning_minor = std::numeric_limits<double>::quiet_NaN();
    auto const load = nlohmann::json::parse(summary_json(study)).at("load");
    CHECK(load.at("cases").at(0).at("curve").at(3).at("stiffness_Nm_per_deg").is_null());
    CHECK(load.at("cases").at(1).at("rated").is_null());
    CHECK(load.at("cup").at("coning_minor_deg").is_null());
    CHECK(nlohmann::json::parse(summary_json(LoadStudy{})).at("load").at("cases").empty());
}

TEST_CASE("docs name every key and every dataset of a load study", "[load]")
{
    auto const measured = measurement(true);
    auto const document = content(HDCONJ_SOURCE_DIR "/docs/reference/json.md");
    std::set<std::string> keys;
    LoadStudy study = sample::load_study();
    study.pitch_errors = {{0.001}, {0.002}};
    collect_keys(nlohmann::json::parse(summary_json(study, {{"vtu", "a", 0}}, &measured)), keys);
    CHECK(keys.size() > 120);
    auto const names = test::renamed("load");
    for (auto const& key : keys)
        if (!test::is_former(key, names))
            CHECK_THAT(document, ContainsSubstring("`" + key + "`"));
}

TEST_CASE("the cup as VTU is refused where it contradicts itself", "[load][vtu]")
{
    TemporaryFolder const folder;
    auto const refused = [&](auto change) {
        auto broken = sample::load_study(3);
        change(broken);
        CHECK_THROWS_AS(write_cup_vtu(broken, folder / "a.vtu"), std::logic_error);
    };
    refused([](LoadStudy& s) { s.shape = {}; });
    refused([](LoadStudy& s) { s.shape.cells.clear(); });
    refused([](LoadStudy& s) { s.shape.u_r.pop_back(); });
    refused([](LoadStudy& s) { s.shape.stress.pop_back(); });
    refused([](LoadStudy& s) { s.shape.cells[0][1] = 100000; });
    refused([](LoadStudy& s) { s.shape.cells[0][1] = -1; });
    refused([](LoadStudy& s) { s.shape.cells[0].push_back(0); });
    CHECK(folder.names().empty());
    CHECK_THROWS_AS(write_cup_vtu(sample::load_study(3), folder / "none/a.vtu"), FileError);
}

}  // namespace hdconj::test::load_files_cases
