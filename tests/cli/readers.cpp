// SPDX-License-Identifier: GPL-3.0-or-later
// Other people's programs read what we write.
#include "hdconj/io/result_files.hpp"
#include "support/catch.hpp"
#include "support/run_program.hpp"
#include "support/sample_solution.hpp"
#include "support/temporary_folder.hpp"

using namespace hdconj;
using test::run;
using test::TemporaryFolder;

namespace {

bool is_missing(std::string const& program)
{
    if (run("command -v " + program).status == 0) {
        return false;
    }
    WARN(program << " is not installed: not tried");
    return true;
}

std::string const reader = std::string("'" HDCONJ_PYTHON "' '") + HDCONJ_SOURCE_DIR + "/tests/cli/read_with_h5py.py' ";

}  // namespace

TEST_CASE("h5py and ezdxf read the files and find the documented layout")
{
    if (std::string(HDCONJ_PYTHON).empty()) {
        WARN("no python with h5py and ezdxf: not tried");
        return;
    }
    TemporaryFolder const folder;
    auto solution = sample::solution();
    solution.circular_spline.z = {-3.5, 3.5};
    solution.circular_spline.outline.assign(2, solution.circular_spline.outline.front());
    write_hdf5(solution, folder / "a.h5");
    write_dxf(solution, folder / "a.dxf");
    auto const read = run(reader + "a.h5 a.dxf", folder.path());
    CHECK(read.out + read.err == "32 datasets, 2 branches, 0 faults\n");
    CHECK(read.status == 0);
    solution.neutral_curve[7].x() += 1e-6;
    write_hdf5(solution, folder / "a.h5");
    CHECK(run(reader + "a.h5 a.dxf", folder.path()).out.find("neutral curve differs") != std::string::npos);
}

TEST_CASE("h5dump reads every dataset")
{
    if (is_missing("h5dump")) {
        return;
    }
    TemporaryFolder const folder;
    write_hdf5(sample::solution(), folder / "a.h5");
    auto const dump = run("h5dump a.h5", folder.path());
    CHECK(dump.status == 0);
    CHECK(dump.err.empty());
    CHECK_THAT(dump.out, ContainsSubstring("neutral_curve") && ContainsSubstring("branch_001"));
}

TEST_CASE("SVG pictures are well-formed")
{
    if (is_missing("gnuplot") || is_missing("rsvg-convert")) {
        return;
    }
    TemporaryFolder const folder;
    write_picture(sample::solution(), folder / "a.svg");
    CHECK(run("rsvg-convert a.svg -o a.png", folder.path()).status == 0);
}
