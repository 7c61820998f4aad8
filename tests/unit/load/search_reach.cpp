// SPDX-License-Identifier: GPL-3.0-or-later
#include "load/study/search_reach.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <tuple>
#include <vector>

#include "hdconj/read_scene.hpp"
#include "hdconj/units.hpp"
#include "load/grids/assembled_drive.hpp"
#include "load/study/load_case.hpp"
#include "load/study/torque_continuation.hpp"
#include "support/catch.hpp"

namespace hdconj::test::search_reach_cases {

namespace {

/// A small elastic drive on its wave generator.
struct Drive
{
    load::LoadedDriveData owned{load::contact_data(
        load::checked_scene(
            builtin_scene({"slices.count=3", "contact.flank_points=60", "bearing.circles=5", "tilt.angle_deg=0.1"}),
            {}),
        false, {})};
    contact::ContactContext const& context = *owned.data->context;
    load::LoadGrid grid = load::load_grid(context);
    load::LoadModel model = load::load_model(context, grid);
    load::AssembledDrive assembled{grid, model, load::assembly(context, model.drive)};
    load::SurfaceWithPlay surface =
        load::surface_with_play(context, assembled, {ToothSurface::tilted, TiltKind::radial, 0.1 * deg});
    load::LoadProblem problem = load::load_problem(context, model.drive, surface.surface.grid);
    load::TorqueContinuation path = load::torque_continuation(problem, assembled.unloaded, surface.play);

    [[nodiscard]] load::LoadedDrive at(double torque_nm) const
    {
        return load::advance(path, path.start, torque_nm * newton_metre);
    }
    [[nodiscard]] std::vector<load::FlankContact> contacts(load::LoadedShape const& shape, double turn, double limit,
                                                           load::GapBounds* known = nullptr) const
    {
        return load::flank_contacts(load::gap_field(problem, shape, problem.edges),
                                    load::flank_search(problem, turn, limit), 1, known);
    }
};

auto flank_of(load::FlankContact const& c)
{
    return std::tuple(c.space, c.flank, c.slice);
}

}  // namespace

TEST_CASE("no gap falls by more than the bound between two shapes and turns", "[load]")
{
    Drive const drive;
    std::mt19937 random(20261126);
    std::uniform_real_distribution<double> turn(-1e-4, 1e-4);
    load::LoadedDrive const light = drive.at(1), heavy = drive.at(30);
    for (int run = 0; run < 4; ++run) {
        double const from_turn = light.state.turn + turn(random), to_turn = heavy.state.turn + turn(random);
        double const fall = load::largest_fall(drive.problem, light.shape, from_turn, heavy.shape, to_turn);
        contact::GapField const from = load::gap_field(drive.problem, light.shape, drive.problem.edges),
                                to = load::gap_field(drive.problem, heavy.shape, drive.problem.edges);
        double largest = 0;
        for (std::size_t space = 0; space < from.spaces(); space += 3)
            for (int const flank : {0, 1})
                for (std::size_t k = 0; k < drive.problem.edges.slices(); ++k)
                    for (std::size_t i = 0; i < drive.problem.edges.points(); i += 10)
                        largest = std::max(largest, std::abs(to.gap({space, flank, k, i}, to_turn) -
                                                             from.gap({space, flank, k, i}, from_turn)));
        CAPTURE(fall, largest);
        CHECK(largest <= fall);
        CHECK(largest >= 0.1 * fall);
    }
}

TEST_CASE("bounds of gaps leave out no contact and save flanks", "[load]")
{
    Drive const drive;
    load::LoadedDrive const light = drive.at(1), heavy = drive.at(30);
    load::GapBounds known;
    double const wide = load::search_limit(drive.problem);
    (void)drive.contacts(light.shape, light.state.turn, wide, &known);
    known.lower(load::largest_fall(drive.problem, light.shape, light.state.turn, heavy.shape, heavy.state.turn));
    for (double const limit : {wide, wide / 10, wide / 100, 0.0}) {
        std::vector<load::FlankContact> const all = drive.contacts(heavy.shape, heavy.state.turn, limit),
                                              found = drive.contacts(heavy.shape, heavy.state.turn, limit, &known);
        CAPTURE(limit);
        REQUIRE(!all.empty());
        REQUIRE(found.size() == all.size());
        for (std::size_t i = 0; i < all.size(); ++i) {
            CHECK(flank_of(found[i]) == flank_of(all[i]));
            CHECK(found[i].arc_length == all[i].arc_length);
            CHECK(found[i].gap == all[i].gap);
        }
    }
}

TEST_CASE("a settled torque has its far contacts too, without force and in order", "[load]")
{
    Drive const drive;
    double const wide = load::search_limit(drive.problem);
    for (double const torque : {1.0, 30.0}) {
        load::LoadedDrive const loaded = drive.at(torque);
        REQUIRE(loaded.state.flank.size() == loaded.contacts.size());
        CHECK(std::ranges::is_sorted(loaded.contacts, {}, [](load::FlankContact const& c) {
            return std::tuple(c.space, c.flank, c.slice, c.arc_length);
        }));
        // the shape of the last step differs from the settled one by nanometres
        double const apart = 10 * load::gap_tolerance(drive.problem);
        std::size_t far = 0;
        for (load::FlankContact const& c : drive.contacts(loaded.shape, loaded.state.turn, wide - apart)) {
            far += c.gap > wide / 4;
            auto const same = std::ranges::find_if(
                loaded.contacts, [&](load::FlankContact const& other) { return flank_of(other) == flank_of(c); });
            CHECK(same != loaded.contacts.end());
        }
        CHECK(far > 20);
    }
}

}  // namespace hdconj::test::search_reach_cases
