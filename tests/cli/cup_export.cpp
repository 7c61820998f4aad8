// SPDX-License-Identifier: GPL-3.0-or-later
// hdconj export: a deck that CalculiX agrees with, and a cup that other readers read.
#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "hdconj_run.hpp"
#include "support/catch.hpp"
#include "support/not_tried.hpp"
#include "support/run/full_run.hpp"

namespace hdconj::test::cup_export_cases {

namespace {

std::string const scene = "'" HDCONJ_SOURCE_DIR "/data/scenes/type-50-elastic.toml' ";

/// u_r, u_t, u_z of nodes; the first column of a line is the node, the last three are they.
std::map<int, std::vector<double>> displacements(std::string const& file, char separator)
{
    std::map<int, std::vector<double>> found;
    std::ifstream in(file);
    std::string line;
    while (std::getline(in, line)) {
        std::replace(line.begin(), line.end(), separator, ' ');
        std::istringstream numbers(line);
        std::vector<double> all;
        double number = 0;
        while (numbers >> number)
            all.push_back(number);
        if (all.size() >= 4) {
            found[static_cast<int>(all.front())] = {all.end() - 3, all.end()};
        }
    }
    return found;
}

/// Exit status of the deck's own script; 0 where there is no Python to run it.
int compared(std::filesystem::path const& deck, std::string const& name)
{
    if (std::string(HDCONJ_PYTHON).empty())
        return 0;
    auto const done = run("'" HDCONJ_PYTHON "' compare.py " + name, deck);
    INFO(done.out << done.err);
    CHECK(done.out.find("apart") != std::string::npos);
    return done.status;
}

}  // namespace

TEST_CASE("CalculiX comes to the same displacements of the exported cup", "[export]")
{
    // bare, and with the teeth as a layer
    std::string const options =
        GENERATE(as<std::string>(), " --steps 24", " --steps 12 --set flexspline.cup.tooth_layer=0.53");
    CAPTURE(options);
    TemporaryFolder const folder;
    auto const written = hdconj_run("export " + scene + "--calculix deck" + options, folder.path());
    INFO(written.err);
    REQUIRE(written.status == 0);
    CHECK(written.out.find("coning of the whole toothed ring 1.2") != std::string::npos);
    auto const expected = displacements((folder.path() / "deck" / "expected.csv").string(), ',');
    REQUIRE(expected.size() > 60);
    if (run("command -v ccx").status != 0) {
        not_tried("ccx");
        return;
    }
    auto const computed = run("OMP_NUM_THREADS=1 ccx linear", folder.path() / "deck");
    REQUIRE(computed.status == 0);
    auto const found = displacements((folder.path() / "deck" / "linear.dat").string(), ' ');
    double largest = 0, apart = 0;
    for (auto const& [node, u] : expected) {
        REQUIRE(found.contains(node));
        for (std::size_t i = 0; i < 3; ++i) {
            largest = std::max(largest, std::abs(u[i]));
            apart = std::max(apart, std::abs(u[i] - found.at(node)[i]));
        }
    }
    CAPTURE(largest, apart);
    CHECK(largest > 0.3);
    CHECK(apart < 0.01 * largest);
    CHECK(compared(folder.path() / "deck", "linear") == 0);
}

namespace {

/// Slope of u_r over z of the nodes on the inner surface of the plane at @p phi_deg, from expected.csv and from what
/// CalculiX printed [mm/mm].
double slope(std::string const& expected, std::map<int, std::vector<double>> const& u, double phi_deg)
{
    std::ifstream in(expected);
    std::string line;
    std::vector<std::array<double, 3>> rows;  // r, z, u_r
    std::getline(in, line);
    while (std::getline(in, line)) {
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream numbers(line);
        int node = 0;
        double r = 0, z = 0, phi = 0;
        numbers >> node >> r >> z >> phi;
        if (std::abs(phi - phi_deg) < 0.01 && u.contains(node)) {
            rows.push_back({r, z, u.at(node).front()});
        }
    }
    double inner = 1e9, mean = 0, top = 0, bottom = 0, count = 0;
    for (auto const& row : rows)
        inner = std::min(inner, row[0]);
    std::erase_if(rows, [&](auto const& row) { return row[0] > inner + 0.01; });
    REQUIRE(rows.size() > 5);
    for (auto const& row : rows)
        mean += row[1], ++count;
    for (auto const& row : rows) {
        top += (row[1] - mean / count) * row[2];
        bottom += (row[1] - mean / count) * (row[1] - mean / count);
    }
    return top / bottom;
}

/// First two numbers of the line behind that which says so.
std::array<double, 2> surface_force(std::string const& file)
{
    std::ifstream in(file);
    std::string line;
    while (std::getline(in, line)) {
        if (line.find("total surface force") != std::string::npos) {
            std::array<double, 2> force{};
            in >> force[0] >> force[1];
            return force;
        }
    }
    return {};
}

/// Second column of a table of names and numbers.
std::vector<double> values(std::string const& file)
{
    std::ifstream in(file);
    std::string line;
    std::vector<double> found;
    std::getline(in, line);
    while (std::getline(in, line))
        found.push_back(std::stod(line.substr(line.find(',') + 1)));
    return found;
}

}  // namespace

TEST_CASE("CalculiX finds the same contact of cup and bearing", "[export]")
{
    struct Row
    {
        char const* what;
        std::string options;
    };
    // cup and bearing of a small drive; the deck once ended in a third less force
    std::string const small =
        " --steps 16 --set drive.module=0.175 --set flexspline.wall=0.5 --set flexspline.cup.length=11"
        " --set flexspline.cup.barrel_wall=0.28 --set flexspline.cup.bottom=0.4 --set flexspline.cup.corner_radius=1.5"
        " --set flexspline.cup.flange_radius=8.5 --set flexspline.cup.tooth_width=5 --set flexspline.cup.front_land=0.8"
        " --set flexspline.cup.rear_ramp=0.3 --set flexspline.cup.front_ramp=0.3 --set "
        "flexspline.profile.addendum=0.1575"
        " --set flexspline.profile.dedendum=0.2121 --set flexspline.profile.convex_radius=0.18907"
        " --set flexspline.profile.convex_offset=0.06874 --set flexspline.profile.concave_radius=0.36015"
        " --set flexspline.profile.concave_rise=0.04697 --set flexspline.profile.tip_line_from=0.133"
        " --set wave_generator.radial_deformation=0.17 --set circular_spline.width=4.5"
        " --set circular_spline.inner_radius=17.535 --set coning.bottom_to_middle=7.7 --set bearing.width=4"
        " --set bearing.ring_thickness=0.8";
    Row const row = GENERATE_REF(Row{"rigid",
                                     " --steps 12 --set bearing.type=rigid --set '!bearing.ring_thickness' --set "
                                     "'!bearing.axially'"},
                                 Row{"elastic ring", " --steps 12"}, Row{"small drive", small});
    CAPTURE(row.what);
    if (std::string(row.what) != "rigid" && !full_run())
        return;  // CalculiX takes half a minute for each ring that bends, and 12 s for the rigid one
    TemporaryFolder const folder;
    auto const written = hdconj_run("export " + scene + "--calculix deck --contact" + row.options, folder.path());
    INFO(written.err);
    REQUIRE(written.status == 0);
    auto const deck = folder.path() / "deck";
    auto const force = values((deck / "expected_contact.csv").string());
    REQUIRE(force.size() == 2);
    if (run("command -v ccx").status != 0) {
        not_tried("ccx");
        return;
    }
    REQUIRE(run("OMP_NUM_THREADS=1 ccx contact", deck).status == 0);
    auto const found = surface_force((deck / "contact.dat").string());
    constexpr double close = 0.03;  // grids of contact points that differ, and a penalty
    CHECK(-found[0] == Approx(force[0]).epsilon(close));
    CHECK(-found[1] == Approx(force[1]).epsilon(close));
    CHECK(compared(deck, "contact") == 0);
    auto const expected = displacements((deck / "expected.csv").string(), ','),
               computed = displacements((deck / "contact.dat").string(), ' ');
    for (double const phi_deg : {0.0, 90.0}) {
        double const coning = slope((deck / "expected.csv").string(), computed, phi_deg);
        CAPTURE(phi_deg, coning);
        CHECK(std::abs(coning) > 0.01);
        CHECK(coning == Approx(slope((deck / "expected.csv").string(), expected, phi_deg)).epsilon(close));
    }
}

TEST_CASE("the exported cup is read by meshio", "[export]")
{
    if (std::string(HDCONJ_PYTHON).empty() || run("'" HDCONJ_PYTHON "' -c 'import meshio'").status != 0) {
        not_tried("python with meshio");
        return;
    }
    TemporaryFolder const folder;
    REQUIRE(hdconj_run("export " + scene + "--vtu cup.vtu --steps 12", folder.path()).status == 0);
    auto const read =
        run("'" HDCONJ_PYTHON "' '" HDCONJ_SOURCE_DIR "/tests/cli/readers/read_bent_cup.py' cup.vtu", folder.path());
    INFO(read.out << read.err);
    CHECK(read.status == 0);
}

TEST_CASE("the built-in drive's cup is exported as load bends it", "[export]")
{
    TemporaryFolder const folder;
    CHECK(hdconj_run("export --vtu cup.vtu --steps 4", folder.path()).status == 0);
    CHECK(folder.names() == std::vector<std::string>{"cup.vtu"});
}

TEST_CASE("an export says as JSON what it wrote", "[export]")
{
    TemporaryFolder const folder;
    auto const done = hdconj_run("export " + scene + "--vtu cup.vtu --calculix deck --steps 4 --json", folder.path());
    INFO(done.err);
    REQUIRE(done.status == 0);
    auto const said = nlohmann::json::parse(done.out);
    CHECK(said.at("format") == "hdconj-export");
    CHECK(said.at("files").at("vtu").at("path") == "cup.vtu");
    CHECK(said.at("files").at("calculix").at("path") == "deck");
    CHECK(said.at("cup").at("coning_major_deg") == Approx(1.24).epsilon(0.02));
    CHECK(done.err == "wrote deck\nwrote cup.vtu\n");
}

TEST_CASE("an export of nothing or of no elastic cup is refused", "[export]")
{
    TemporaryFolder const folder;
    auto const nothing = hdconj_run("export " + scene, folder.path());
    CHECK(nothing.status == 2);
    CHECK(nothing.err.find("--calculix") != std::string::npos);
    auto const stiff =
        hdconj_run("export --vtu cup.vtu --set coning.model=linear --set coning.bottom_to_middle=9", folder.path());
    CHECK(stiff.status == 2);
    CHECK(stiff.err.find("no elastic cup") != std::string::npos);
    CHECK(hdconj_run("export " + scene + "--vtu cup.vtu --contact", folder.path()).err.find("--calculix") !=
          std::string::npos);
    auto const springs =
        hdconj_run("export " + scene + "--calculix deck --contact --set bearing.radial_stiffness=1000", folder.path());
    CHECK(springs.status == 2);
    CHECK(springs.err.find("balls are rigid") != std::string::npos);
    auto const single =
        hdconj_run("export " + scene + "--calculix deck --contact --set bearing.balls=22", folder.path());
    CHECK(single.status == 2);
    CHECK(single.err.find("balls are a line") != std::string::npos);
    auto const coarse = hdconj_run("export " + scene + "--calculix deck --contact --steps 11", folder.path());
    CHECK(coarse.status == 2);
    CHECK(coarse.err.find("--steps 24") != std::string::npos);
    auto const text = hdconj_run("export " + scene + "--vtu cup.txt", folder.path());
    CHECK(text.status == 2);
    CHECK(text.err.find("--vtu = cup.txt: ParaView knows the file by its ending .vtu (write NAME.vtu)") !=
          std::string::npos);
    CHECK(folder.names().empty());
}

TEST_CASE("the contact deck leaves a ring free where it stands off its balls", "[export]")
{
    TemporaryFolder const folder;
    auto const loose = hdconj_run(
        "export " + scene + "--calculix loose --contact --steps 12 --set bearing.cam_oversize=-0.01", folder.path());
    INFO(loose.err);
    REQUIRE(loose.status == 0);
    CHECK(loose.out.find("largest gap between outer ring and balls") != std::string::npos);
    REQUIRE(hdconj_run("export " + scene + "--calculix tight --contact --steps 12", folder.path()).status == 0);
    auto const moved = [&](char const* name) {
        std::ifstream in(folder.path() / name / "contact.inp");
        std::string line;
        int count = 0;
        bool inside = false;
        while (std::getline(in, line)) {
            inside = line.starts_with("*") ? line == "*NSET, NSET=NCAM" : inside;
            count += inside && !line.starts_with("*") ? static_cast<int>(std::count(line.begin(), line.end(), ',')) : 0;
        }
        return count;
    };
    // twelve elements have twenty-five nodes on their side
    CHECK(moved("tight") == 25);
    CHECK(moved("loose") < 25);
    CHECK(moved("loose") > 3);
}

}  // namespace hdconj::test::cup_export_cases
