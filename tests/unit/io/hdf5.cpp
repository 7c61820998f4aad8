// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>
#include <cstdlib>

#include "hdconj/file/atomic_file.hpp"
#include "hdconj/result_files.hpp"
#include "io/hdf5/checksum.hpp"
#include "io/hdf5/hdf5_handle.hpp"
#include "support/catch.hpp"
#include "support/read_hdf5.hpp"
#include "support/sample_solution.hpp"
#include "support/temporary_folder.hpp"

namespace hdconj::test::hdf5_cases {

using test::content;
using test::open_file;
using test::read;
using test::TemporaryFolder;

namespace {

/// Sets SOURCE_DATE_EPOCH while it lives.
class FixedDate
{
  public:
    explicit FixedDate(char const* seconds) { ::setenv("SOURCE_DATE_EPOCH", seconds, 1); }
    ~FixedDate() { ::unsetenv("SOURCE_DATE_EPOCH"); }
    FixedDate(FixedDate const&) = delete;
    FixedDate& operator=(FixedDate const&) = delete;
};

std::string bytes_of(Solution const& solution, char const* date)
{
    TemporaryFolder const folder;
    FixedDate const fixed(date);
    write_hdf5(solution, folder / "a.h5");
    return content(folder / "a.h5");
}

}  // namespace

TEST_CASE("numbers come back from HDF5 bit for bit, in the documented shapes")
{
    TemporaryFolder const folder;
    auto const solution = sample::solution();
    write_hdf5(solution, folder / "a.h5");
    auto const file = open_file(folder / "a.h5");
    auto const outline = read(file, "/circular_spline/outline");
    auto const& written = solution.circular_spline.outline.front();
    REQUIRE(outline.shape == std::vector<hsize_t>{1, written.size(), 2});
    for (std::size_t i = 0; i < written.size(); ++i) {
        REQUIRE(outline.values[2 * i] == written[i].x());
        REQUIRE(outline.values[2 * i + 1] == written[i].y());
    }
    CHECK(read(file, "/envelope/branch_001/phi").values == solution.branches.at(1).phi);
    CHECK(read(file, "/neutral_curve").shape == std::vector<hsize_t>{720, 2});
    CHECK(read(file, "/conjugate_zones/phi").shape == std::vector<hsize_t>{solution.zones.size(), 2});
    CHECK(read(file, "/timing/seconds").values.size() == solution.timing.size());
    CHECK(read(file, "/undecided/u_width").values == std::vector<double>{3e-7});
    CHECK(read(file, "/circular_spline/landmarks").values.back() == solution.circular_spline.landmarks.back());
}

TEST_CASE("slices lie one after the other in the outline")
{
    TemporaryFolder const folder;
    auto solution = sample::solution();
    auto& spline = solution.circular_spline;
    spline.z = {-3.5, 0, 3.5};
    spline.outline.assign(3, spline.outline.front());
    spline.outline[2][5] = Vec2(1, 2);
    write_hdf5(solution, folder / "a.h5");
    auto const outline = read(open_file(folder / "a.h5"), "/circular_spline/outline");
    std::size_t const points = spline.outline[0].size();
    CHECK(outline.shape == std::vector<hsize_t>{3, points, 2});
    CHECK(outline.values[2 * (2 * points + 5) + 1] == 2);
    spline.outline[1].pop_back();
    CHECK_THROWS_AS(write_hdf5(solution, folder / "a.h5"), std::logic_error);
}

TEST_CASE("a solution with nothing in it makes a readable file")
{
    TemporaryFolder const folder;
    write_hdf5(Solution{}, folder / "a.h5");
    auto const file = open_file(folder / "a.h5");
    CHECK(read(file, "/neutral_curve").shape == std::vector<hsize_t>{0, 2});
    CHECK(read(file, "/circular_spline/outline").shape == std::vector<hsize_t>{0, 0, 2});
    CHECK(read(file, "/undecided/u").shape == std::vector<hsize_t>{0});
    CHECK(H5Aexists_by_name(file, "/summary", "smallest_clearance_mm", H5P_DEFAULT) == 0);
}

TEST_CASE("equal content gives equal bytes, and another date changes nothing but the date and the checksum")
{
    auto const solution = sample::solution();
    auto const first = bytes_of(solution, "1000000000");
    CHECK(first == bytes_of(solution, "1000000000"));
    CHECK(first.find("2001-09-09T01:46:40Z") != std::string::npos);
    auto const later = bytes_of(solution, "2000000000");
    REQUIRE(first.size() == later.size());
    auto const place = first.find("2001-09-09T01:46:40Z");
    for (std::size_t i = 0; i < first.size(); ++i) {
        bool const in_date = i >= place && i < place + std::string("2001-09-09T01:46:40Z").size();
        bool const in_checksum = i + io::hdf5::Checksum::line_length >= first.size();
        REQUIRE((in_date || in_checksum || first[i] == later[i]));
    }
}

TEST_CASE("HDF5 failures carry the library's reason and print nothing")
{
    io::hdf5::Silence const silence;
    CHECK_THROWS_WITH(open_file("no such file.h5"),
                      ContainsSubstring("HDF5 cannot open") && ContainsSubstring("No such file"));
}

TEST_CASE("a result that cannot be written says why")
{
    TemporaryFolder const folder;
    CHECK_THROWS_WITH(write_hdf5(Solution{}, folder / "none/a.h5"), ContainsSubstring("does not exist"));
    CHECK_THROWS_WITH(write_hdf5(Solution{}, "/dev/full"), ContainsSubstring("No space left"));
}

TEST_CASE("writing a result is quick", "[.bench]")
{
    TemporaryFolder const folder;
    auto const solution = sample::solution();
    double best = 1;
    for (int i = 0; i < 20; ++i) {
        auto const begin = std::chrono::steady_clock::now();
        write_hdf5(solution, folder / "a.h5");
        best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    }
    WARN("best of 20: " << best * 1000 << " ms");
    CHECK(best < 3e-3);
}

}  // namespace hdconj::test::hdf5_cases
