// SPDX-License-Identifier: GPL-3.0-or-later
// hdconj export: a deck that CalculiX agrees with, and a cup that other readers read.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "support/catch.hpp"
#include "support/run_program.hpp"
#include "support/temporary_folder.hpp"

using namespace hdconj::test;

namespace {

std::string const scene = "'" HDCONJ_SOURCE_DIR "/data/scenes/type-50-elastic.toml' ";

Outcome hdconj_run(std::string const& arguments, std::filesystem::path const& folder)
{
    return run("'" HDCONJ_PROGRAM "' " + arguments, folder);
}

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
        while (numbers >> number) {
            all.push_back(number);
        }
        if (all.size() >= 4) {
            found[static_cast<int>(all.front())] = {all.end() - 3, all.end()};
        }
    }
    return found;
}

}  // namespace

TEST_CASE("CalculiX comes to the same displacements of the exported cup", "[export]")
{
    TemporaryFolder const folder;
    auto const written = hdconj_run("export " + scene + "--calculix deck --steps 24", folder.path());
    INFO(written.err);
    REQUIRE(written.status == 0);
    CHECK(written.out.find("cones by 1.2") != std::string::npos);
    auto const expected = displacements((folder.path() / "deck" / "expected.csv").string(), ',');
    REQUIRE(expected.size() > 60);
    if (run("command -v ccx").status != 0) {
        WARN("no ccx here: the deck was written and not computed");
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
}

TEST_CASE("the exported cup is read by meshio", "[export]")
{
    if (std::string(HDCONJ_PYTHON).empty() || run("'" HDCONJ_PYTHON "' -c 'import meshio'").status != 0) {
        WARN("no python with meshio: not tried");
        return;
    }
    TemporaryFolder const folder;
    REQUIRE(hdconj_run("export " + scene + "--vtu cup.vtu --steps 12", folder.path()).status == 0);
    auto const read = run("'" HDCONJ_PYTHON "' '" HDCONJ_SOURCE_DIR "/tests/cli/read_bent_cup.py' cup.vtu", folder.path());
    INFO(read.out << read.err);
    CHECK(read.status == 0);
}

TEST_CASE("an export of nothing or of no elastic cup is refused", "[export]")
{
    TemporaryFolder const folder;
    auto const nothing = hdconj_run("export " + scene, folder.path());
    CHECK(nothing.status == 2);
    CHECK(nothing.err.find("--calculix") != std::string::npos);
    auto const stiff = hdconj_run("export --vtu cup.vtu", folder.path());
    CHECK(stiff.status == 2);
    CHECK(stiff.err.find("no elastic cup") != std::string::npos);
    CHECK(folder.names().empty());
}
