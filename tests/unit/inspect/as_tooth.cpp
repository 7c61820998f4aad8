// SPDX-License-Identifier: GPL-3.0-or-later
// A member is measured and takes the place of what the scene gave: the other member is then solved for.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "drive/drive.hpp"
#include "hdconj/check.hpp"
#include "hdconj/inspect.hpp"
#include "hdconj/inspect_files.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/solve.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

namespace hdconj::test::as_tooth_cases {
namespace {

/// Points without noise of a solved outline, four teeth of the ring.
PointFile points_of(std::vector<Vec2> const& outline, std::vector<OutlinePiece> const& pieces, double seat, int teeth)
{
    PointFile file{"ring", {}, false};
    for (int const tooth : {0, 1, 2, 70})
        for (OutlinePiece const& piece : pieces)
            for (std::size_t i = piece.first; piece.kind == "flank" && i <= piece.last; ++i)
                if ((i - piece.first) % 3 == 0 || i == piece.last)
                    file.points.push_back(
                        {turned_clockwise(outline[i] + Vec2(0, seat), 2 * std::numbers::pi * tooth / teeth), 0, 0,
                         std::nullopt, 0});
    return file;
}

/// The scene with the measured member, as a file and read again.
Scene with_measured(Scene const& scene, PointFile const& file, InspectedPart part, TemporaryFolder const& folder)
{
    Inspection const found = inspect_points(scene, file, {part, std::nullopt, 0, Registration::datum});
    write_measured_tooth(found, folder / "cut.toml");
    auto const reading = examine_scene_file(folder / "cut.toml");
    REQUIRE(reading.faults.empty());
    return reading.scene;
}

/// What the smoothing by degree 5 leaves out, and both tolerances [mm].
constexpr double smoothing = 2e-6;

/// Share of the points of @p outline's flanks that lie on the broken line @p other. A member that is solved for touches
/// with a part of its flank; beyond it there is room.
double share_on(std::vector<Vec2> const& outline, std::vector<OutlinePiece> const& pieces,
                std::vector<Vec2> const& other)
{
    double count = 0, on = 0;
    for (OutlinePiece const& piece : pieces)
        for (std::size_t i = piece.first; piece.kind == "flank" && i <= piece.last; ++i) {
            double nearest = 1;
            for (std::size_t k = 0; k + 1 < other.size(); ++k) {
                Vec2 const along = other[k + 1] - other[k];
                double const t = std::clamp((outline[i] - other[k]).dot(along) / along.squaredNorm(), 0.0, 1.0);
                nearest = std::min(nearest, (other[k] + t * along - outline[i]).norm());
            }
            ++count;
            on += nearest < smoothing ? 1 : 0;
        }
    return on / count;
}

/// Half the width of a tooth, given by its outline from the left root to the right one, at the height @p y [mm].
double half_width(std::vector<Vec2> const& outline, double y)
{
    for (std::size_t k = outline.size() - 1; k > 0; --k) {
        Vec2 const &lower = outline[k], &upper = outline[k - 1];
        if (lower.y() <= y && y <= upper.y() && lower.y() < upper.y())
            return lower.x() + (y - lower.y()) / (upper.y() - lower.y()) * (upper.x() - lower.x());
    }
    return 0;
}

}  // namespace

TEST_CASE("a measured circular spline gives the flexspline back that it was made for", "[inspect]")
{
    TemporaryFolder const folder;
    Scene const scene = builtin_scene({"solver.threads=1"});
    Solution const before = solve(scene);
    PointFile const file = points_of(before.circular_spline.outline.front(), before.circular_spline.pieces, 0,
                                     scene.drive.circular_spline_teeth);
    Scene const cut = with_measured(scene, file, InspectedPart::circular_spline, folder);
    CHECK(cut.is_reverse());
    Solution const after = solve(cut);
    CHECK(std::abs(after.geometry.circular_spline_inner_radius - before.geometry.circular_spline_inner_radius) < 1e-2);
    CHECK(share_on(after.flexspline_outline, after.flexspline_pieces, before.flexspline_outline) > 0.5);
    // The largest tooth of that ring holds the one that the ring was made for. The measured ring is a smooth curve: it
    // rounds the corner of 0.16 rad where two conjugate branches meet, by at most 0.16 / 8 of the points' 4 um.
    constexpr double rounded_corner = 1e-4;
    for (Vec2 const& p : before.flexspline_outline)
        if (p.x() > 0 && p.y() < after.geometry.addendum)
            CHECK(half_width(after.flexspline_outline, p.y()) > p.x() - rounded_corner);
}

TEST_CASE("both members of a drive whose circular spline is given come back when they are measured", "[inspect]")
{
    TemporaryFolder const folder;
    Scene const scene =
        examine_scene_file(HDCONJ_SOURCE_DIR "/data/scenes/circular-spline-given.toml", {"solver.threads=1"}).scene;
    Solution const before = solve(scene);
    SECTION("the circular spline")
    {
        PointFile const file = points_of(before.circular_spline.outline.front(), before.circular_spline.pieces, 0,
                                         scene.drive.circular_spline_teeth);
        Solution const after = solve(with_measured(scene, file, InspectedPart::circular_spline, folder));
        CHECK(share_on(after.flexspline_outline, after.flexspline_pieces, before.flexspline_outline) > 0.999);
    }
    SECTION("the flexspline")
    {
        PointFile const file =
            points_of(before.flexspline_outline, before.flexspline_pieces,
                      before.geometry.r_m + before.geometry.pitch_line, scene.drive.flexspline_teeth);
        Scene const cut = with_measured(scene, file, InspectedPart::flexspline, folder);
        CHECK_FALSE(cut.is_reverse());
        CHECK(check_scene(cut).empty());
        // the same ring: its tooth stands where it was measured
        Faults faults;
        PairGeometry const ring = drive::ring_geometry(cut, drive::given_tooth(cut, faults));
        CHECK(faults.empty());
        CHECK(std::abs(ring.r_m - before.geometry.r_m) < 1e-12);
        CHECK(std::abs(ring.pitch_line - before.geometry.pitch_line) < 1e-12);
        CHECK(ring.flexspline_inner_radius == before.geometry.flexspline_inner_radius);
        // each place of the given flank that it touches, it touches twice: both contacts make the same curve again
        Solution const after = solve(cut);
        CHECK(after.certificate.certified());
        auto const touched = [&](OutlinePiece const& piece) {
            std::vector<Vec2> const& given = before.circular_spline.outline.front();
            std::size_t const middle =
                (static_cast<std::size_t>(piece.first) + static_cast<std::size_t>(piece.last)) / 2;
            return piece.kind == "flank" && given[middle].norm() < before.geometry.circular_spline_inner_radius + 0.2;
        };
        std::vector<OutlinePiece> flanks;
        std::ranges::copy_if(before.circular_spline.pieces, std::back_inserter(flanks), touched);
        REQUIRE(flanks.size() == 2);
        CHECK(share_on(before.circular_spline.outline.front(), flanks, after.circular_spline.outline.front()) > 0.9);
    }
}

TEST_CASE("a flexspline whose foot was made by the corner of the tip circle can be solved again", "[inspect]")
{
    // with the tip circle of the drive before, rounding leaves an interference of 43 nm at that corner
    Scene const scene =
        examine_scene_file(
            HDCONJ_SOURCE_DIR "/data/scenes/circular-spline-given.toml",
            {"circular_spline.profile.addendum=0.2040", "circular_spline.profile.convex_radius=0.5723",
             "circular_spline.profile.convex_rise=-0.1906", "circular_spline.profile.concave_radius=0.5044",
             "flexspline.addendum=0.2142", "wave_generator.radial_deformation=0.2213"})
            .scene;
    TemporaryFolder const folder;
    Solution const before = solve(scene);
    PointFile const file = points_of(before.flexspline_outline, before.flexspline_pieces,
                                     before.geometry.r_m + before.geometry.pitch_line, scene.drive.flexspline_teeth);
    Solution const after = solve(with_measured(scene, file, InspectedPart::flexspline, folder));
    CHECK(after.certificate.certified());
    CHECK(after.error.point < scene.solver.tolerance / 16 + 1e-12);
}

}  // namespace hdconj::test::as_tooth_cases
