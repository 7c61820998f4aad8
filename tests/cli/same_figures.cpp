// SPDX-License-Identifier: GPL-3.0-or-later
// Text, JSON and HDF5 of every verb, figure by figure. Names, units and factors are written out here once more, so that
// an error of the tables in src/figures is found.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>
#include <sstream>

#include "hdconj_run.hpp"
#include "support/catch.hpp"
#include "support/read_hdf5.hpp"

using hdconj::test::TemporaryFolder;
using nlohmann::json;

namespace {

constexpr double degree = std::numbers::pi / 180;

/// Ends of keys, and the numbers of HDF5 in one of them. Longer ends come first.
std::vector<std::pair<std::string, double>> const units = {{"_Nm_per_deg", 1000 / degree},
                                                           {"_Nm_per_rad", 1000},
                                                           {"_N_per_mm", 1},
                                                           {"_arcmin", degree / 60},
                                                           {"_mm2", 1},
                                                           {"_deg", degree},
                                                           {"_MPa", 1},
                                                           {"_Nm", 1000},
                                                           {"_um", 1e-3},
                                                           {"_mm", 1},
                                                           {"_N", 1},
                                                           {"_s", 1}};

/// Names that differ, as docs/reference/json.md and docs/reference/hdf5.md have them.
std::map<std::string, std::string> const renamed = {{"time", "seconds"},
                                                    {"clearance_error", "flank_clearance_error"},
                                                    {"closest_z_from", "flank_z_from"},
                                                    {"closest_z_to", "flank_z_to"}};

/// One run of a verb for its text and one for its JSON and HDF5.
struct Results
{
    std::string text;
    json summary;
    TemporaryFolder folder;

    explicit Results(std::string const& command)
    {
        auto const told = hdconj::test::hdconj_run(command + " -o text.h5", folder.path());
        auto const listed = hdconj::test::hdconj_run(command + " -o a.h5 --json", folder.path());
        INFO(told.err << listed.err);
        REQUIRE(told.status == 0);
        REQUIRE(listed.status == 0);
        text = told.out;
        summary = json::parse(listed.out);
    }
    [[nodiscard]] hdconj::io::hdf5::File file() const { return hdconj::test::open_file(folder / "a.h5"); }
};

/// Backlash as a length at the pitch circle: HDF5 has them as angles only.
std::set<std::string> const backlash_as_lengths = {"backlash_um",
                                                   "backlash_error_um",
                                                   "backlash_of_least_side_clearance_um",
                                                   "backlash_of_least_side_clearance_error_um",
                                                   "backlash_of_clearing_um",
                                                   "backlash_of_clearing_error_um"};

/// Compares the numbers of @p object with row @p row of the columns in @p group.
/// @returns the keys without a column
std::set<std::string> compare_columns(hid_t file, std::string const& group, json const& object, std::size_t row)
{
    std::set<std::string> absent;
    for (auto const& [key, value] : object.items()) {
        if (!value.is_number() && !value.is_boolean())
            continue;
        std::string name = key;
        double factor = 1;
        for (auto const& [end, stored_per_shown] : units) {
            if (key.ends_with(end)) {
                name = key.substr(0, key.size() - end.size());
                factor = stored_per_shown;
                break;
            }
        }
        if (auto const other = renamed.find(name); other != renamed.end())
            name = other->second;
        std::string const path = group + "/" + name;
        INFO(path << " [" << row << "] and " << key);
        if (backlash_as_lengths.contains(key) || !hdconj::test::has_link(file, path.c_str())) {
            absent.insert(key);
            continue;
        }
        auto const stored = hdconj::test::read(file, path.c_str()).values;
        REQUIRE(row < stored.size());
        double const shown = value.is_boolean() ? value.get<bool>() : value.get<double>();
        CHECK(std::abs(shown * factor - stored[row]) <= 1e-14 * std::abs(stored[row]));
    }
    return absent;
}

/// The figures printed in a line, in order: numbers that stand alone, or in front of a comma, semicolon or bracket.
std::vector<std::string> numbers_of(std::string const& line)
{
    std::vector<std::string> found;
    std::istringstream words(line);
    for (std::string word; words >> word;) {
        while (!word.empty() && std::string(",;:)*").find(word.back()) != std::string::npos)
            word.pop_back();
        word.erase(0, word.find_first_not_of('('));
        char* end = nullptr;
        std::strtod(word.c_str(), &end);
        if (!word.empty() && *end == '\0' && word.find_first_of("0123456789") != std::string::npos)
            found.push_back(word);
    }
    return found;
}

/// Whether @p text is @p value to the digits that it has.
void check_printed(std::string const& text, double value)
{
    auto const exponent_at = text.find('e');
    std::string const mantissa = text.substr(0, std::min(exponent_at, text.find('?')));  // "?": not converged
    auto const point = mantissa.find('.');
    double const decimals = point == std::string::npos ? 0 : static_cast<double>(mantissa.size() - point - 1);
    double const exponent = exponent_at == std::string::npos ? 0 : std::stod(text.substr(exponent_at + 1));
    double const half = std::pow(10, exponent - decimals) / 2;
    INFO(text << " for " << value);
    CHECK(std::abs(std::stod(text) - value) <= half * (1 + 1e-9) + 1e-14 * std::abs(value));
}

/// The first line of @p text that begins with @p begin, without it.
std::string line_after(std::string const& text, std::string const& begin)
{
    auto const at = ("\n" + text).find("\n" + begin);
    INFO(begin << "\n" << text);
    REQUIRE(at != std::string::npos);
    return text.substr(at + begin.size(), text.find('\n', at + begin.size()) - at - begin.size());
}

/// Numbers of the line that begins with @p begin against @p values, in order.
void check_line(std::string const& text, std::string const& begin, std::vector<double> const& values)
{
    auto const printed = numbers_of(line_after(text, begin));
    INFO(begin);
    REQUIRE(printed.size() >= values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        check_printed(printed[i], values[i]);
}

/// The lines of a table from the one that begins with @p begin on, cut at the ends of the columns @p ends; blanks gone.
std::vector<std::vector<std::string>> rows_of(std::string const& text, std::string const& begin, std::size_t count,
                                              std::vector<std::size_t> const& ends)
{
    std::size_t at = ("\n" + text).find("\n" + begin);
    REQUIRE(at != std::string::npos);
    std::vector<std::vector<std::string>> rows;
    for (std::size_t i = 0; i < count; ++i) {
        auto const next = text.find('\n', at);
        std::string const line = text.substr(at, next - at);
        auto& row = rows.emplace_back();
        std::size_t from = 0;
        for (std::size_t const end : ends) {
            std::string cell = from < line.size() ? line.substr(from, end - from) : "";
            for (char const unwanted : {' ', '*', '%'})
                std::erase(cell, unwanted);
            row.push_back(cell.starts_with("+-") ? cell.substr(2) : cell);
            from = end;
        }
        at = next + 1;
    }
    return rows;
}

/// Cells against numbers; a cell without a digit is none.
void check_cells(std::vector<std::string> const& cells, std::vector<double> const& values)
{
    REQUIRE(cells.size() == values.size());
    for (std::size_t i = 0; i < cells.size(); ++i) {
        INFO("column " << i);
        if (cells[i].find_first_of("0123456789") != std::string::npos)
            check_printed(cells[i], values[i]);
    }
}

double number(json const& object, char const* key)
{
    return object.at(key).get<double>();
}

std::string item(std::string const& group, std::size_t i)
{
    std::string digits = std::to_string(i);
    return group + "/case_" + std::string(3 - digits.size(), '0') + digits;
}

void check_summary(Results const& results)
{
    auto const& geometry = results.summary.at("geometry");
    auto const& error = results.summary.at("error");
    auto const um = [](json const& object, char const* key) { return number(object, key) * 1000; };
    auto const& text = results.text;
    check_line(text, "  error, written points", {um(error, "error_point_mm")});
    check_line(text, "  error, chords", {um(error, "error_chord_mm")});
    check_line(text, "  closed length, relative", {number(error, "error_arc_length_relative")});
    auto const file = results.file();
    hdconj::io::hdf5::Group const stored(H5Gopen2(file, "summary", H5P_DEFAULT), "open");
    std::size_t compared = 0;
    for (char const* part : {"geometry", "clearance", "error"}) {
        if (!results.summary.contains(part))
            continue;
        for (auto const& [key, value] : results.summary.at(part).items()) {
            INFO(key);
            hdconj::io::hdf5::Attribute const attribute(H5Aopen(stored, key.c_str(), H5P_DEFAULT), "open");
            double in_file = 0;
            hdconj::io::hdf5::checked(H5Aread(attribute, H5T_NATIVE_DOUBLE, &in_file), "read");
            CHECK(in_file == value.get<double>());
            ++compared;
        }
    }
    CHECK(compared >= geometry.size() + error.size());
}

}  // namespace

TEST_CASE("solve: text, JSON and HDF5 have the same figures and errors", "[figures]")
{
    Results const results("solve --verbose");
    check_summary(results);
    auto const& text = results.text;
    auto const& geometry = results.summary.at("geometry");
    auto const& error = results.summary.at("error");
    auto const& clearance = results.summary.at("clearance");
    check_line(text, "  neutral radius r_m", {number(geometry, "r_m_mm")});
    auto const r_0 = numbers_of(line_after(text, "  base radius r_0"));
    check_printed(r_0.front(), number(geometry, "r_0_mm"));
    check_printed(r_0.at(r_0.size() - 2), number(geometry, "r_0_less_r_m_um"));
    check_printed(r_0.back(), number(error, "error_r_0_mm") * 1000);
    check_line(text, "  radial deformation w0", {number(geometry, "w0_mm")});
    check_line(text, "  pitch line", {number(geometry, "pitch_line_mm")});
    check_line(text, "  flexspline inner radius", {number(geometry, "flexspline_inner_radius_mm")});
    check_line(text, "  tip radius", {number(geometry, "tip_radius_mm")});
    check_line(text, "  depth of tooth space",
               {number(geometry, "space_depth_mm"), number(error, "error_space_depth_mm") * 1000});
    check_line(text, "  land between spaces",
               {number(geometry, "land_width_mm"), number(error, "error_land_width_mm") * 1000});
    check_line(text, "  smallest clearance",
               {number(clearance, "smallest_clearance_mm") * 1000, number(clearance, "clearance_error_mm") * 1000,
                number(clearance, "clearance_x_mm"), number(clearance, "clearance_y_mm"),
                number(clearance, "clearance_phi_deg")});
    check_line(text, "  rounding moves the ends of zones by at most",
               {number(error, "error_zone_phi_deg"), number(error, "error_zone_t")});
}

TEST_CASE("contact: text, JSON and HDF5 have the same figures and errors", "[contact][figures]")
{
    Results const results(
        "contact '" HDCONJ_SOURCE_DIR
        "/data/scenes/type-50-coned.toml' --set slices.count=3 --set contact.flank_points=40 --surface tilted "
        "--kind radial --tilt 0 --tilt 0.2");
    check_summary(results);
    auto const file = results.file();
    auto const& cases = results.summary.at("contact").at("cases");
    REQUIRE(cases.size() == 2);
    auto const rows = rows_of(results.text, "  tilted    radial ", 4, {25, 36, 46, 56, 67, 77, 87, 94, 104, 120});
    for (std::size_t i = 0; i < cases.size(); ++i) {
        auto const& each = cases[i];
        auto const& state = each.at("state");
        std::set<std::string> const lengths = {"backlash_um", "backlash_error_um"},
                                    of_clearing = {"backlash_of_least_side_clearance_um",
                                                   "backlash_of_least_side_clearance_error_um",
                                                   "backlash_of_clearing_um", "backlash_of_clearing_error_um"};
        CHECK(compare_columns(file, "/contact", each, i) == of_clearing);
        CHECK(compare_columns(file, "/contact", state, i) == lengths);
        for (std::size_t k = 0; k < each.at("slices").size(); ++k)
            CHECK(compare_columns(file, item("/contact", i), each.at("slices")[k], k).empty());
        auto const& closest = each.at("closest_flank");
        auto const& values = rows[2 * i];
        check_cells({values.begin() + 1, values.begin() + 9},
                    {number(closest, "clearance_um"), number(each, "least_side_clearance_um"),
                     number(each, "backlash_of_least_side_clearance_arcmin"), number(each, "backlash_offset_um"),
                     number(state, "backlash_arcmin"), number(state, "backlash_um"), number(state, "teeth"),
                     number(state, "contact_fraction") * 100});
        check_cells({values[9]}, {number(state, "contact_fraction_error") * 100});
        auto const& errors = rows[2 * i + 1];
        check_cells({errors.begin() + 1, errors.begin() + 4},
                    {number(each, "clearance_error_um"), number(each, "least_side_clearance_error_um"),
                     number(each, "backlash_of_least_side_clearance_error_arcmin")});
        check_cells({errors.begin() + 5, errors.begin() + 7},
                    {number(state, "backlash_error_arcmin"), number(state, "backlash_error_um")});
    }
}

TEST_CASE("load: text, JSON and HDF5 have the same figures and errors", "[load][figures]")
{
    Results const results("load --set slices.count=3 --points 6");
    check_summary(results);
    auto const file = results.file();
    auto const& load = results.summary.at("load");
    auto const& each = load.at("cases").at(0);
    auto const& rated = each.at("rated");
    auto const& error = each.at("rated_error");
    REQUIRE(error.is_object());
    // errors of the play stand with the estimates, as does whether the largest pressure is at an end
    CHECK(compare_columns(file, "/load", each, 0) ==
          std::set<std::string>{"backlash_error_arcmin", "backlash_offset_error_um", "pressure_at_edge"});
    CHECK(compare_columns(file, "/load/error",
                          {{"backlash_arcmin", each.at("backlash_error_arcmin")},
                           {"backlash_offset_um", each.at("backlash_offset_error_um")}},
                          0)
              .empty());
    CHECK(compare_columns(file, "/load", rated, 0).empty());
    CHECK(compare_columns(file, "/load/error", error, 0).empty());
    auto const& curve = each.at("curve");
    for (std::size_t i = 0; i < curve.size(); ++i) {
        CHECK(compare_columns(file, "/load/case_000/curve", curve[i], i).empty());
        if (curve[i].at("error").is_object()) {
            CHECK(compare_columns(file, "/load/case_000/curve/error", curve[i].at("error"), i).empty());
        }
    }
    auto const& catalogue = each.at("catalogue");
    auto const rows = rows_of(results.text, "  " + each.at("surface").get<std::string>() + " ", 2,
                              {25, 33, 43, 52, 61, 70, 80, 87, 96, 105, 115, 123, 132});
    check_cells(
        {rows[0].begin() + 1, rows[0].end()},
        {number(each, "backlash_offset_um"), number(each, "backlash_arcmin"), number(catalogue, "K1_Nm_per_rad"),
         number(catalogue, "K2_Nm_per_rad"), number(catalogue, "K3_Nm_per_rad"), number(rated, "twist_arcmin"),
         number(rated, "teeth"), number(rated, "contact_fraction") * 100, number(rated, "fraction_within_gap") * 100,
         number(rated, "largest_line_load_N_per_mm"), number(rated, "largest_force_N"),
         number(rated, "largest_stress_MPa")});
    check_cells({rows[1].begin() + 2, rows[1].end()},
                {number(each, "backlash_error_arcmin"), number(catalogue, "K1_error_Nm_per_rad"),
                 number(catalogue, "K2_error_Nm_per_rad"), number(catalogue, "K3_error_Nm_per_rad"),
                 number(error, "twist_arcmin"), number(error, "teeth"), number(error, "contact_fraction") * 100,
                 number(error, "fraction_within_gap") * 100, number(error, "largest_line_load_N_per_mm"),
                 number(error, "largest_force_N"), number(error, "largest_stress_MPa")});
    // The figures of which the text says with "?" that they have not converged.
    auto const marked = each.at("not_converged").get<std::set<std::string>>();
    CHECK(hdconj::test::has_link(file, "/load/case_000/not_converged") == !marked.empty());
    CHECK((results.text.find("?: more than a third") == std::string::npos) == marked.empty());
    CHECK(marked.contains("backlash") ==
          (3 * number(each, "backlash_error_arcmin") > std::abs(number(each, "backlash_arcmin"))));
    auto const& cup = load.at("cup");
    auto const& cup_error = cup.at("error");
    auto const& text = results.text;
    for (auto const& [label, key] : {std::pair{"  coning, major axis", "coning_major_deg"},
                                     {"  coning, minor axis", "coning_minor_deg"},
                                     {"  wave generator force", "wave_generator_force_N"},
                                     {"  largest stress", "largest_stress_MPa"}}) {
        check_line(text, label, {number(cup, key), number(cup_error, key)});
    }
    check_line(text, "  edges of the teeth", {number(load, "edge_radius_um")});
    auto const lobe = line_after(text, "  " + each.at("surface").get<std::string>() + ": lobe at the major axis");
    auto const printed = numbers_of(lobe);
    std::vector<char const*> const keys = {"lobe_force_N", "lobe_force_across_N", "lobe_z_mm",
                                           "wave_generator_torque_Nm"};
    REQUIRE(printed.size() >= 2 * keys.size());
    for (std::size_t i = 0; i < keys.size(); ++i) {
        check_printed(printed[2 * i], number(rated, keys[i]));
        check_printed(printed[2 * i + 1], number(error, keys[i]));
    }
}

TEST_CASE("wedm: text and JSON have the same figures and errors", "[wedm][figures]")
{
    TemporaryFolder const folder;
    auto const told = hdconj::test::hdconj_run("wedm --tilt 0.2 -o text", folder.path());
    auto const listed = hdconj::test::hdconj_run("wedm --tilt 0.2 -o a --json", folder.path());
    REQUIRE(told.status == 0);
    REQUIRE(listed.status == 0);
    auto const& text = told.out;
    json const all = json::parse(listed.out);
    json const& checks = all.at("checks");
    for (auto const& [label, key] : {std::pair{"  wire diameter", "wire_diameter_mm"},
                                     {"  spark gap", "spark_gap_mm"},
                                     {"  workpiece", "thickness_mm"},
                                     {"  guides", "guide_distance_mm"}}) {
        check_line(text, label, {number(all, key)});
    }
    auto const& lower = all.at("lower_face");
    auto const& upper = all.at("upper_face");
    check_line(text, "  lower, radii", {number(lower, "inner_radius_mm"), number(lower, "outer_radius_mm")});
    check_line(text, "  upper, radii", {number(upper, "inner_radius_mm"), number(upper, "outer_radius_mm")});
    check_line(text, "  face shift", {number(all, "face_shift_mm"), number(all, "least_face_shift_mm")});
    check_line(text, "  guide offset", {number(all, "guide_offset_mm"), number(all, "largest_wire_tilt_deg")});
    check_line(text, "  error of the contours", {number(all, "contour_error_um")});
    check_line(text, "  travel", {number(all, "travel_mm"), number(all, "uv_travel_mm")});
    check_line(text, "  cut off the faces", {number(checks, "face_error_um"), number(checks, "tolerance_um")});
    for (auto const& file : all.at("files"))
        check_line(
            text, "  " + file.at("name").get<std::string>() + " ",
            {number(file, "blocks"), number(file, "bytes"), number(file, "drift_um"), number(file, "cut_error_um")});
    check_line(text, "  chord at the guides", {number(checks, "guide_chord_um")});
    check_line(text, "  cut between the faces", {number(checks, "middle_error_um")});
    check_line(text, "  constant taper",
               {number(checks, "constant_taper_error_um"), number(checks, "constant_taper_known_to_um")});
    for (auto const& pass : all.at("set_ups").at(0).at("passes")) {
        std::string const begin = "     " + std::to_string(pass.at("pass").get<int>()) + " ";
        check_line(text, begin,
                   {number(pass, "offset_mm"), number(pass, "stock_mm"), number(pass, "blocks"),
                    number(pass, "length_mm"), number(pass, "shortest_block_mm"), number(pass, "residual_um")});
    }
}

TEST_CASE("accuracy: text, JSON and HDF5 have the same figures", "[accuracy][figures]")
{
    TemporaryFolder const folder;
    auto const run = [&](std::string const& arguments) {
        auto done = hdconj::test::hdconj_run("accuracy " + arguments, folder.path());
        INFO(done.err);
        REQUIRE(done.status == 0);
        return done.out;
    };
    run("--quick --sample 0 --study tolerance --quiet -o a");
    auto const text = run("--from a/records.h5");
    json const series = json::parse(run("--from a/records.h5 --json")).at("convergence_series").at(0);
    auto const file = hdconj::test::open_file(folder / "a/records.h5");
    auto const& levels = series.at("levels");
    auto table = text.substr(text.find("estimate  speed n.v"));
    for (std::size_t i = 0; i < levels.size(); ++i) {
        auto const& level = levels[i];
        table = table.substr(table.find('\n') + 1);
        auto const printed = numbers_of(table.substr(0, table.find('\n')));
        REQUIRE(printed.size() >= 6);
        check_printed(printed[0], number(level, "value"));
        check_printed(printed[1], number(level, "error"));
        check_printed(printed[2], number(level, "estimate"));
        check_printed(printed[3], number(level, "normal_speed_mm_per_rad"));
        check_printed(printed[4], number(level, "missed"));
        check_printed(printed[5], number(level, "extra"));
        auto const stored = [&](char const* name) {
            return hdconj::test::read(file, (std::string("/records/") + name).c_str()).values.at(i);
        };
        CHECK(stored("value") == number(level, "value"));
        CHECK(std::max(stored("error"), stored("hausdorff")) == number(level, "error"));
        CHECK(stored("estimate") == number(level, "estimate"));
        CHECK(stored("normal_speed") == number(level, "normal_speed_mm_per_rad"));
        CHECK(stored("seconds") == number(level, "median_s"));
    }
}
