// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>

#include <cstring>
#include <numbers>

#include "base/segments.hpp"
#include "hdconj/error.hpp"
#include "hdconj/file/atomic_file.hpp"
#include "hdconj/mesh_files.hpp"
#include "io/mesh/gap_on_surface.hpp"
#include "io/mesh/spline_surface.hpp"
#include "support/catch.hpp"
#include "support/sample_contact_study.hpp"
#include "support/temporary_folder.hpp"

namespace hdconj::test::surface_files_cases {

using test::content;
using test::TemporaryFolder;

namespace {

double area(io::Surface const& surface)
{
    double sum = 0;
    for (auto const& quad : surface.quads) {
        Eigen::Vector3d corner[4];
        for (std::size_t i = 0; i < 4; ++i)
            corner[i] = Eigen::Vector3d(surface.points[static_cast<std::size_t>(quad[i])].data());
        sum += ((corner[1] - corner[0]).cross(corner[2] - corner[0]).norm() +
                (corner[2] - corner[0]).cross(corner[3] - corner[0]).norm()) /
               2;
    }
    return sum;
}

SurfaceOptions ring(double tolerance)
{
    return {true, tolerance};
}

std::size_t triangles(std::string const& stl)
{
    std::uint32_t count = 0;
    std::memcpy(&count, stl.data() + 80, sizeof count);
    return count;
}

}  // namespace

TEST_CASE("the surface of one space has the points of the slices and a part for each cell")
{
    auto const study = sample::contact_study(3);
    auto const& spline = study.solution.circular_spline;
    auto const surface = io::tooth_surface(study.solution);
    std::size_t const n = spline.outline[0].size();
    REQUIRE(surface.points.size() == 3 * n);
    REQUIRE(surface.quads.size() == 2 * (n - 1));
    CHECK(surface.points[n + 7] ==
          std::array<double, 3>{spline.outline[1][7].x(), spline.outline[1][7].y(), spline.z[1]});
    for (std::size_t i = 0; i < n - 1; ++i) {
        int const at = static_cast<int>(i);
        auto const& mark = spline.landmarks;
        int const part = at < mark[0] || at >= mark[4] ? 0 : at < mark[1] ? 1 : at < mark[3] ? 2 : 3;
        REQUIRE(surface.part[i] == part);
        REQUIRE(surface.part[n - 1 + i] == part);
    }
}

TEST_CASE("the ring is as many spaces as there are teeth, closed, with the area of each")
{
    auto const study = sample::contact_study(3);
    auto const tooth = io::tooth_surface(study.solution);
    auto const all = io::spline_surface(study.solution, ring(0));
    std::size_t const steps = tooth.points.size() / 3 - 1, teeth = 202;
    CHECK(all.points.size() == 3 * teeth * steps);
    CHECK(all.quads.size() == teeth * tooth.quads.size());
    CHECK(area(all) == Approx(static_cast<double>(teeth) * area(tooth)).epsilon(1e-9));
    // Each point of a slice is the end of one cell and the beginning of the next: no seam.
    std::vector<int> used(all.points.size(), 0);
    for (auto const& quad : all.quads) {
        for (int const index : quad)
            ++used[static_cast<std::size_t>(index)];
    }
    for (std::size_t i = 0; i < used.size(); ++i) {
        std::size_t const slice = i / (teeth * steps);
        REQUIRE(used[i] == (slice == 1 ? 4 : 2));
    }
}

TEST_CASE("ends of neighbouring spaces that do not quite meet are joined half way")
{
    auto solution = sample::contact_study(2).solution;
    auto const exact = io::spline_surface(solution, ring(0));
    solution.circular_spline.outline[1].back() += Vec2(2e-4, 0);
    auto const joined = io::spline_surface(solution, ring(0));
    std::size_t const steps = solution.circular_spline.outline[0].size() - 1, first = 202 * steps;
    double const moved =
        std::hypot(joined.points[first][0] - exact.points[first][0], joined.points[first][1] - exact.points[first][1]);
    CHECK(moved == Approx(1e-4).epsilon(1e-6));
    CHECK(joined.points[first + 1] == exact.points[first + 1]);
}

TEST_CASE("points are left out only where no slice moves by more than the tolerance")
{
    auto spline = sample::contact_study(5).solution.circular_spline;
    std::size_t const n = spline.outline[0].size();
    spline.outline[3][n / 4].x() += 4e-3;  // seen in one slice only
    for (double const tolerance : {1e-2, 1e-3, 1e-4}) {
        auto const kept = io::kept_points(spline, tolerance);
        REQUIRE(kept.front() == 0);
        REQUIRE(kept.back() == n - 1);
        CHECK(std::is_sorted(kept.begin(), kept.end()));
        CHECK(std::adjacent_find(kept.begin(), kept.end()) == kept.end());
        CHECK(kept.size() < n);
        for (int const mark : spline.landmarks)
            CHECK(std::binary_search(kept.begin(), kept.end(), static_cast<std::size_t>(mark)));
        CHECK(std::binary_search(kept.begin(), kept.end(), n / 4) == (tolerance < 4e-3));
        for (std::size_t i = 0; i + 1 < kept.size(); ++i) {
            for (auto const& slice : spline.outline) {
                for (std::size_t j = kept[i]; j <= kept[i + 1]; ++j)
                    REQUIRE(squared_distance(slice[j], slice[kept[i]], slice[kept[i + 1]]) <= tolerance * tolerance);
            }
        }
    }
    CHECK(io::kept_points(spline, 0).size() == n);
}

TEST_CASE("one slice is as wide as the circular spline and without a width there is no surface")
{
    TemporaryFolder const folder;
    auto solution = sample::solution();
    auto const surface = io::tooth_surface(solution);
    CHECK(surface.points.front()[2] == -3.5);
    CHECK(surface.points.back()[2] == 3.5);
    solution.scene.circular_spline.width.reset();
    CHECK_FALSE(io::has_surface(solution));
    CHECK_THROWS_AS(write_stl(solution, folder / "a.stl"), InputError);
    CHECK_THROWS_WITH(write_xdmf(solution, folder / "a.xdmf", folder / "a.h5"),
                      ContainsSubstring("circular_spline.width"));
    CHECK_FALSE(io::has_surface(Solution{}));
    CHECK(folder.names().empty());
    solution = sample::contact_study(3).solution;
    solution.circular_spline.outline[1].pop_back();
    CHECK_THROWS_AS(io::tooth_surface(solution), std::logic_error);
}

TEST_CASE("XDMF names the result relative to its own folder")
{
    TemporaryFolder const folder;
    auto solution = sample::contact_study(3).solution;
    solution.scene.drive.name = "a <b> & \"c\"";
    std::filesystem::create_directory(folder / "sub");
    write_xdmf(solution, folder / "a.xdmf", folder / "r&d.h5");
    auto const text = content(folder / "a.xdmf");
    CHECK_THAT(text, ContainsSubstring(">r&amp;d.h5:/circular_spline/surface/points<"));
    CHECK_THAT(text, ContainsSubstring("\"a &lt;b&gt; &amp; &quot;c&quot;\""));
    CHECK_THAT(text, !ContainsSubstring(folder.path().string()));
    write_xdmf(solution, folder / "sub/a.xdmf", folder / "r.h5");
    CHECK_THAT(content(folder / "sub/a.xdmf"), ContainsSubstring(">../r.h5:/circular"));
    write_xdmf(solution, folder / "a.xdmf", folder / "sub/../sub/r.h5");
    CHECK_THAT(content(folder / "a.xdmf"), ContainsSubstring(">sub/r.h5:/circular"));
    CHECK_THROWS_WITH(write_xdmf(solution, folder / "b.xdmf", folder / "a:b.h5"), ContainsSubstring("colon"));
    CHECK_FALSE(std::filesystem::exists(folder / "b.xdmf"));
    write_xdmf(solution, folder / "ring.xdmf", ring(1e-3));
    CHECK_THAT(content(folder / "ring.xdmf"), ContainsSubstring(">ring.xdmf.h5:/surface/quads<"));
    CHECK(std::filesystem::exists(folder / "ring.xdmf.h5"));
}

TEST_CASE("STL has two triangles for each cell and none without an area")
{
    TemporaryFolder const folder;
    auto solution = sample::contact_study(3).solution;
    SurfaceOptions const all_points{false, 0};
    write_stl(solution, folder / "a.stl", all_points);
    std::size_t const n = solution.circular_spline.outline[0].size();
    CHECK(triangles(content(folder / "a.stl")) == 4 * (n - 1));
    CHECK(content(folder / "a.stl").size() == 84 + 50 * 4 * (n - 1));
    // A ruling shrinks to nothing towards one end: one of two triangles is left.
    solution.circular_spline.outline[0][21] = solution.circular_spline.outline[0][20];
    write_stl(solution, folder / "b.stl", all_points);
    CHECK(triangles(content(folder / "b.stl")) == 4 * (n - 1) - 1);
}

TEST_CASE("surfaces that cannot be written say why and leave nothing")
{
    TemporaryFolder const folder;
    auto study = sample::contact_study(3);
    CHECK_THROWS_AS(write_stl(study.solution, folder / "none/a.stl"), FileError);
    CHECK_THROWS_AS(write_vtk(study, "/dev/full"), FileError);
    CHECK_THROWS_AS(write_xdmf(study.solution, folder / "none/a.xdmf", folder / "a.h5"), FileError);
    study.map.angle[5] = study.map.angle[4];
    CHECK_THROWS_AS(write_vtk(study, folder / "a.vtk", ring(1e-3)), std::logic_error);
    CHECK(folder.names().empty());
    study.map = {};
    write_vtk(study, folder / "a.vtk");
    CHECK_THAT(content(folder / "a.vtk"), ContainsSubstring("SCALARS part") && !ContainsSubstring("SCALARS gap"));
}

TEST_CASE(
    "the fullest flank has the largest weighted area on the driving side, or the smallest gap where none is in contact")
{
    GapMap map;
    map.z = {0, 1, 4};
    map.station = {0, 0.5, 1};
    map.angle = {0, 1, 2};
    map.gap.assign(3 * 2 * 3 * 3, 1.0);
    auto const found = [&](std::size_t space, int flank, bool in_contact) {
        auto const best = io::fullest_flank(map, 0.1);
        return best.space == space && best.flank == flank && best.in_contact == in_contact;
    };
    map.gap[map.index(2, GapMap::left, 0, 1)] = 0.5;
    CHECK(found(2, GapMap::left, false));
    map.gap[map.index(2, GapMap::left, 0, 1)] = 0.05;
    CHECK(found(2, GapMap::left, true));
    map.gap[map.index(0, GapMap::right, 0, 0)] = 0;  // two points of weight 0.5 x 0.25 and 0.5 x 0.5
    map.gap[map.index(0, GapMap::right, 0, 1)] = 0;
    CHECK(found(0, GapMap::right, true));
    map.gap[map.index(1, GapMap::right, 1, 1)] = 0.1;  // one of weight 2 x 0.5
    CHECK(found(1, GapMap::right, true));
    map.gap[map.index(2, GapMap::left, 1, 0)] = 0.1;  // more, on the other side
    map.gap[map.index(2, GapMap::left, 1, 1)] = 0.1;
    CHECK(found(1, GapMap::right, true));
}

TEST_CASE("gaps on a surface are those of the map at its stations and none off the flanks")
{
    auto study = sample::contact_study(3);
    study.map.gap.assign(study.map.gap.size(), 0.0);
    // Linear along the flank and across the slices: interpolation is exact.
    for (std::size_t s = 0; s < study.map.angle.size(); ++s) {
        for (int const flank : {0, 1}) {
            for (std::size_t k = 0; k < 3; ++k) {
                for (std::size_t p = 0; p < study.map.station.size(); ++p) {
                    study.map.gap[study.map.index(s, flank, k, p)] =
                        2.0 + flank + 0.01 * study.map.z[k] + 0.5 * study.map.station[p];
                }
            }
        }
    }
    auto const surface = io::tooth_surface(study.solution);
    auto const gaps = io::gaps_of(surface, study, false);
    auto const& mark = study.solution.circular_spline.landmarks;
    std::size_t const n = study.solution.circular_spline.outline[0].size();
    auto const at = [&](std::size_t slice, int index) { return gaps[slice * n + static_cast<std::size_t>(index)]; };
    CHECK(at(0, mark[0]) == Approx(2.0 - 0.035));
    CHECK(at(2, mark[1]) == Approx(2.5 + 0.035));
    CHECK(at(1, mark[3]) == Approx(3.5));
    CHECK(at(1, mark[4]) == Approx(3.0));
    CHECK(std::isnan(at(1, mark[0] - 1)));
    CHECK(std::isnan(at(1, mark[2])));
    CHECK(std::isnan(at(1, mark[4] + 1)));
}

TEST_CASE("a station is the same pair of points in all slices and a share of the length in the middle one")
{
    auto spline = sample::contact_study(3).solution.circular_spline;
    auto const& mark = spline.landmarks;
    // The lowest slice's first piece of flank grows: other places there, the same stations.
    for (std::size_t i = 0; i < static_cast<std::size_t>(mark[4]); ++i)
        spline.outline[0][i].y() += 0.5;
    io::FlankStations const right(spline, GapMap::right);
    auto const land = static_cast<std::size_t>(mark[4]), end = static_cast<std::size_t>(mark[3]);
    CHECK(right.at(land) == 0.0);
    CHECK(right.at(end) == 1.0);
    CHECK_FALSE(right.at(land + 1).has_value());
    CHECK_FALSE(right.at(end - 1).has_value());
    double whole = 0, half = 0;
    std::size_t const between = (land + end) / 2;
    for (std::size_t i = land; i > end; --i) {
        double const step = (spline.outline[1][i] - spline.outline[1][i - 1]).norm();
        whole += step;
        half += i > between ? step : 0;
    }
    CHECK(*right.at(between) == Approx(half / whole).epsilon(1e-12));
    std::vector<double> const stations = {0, half / whole, 1};
    CHECK(right.along(spline.outline[1], stations)[1] == Approx(half).epsilon(1e-12));
    CHECK(right.along(spline.outline[1], stations)[2] == Approx(whole).epsilon(1e-12));
    double const grown = (spline.outline[0][land] - spline.outline[0][land - 1]).norm() -
                         (spline.outline[1][land] - spline.outline[1][land - 1]).norm();
    CHECK(grown > 0.4);
    CHECK(right.along(spline.outline[0], stations)[1] == Approx(half + grown).epsilon(1e-12));
    CHECK_THROWS_AS(io::FlankStations(CircularSplineOutline{}, GapMap::left), std::logic_error);
}

}  // namespace hdconj::test::surface_files_cases
