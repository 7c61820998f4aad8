// SPDX-License-Identifier: GPL-3.0-or-later
// Other people's programs read what we write.
#include "hdconj/contact_files.hpp"
#include "hdconj/load_files.hpp"
#include "hdconj/mesh_files.hpp"
#include "support/catch.hpp"
#include "support/not_tried.hpp"
#include "support/run_program.hpp"
#include "support/sample_contact_study.hpp"
#include "support/sample_load_study.hpp"
#include "support/temporary_folder.hpp"

namespace hdconj::test::readers_cases {

using test::run;
using test::TemporaryFolder;

namespace {

bool skipped_without(std::string const& program)
{
    bool const missing = test::is_missing(program);
    if (missing)
        not_tried(program);
    return missing;
}

std::string const reader =
    std::string("'" HDCONJ_PYTHON "' '") + HDCONJ_SOURCE_DIR + "/tests/cli/readers/read_with_h5py.py' ";

}  // namespace

TEST_CASE("h5py and ezdxf read the files and find the documented layout")
{
    if (std::string(HDCONJ_PYTHON).empty()) {
        not_tried("python with h5py and ezdxf");
        return;
    }
    TemporaryFolder const folder;
    auto solution = sample::solution();
    solution.circular_spline.z = {-3.5, 3.5};
    solution.circular_spline.outline.assign(2, solution.circular_spline.outline.front());
    write_hdf5(solution, folder / "a.h5");
    write_dxf(solution, folder / "a.dxf");
    auto const read = run(reader + "a.h5 a.dxf", folder.path());
    CHECK(read.out + read.err == "40 datasets, 2 branches, 0 faults\n");
    CHECK(read.status == 0);
    solution.neutral_curve[7].x() += 1e-6;
    write_hdf5(solution, folder / "a.h5");
    CHECK(run(reader + "a.h5 a.dxf", folder.path()).out.find("neutral curve differs") != std::string::npos);
}

TEST_CASE("h5py reads a contact result and finds the documented layout")
{
    if (std::string(HDCONJ_PYTHON).empty()) {
        not_tried("python with h5py and ezdxf");
        return;
    }
    TemporaryFolder const folder;
    write_hdf5(sample::contact_study(3), folder / "a.h5");
    auto const read = run(reader + "a.h5", folder.path());
    CHECK_THAT(read.out + read.err, ContainsSubstring(", 2 branches, 0 faults\n"));
    CHECK(read.status == 0);
}

TEST_CASE("xarray shows dimensions by their names, and z as a coordinate")
{
    if (std::string(HDCONJ_PYTHON).empty()) {
        not_tried("python with h5py and ezdxf");
        return;
    }
    TemporaryFolder const folder;
    write_hdf5(Solution{}, folder / "nothing.h5");
    write_hdf5(sample::solution(), folder / "solution.h5");
    write_hdf5(sample::contact_study(3), folder / "contact.h5");
    write_hdf5(sample::load_study(), folder / "load.h5");
    auto const read = run("'" HDCONJ_PYTHON "' '" HDCONJ_SOURCE_DIR
                          "/tests/cli/readers/read_with_xarray.py' "
                          "nothing.h5 solution.h5 contact.h5 load.h5",
                          folder.path());
    if (read.err.find("no xarray") != std::string::npos) {
        not_tried("python with xarray and h5netcdf");
        return;
    }
    CHECK_THAT(read.out + read.err, ContainsSubstring(" variables, 0 faults\n"));
    CHECK(read.status == 0);
}

TEST_CASE("surfaces of tooth and ring are read by other programs and are the slices")
{
    if (std::string(HDCONJ_PYTHON).empty()) {
        not_tried("python with h5py and ezdxf");
        return;
    }
    TemporaryFolder const folder;
    auto study = sample::contact_study(3);
    study.written_case = 1;
    SurfaceOptions ring;
    ring.ring = true;
    write_hdf5(study, folder / "a.h5");
    write_xdmf(study.solution, folder / "tooth.xdmf", folder / "a.h5");
    write_stl(study.solution, folder / "tooth.stl");
    write_vtk(study, folder / "tooth.vtk");
    write_xdmf(study.solution, folder / "ring.xdmf", ring);
    write_stl(study.solution, folder / "ring.stl", ring);
    write_vtk(study, folder / "ring.vtk", ring);
    std::string const surfaces = "'" HDCONJ_PYTHON "' '" HDCONJ_SOURCE_DIR "/tests/cli/readers/read_surfaces.py' ";
    auto const read = run(surfaces + "a.h5 tooth ring", folder.path());
    INFO(read.out + read.err);
    CHECK(read.status == 0);
    if (read.out.find("no meshio") != std::string::npos)
        not_tried("python with meshio");
    // The reader sees a wrong gap and a wrong point.
    study.map.gap[study.map.index(1, GapMap::right, 1, 20)] += 1e-6;
    write_vtk(study, folder / "ring.vtk", ring);
    CHECK_THAT(run(surfaces + "a.h5 tooth ring", folder.path()).out, ContainsSubstring("gaps of space 1 differ"));
    study.solution.circular_spline.outline[1][40].x() += 1e-6;
    write_hdf5(study, folder / "b.h5");
    write_xdmf(study.solution, folder / "tooth.xdmf", folder / "b.h5");
    CHECK_THAT(run(surfaces + "a.h5 tooth ring", folder.path()).out, ContainsSubstring("is not the slices"));
}

TEST_CASE("h5dump reads every dataset")
{
    if (skipped_without("h5dump"))
        return;
    TemporaryFolder const folder;
    write_hdf5(sample::solution(), folder / "a.h5");
    auto const dump = run("h5dump a.h5", folder.path());
    CHECK(dump.status == 0);
    CHECK(dump.err.empty());
    CHECK_THAT(dump.out, ContainsSubstring("neutral_curve") && ContainsSubstring("branch_001"));
}

TEST_CASE("SVG pictures are well-formed")
{
    if (skipped_without("gnuplot") || skipped_without("rsvg-convert"))
        return;
    TemporaryFolder const folder;
    write_picture(sample::solution(), folder / "a.svg");
    CHECK(run("rsvg-convert a.svg -o a.png", folder.path()).status == 0);
    for (auto const& picture : write_contact_pictures(sample::contact_study(), folder / "b.svg"))
        CHECK(run("rsvg-convert " + picture.file.filename().string() + " -o b.png", folder.path()).status == 0);
}

}  // namespace hdconj::test::readers_cases
