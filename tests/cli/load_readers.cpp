// SPDX-License-Identifier: GPL-3.0-or-later
// Other people's programs read the files of a load study.
#include <algorithm>

#include "hdconj/load_files.hpp"
#include "hdconj_run.hpp"
#include "support/catch.hpp"
#include "support/not_tried.hpp"
#include "support/rig_loop.hpp"
#include "support/run_program.hpp"
#include "support/temporary_folder.hpp"

namespace hdconj::test::load_readers_cases {

using test::run;
using test::TemporaryFolder;

namespace {

std::string const python = "'" HDCONJ_PYTHON "' ";
std::string const cup_reader = python + "'" HDCONJ_SOURCE_DIR "/tests/cli/readers/read_cup.py' ";

bool is_missing(std::string const& modules)
{
    if (!std::string(HDCONJ_PYTHON).empty() && run(python + "-c 'import " + modules + "'").status == 0)
        return false;
    not_tried("python with " + modules);
    return true;
}

/// A small cup is read as well, and quicker.
LoadStudy small_study()
{
    auto study = sample::load_study(3);
    auto& shape = study.shape;
    std::size_t const nodes = shape.r.size(), kept = 8;
    std::vector<double> phi;
    CupShape thin;
    thin.r = shape.r;
    thin.z = shape.z;
    thin.cells = shape.cells;
    for (std::size_t a = 0; a < kept; ++a) {
        thin.phi.push_back(std::numbers::pi * static_cast<double>(a) / kept);
        for (std::size_t p = 0; p < nodes; ++p) {
            std::size_t const from = a * (shape.phi.size() / kept) * nodes + p;
            thin.u_r.push_back(shape.u_r[from]);
            thin.u_t.push_back(shape.u_t[from]);
            thin.u_z.push_back(shape.u_z[from]);
            thin.stress.push_back(shape.stress[from]);
        }
    }
    shape = thin;
    return study;
}

}  // namespace

TEST_CASE("h5py reads a load result and finds the documented layout", "[load]")
{
    if (is_missing("h5py, ezdxf"))
        return;
    TemporaryFolder const folder;
    Measurement measured;
    measured.curve = sample::rig_loop({});
    measured.found = measured_stiffness(measured.curve);
    write_hdf5(sample::load_study(3), folder / "a.h5", &measured);
    auto const read = run(python + "'" HDCONJ_SOURCE_DIR "/tests/cli/readers/read_with_h5py.py' a.h5", folder.path());
    CHECK_THAT(read.out + read.err, ContainsSubstring(", 2 branches, 0 faults\n"));
    CHECK(read.status == 0);
}

TEST_CASE("the balance of loaded teeth is checked from the file alone", "[load]")
{
    if (is_missing("h5py"))
        return;
    TemporaryFolder const folder;
    std::string const run_load = "load --no-curve --quiet --set slices.count=3 --set bearing.circles=5 -o ";
    for (auto const* scene :
         {"a.h5 --set circular_spline.backlash_offset=0.09 --surface tilted,per-slice",
          "b.h5 --set contact.wave_generator_angle_deg=0.4 --torque 3", "c.h5 --set bearing.balls=22 --torque 10"})
        REQUIRE(hdconj_run(run_load + scene, folder.path()).status == 0);
    std::string const reader = python + "'" HDCONJ_SOURCE_DIR "/tests/cli/readers/check_equilibrium.py' ";
    auto const read = run(reader + "a.h5 b.h5 c.h5", folder.path());
    CHECK(read.err.empty());
    CHECK(read.status == 0);
    CHECK_THAT(read.out, ContainsSubstring("case_001: ") && ContainsSubstring("balance of 3 N m to"));
    // One force a thousandth larger is found.
    REQUIRE(run(python + "-c 'import h5py; h5py.File(\"a.h5\", \"r+\")[\"load/case_000/contacts/force\"][0] *= 1.001'",
                folder.path())
                .status == 0);
    auto const broken = run(reader + "a.h5", folder.path());
    CHECK(broken.status == 1);
    CHECK_THAT(broken.err, ContainsSubstring("torques add up to"));
}

TEST_CASE("meshio reads the cup and it is the shape of the result", "[load][vtu]")
{
    if (is_missing("meshio, h5py"))
        return;
    TemporaryFolder const folder;
    std::string arguments;
    auto const add = [&](std::string const& name, LoadStudy const& stored, LoadStudy const& drawn, char const* turns) {
        write_hdf5(stored, folder / (name + ".h5"));
        write_cup_vtu(drawn, folder / (name + ".vtu"));
        arguments += name + ".h5 " + name + ".vtu " + turns + " ";
    };
    auto const study = small_study();
    add("ring", study, study, "2");
    // Triangles become wedges; no stress; an open stretch of the ring.
    auto wedges = study;
    wedges.shape.cells[3].pop_back();
    wedges.shape.stress.clear();
    add("wedges", wedges, wedges, "2");
    wedges.sectors = 1;
    add("stretch", wedges, wedges, "1");
    auto read = run(cup_reader + arguments, folder.path());
    INFO(read.out << read.err);
    CHECK(read.err.empty());
    CHECK(read.status == 0);
    for (auto const* line : {"ring.vtu: 1184 points, hexahedron, ", "wedges.vtu: 1184 points, hexahedron and wedge, ",
                             "stretch.vtu: 592 points, hexahedron and wedge, "}) {
        CHECK_THAT(read.out, ContainsSubstring(line));
    }
    // The reader sees a wrong displacement, a wrong stress and cells the wrong way round.
    arguments.clear();
    auto moved = study, stressed = study, turned = study;
    moved.shape.u_t[40] += 1e-9;
    add("moved", study, moved, "2");
    stressed.shape.stress[40] += 1e-9;
    add("stressed", study, stressed, "2");
    std::reverse(turned.shape.cells[2].begin(), turned.shape.cells[2].end());
    add("turned", turned, turned, "2");
    read = run(cup_reader + arguments, folder.path());
    INFO(read.out << read.err);
    CHECK(read.status == 1);
    for (auto const* line : {"moves elsewhere", "has another stress", "turned.vtu: cells of negative volume"})
        CHECK_THAT(read.out, ContainsSubstring(line));
}

}  // namespace hdconj::test::load_readers_cases
