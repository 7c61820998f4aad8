// SPDX-License-Identifier: GPL-3.0-or-later
// Exact points of the circular spline of a solved drive: solve takes the scene with the mean measured tooth. Its flanks
// are conjugate to a flexspline's, so that contacts merge where none would by chance.
#include <algorithm>
#include <array>
#include <iostream>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>

#include "hdconj/base/rigid_motion.hpp"
#include "hdconj/error.hpp"
#include "hdconj/inspect.hpp"
#include "hdconj/inspect_files.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/solve.hpp"
#include "inspect/nominal_part.hpp"
#include "support/catch.hpp"
#include "support/family_designs.hpp"
#include "support/temporary_folder.hpp"

namespace hdconj::test::measured_space_cases {
namespace {

constexpr std::array families{"straight",  "involute", "cycloid",  "s-tooth",
                              "arc-chain", "bezier",   "b-spline", "points"};

/// Which points of a flank are measured.
enum class Measured
{
    flank_pieces,  ///< every third of the outline, where a flank of the flexspline has made it
    whole_flank    ///< 60, as far apart along it
};

/// Points of four spaces of the ring.
PointFile points_of(Solution const& solution, Measured measured)
{
    std::vector<Vec2> of_space;
    auto const& outline = solution.circular_spline.outline.front();
    auto const& pieces = solution.circular_spline.pieces;
    if (measured == Measured::flank_pieces)
        for (OutlinePiece const& piece : pieces)
            for (std::size_t i = piece.first; piece.kind == "flank" && i <= piece.last; ++i)
                if ((i - piece.first) % 3 == 0 || i == piece.last)
                    of_space.push_back(outline[i]);
    if (measured == Measured::whole_flank) {
        inspect::NominalPlane const plane = inspect::plane_of_outline(outline, pieces, 0, true, 0);
        constexpr int count = 60;
        for (bool const right : {false, true})
            for (int i = 0; i < count; ++i)
                of_space.push_back(plane.flank(right).at(plane.flank(right).length() * (i + 0.5) / count).point);
    }
    PointFile file{"ring", {}, false};
    for (int const space : {0, 1, 2, 40})
        for (Vec2 const& p : of_space)
            file.points.push_back(
                {turned_clockwise(p, 2 * std::numbers::pi * space / solution.scene.drive.circular_spline_teeth), 0, 0,
                 std::nullopt, 0});
    return file;
}

/// The next drive of a family, solved.
Solution solved(designs::FamilyDesigns& draw, TemporaryFolder const& folder)
{
    return solve(examine_scene(designs::toml_of(draw.next()), "generated scene", folder.path(), {}).scene);
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

/// How far the flexspline tooth that the ring of @p drive was made for stands out of the largest tooth of that ring,
/// which @p again has [mm].
double beyond(Solution const& drive, Solution const& again)
{
    double worst = 0;
    std::size_t seen = 0;
    double const root = -again.geometry.dedendum, tip = again.geometry.addendum;
    auto const& outline = drive.flexspline_outline;
    constexpr int steps = 32;  // straight flanks have no points
    for (std::size_t k = 0; k + 1 < outline.size(); ++k)
        for (int i = 0; i < steps; ++i) {
            Vec2 const p = outline[k] + (outline[k + 1] - outline[k]) * i / steps;
            if (p.x() <= 0 || p.y() <= root || p.y() >= tip)
                continue;
            worst = std::max(worst, p.x() - half_width(again.flexspline_outline, p.y()));
            ++seen;
        }
    CHECK(seen > 20);
    return worst;
}

/// The scene whose circular spline has been measured.
Scene measured_scene(Solution const& drive, Measured measured, TemporaryFolder const& folder)
{
    Inspection const found = inspect_points(drive.scene, points_of(drive, measured),
                                            {InspectedPart::circular_spline, std::nullopt, 0, Registration::datum});
    auto reading = measured_tooth_scene(found, folder / "cut.toml");
    examine_geometry(reading);
    if (!reading.faults.empty())
        throw InputError(reading.faults);
    return reading.scene;
}

}  // namespace

TEST_CASE("solve takes a measured tooth space with root clearance", "[inspect]")
{
    TemporaryFolder const folder;
    double without = 0;
    for (std::string const clearance : {"0", "0.02", "0.05"}) {
        INFO(clearance);
        Solution const drive = solve(read_scene(HDCONJ_SOURCE_DIR "/data/scenes/straight.toml",
                                                {"circular_spline.root_clearance=" + clearance}));
        Solution const again = solve(measured_scene(drive, Measured::whole_flank, folder));
        CHECK(again.scene.circular_spline.root_clearance == 0);
        // the flanks are the same, and so is the largest tooth that they leave room for
        double const here = beyond(drive, again);
        CHECK(here < (clearance == "0" ? drive.scene.drive.module : without + 1e-6));
        without = clearance == "0" ? here : without;
    }
}

TEST_CASE("solve takes a tooth space whose points have no noise", "[inspect]")
{
    // contacts merge in a joint of the curve, curves of contact end in one point, and hang loose beyond the foot
    auto const [family, number, measured] =
        GENERATE(table<std::string, int, Measured>({{"bezier", 0, Measured::flank_pieces},
                                                    {"bezier", 1, Measured::flank_pieces},
                                                    {"b-spline", 6, Measured::flank_pieces},
                                                    {"b-spline", 8, Measured::whole_flank},
                                                    {"b-spline", 11, Measured::flank_pieces},
                                                    {"straight", 0, Measured::whole_flank}}));
    INFO(family << " " << number << (measured == Measured::whole_flank ? ", whole flank" : ", flank pieces"));
    TemporaryFolder const folder;
    designs::FamilyDesigns draw(family, 77, folder.path());
    for (int i = 0; i < number; ++i)
        (void)draw.next();
    Solution const drive = solved(draw, folder);
    Solution const again = solve(measured_scene(drive, measured, folder));
    CHECK(again.certificate.certified());
    CHECK(again.error.point < again.scene.solver.tolerance / 16 + 1e-12);
    constexpr double smoothing = 1e-6;
    CHECK(beyond(drive, again) < smoothing + drive.error.chord + again.error.chord);
}

TEST_CASE("solve takes many tooth spaces without noise", "[.][measured-spaces]")
{
    constexpr int drives = 14;
    int taken = 0, all = 0;
    for (char const* family : families) {
        TemporaryFolder const folder;
        designs::FamilyDesigns draw(family, 77, folder.path());
        for (int i = 0; i < drives; ++i) {
            Solution const drive = solved(draw, folder);
            for (Measured const measured : {Measured::flank_pieces, Measured::whole_flank}) {
                INFO(family << " " << i << (measured == Measured::whole_flank ? ", whole flank" : ", flank pieces"));
                Scene scene;
                try {
                    scene = measured_scene(drive, measured, folder);
                } catch (std::runtime_error const& error) {
                    std::cout << family << " " << i << ": no scene: " << error.what() << std::endl;
                    continue;
                }
                ++all;
                try {
                    (void)solve(scene);
                    ++taken;
                } catch (NumericalError const& error) {
                    FAIL_CHECK(error.what());
                }
            }
        }
    }
    std::cout << taken << " of " << all << " measured spaces\n";
}

}  // namespace hdconj::test::measured_space_cases
