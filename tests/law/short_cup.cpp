// SPDX-License-Identifier: GPL-3.0-or-later
// Cups so short that their open end moves along the axis by more than slices are apart.
#include <algorithm>
#include <cmath>

#include "contact/study/place_teeth.hpp"
#include "hdconj/design_files.hpp"
#include "hdconj/load.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/units.hpp"
#include "load/grids/assembled_drive.hpp"
#include "load/study/loaded_scene.hpp"
#include "support/catch.hpp"

namespace hdconj::test::short_cup_cases {
namespace {

/// A drive of 1:50 with a cup of a fifth of its @p diameter [mm] and @p slices. The end moves by 0.022 of the diameter.
Scene short_drive(double diameter, int slices, double torque)
{
    DesignWishes wishes;
    wishes.ratio = 50;
    wishes.diameter = diameter;
    wishes.length_ratio = 0.2;
    wishes.clearance = 0.0016 * diameter;
    return parse_scene(scene_text(design_drive(wishes)), "designed", {},
                       {"load.torque=" + std::to_string(torque), "slices.count=" + std::to_string(slices)});
}

/// Largest distance between the teeth of `load` and those of `contact` on the assembled cup [mm].
double apart(Scene const& scene)
{
    load::LoadedDriveData const owned{load::contact_data(load::checked_scene(scene, {}), {})};
    contact::ContactContext const& context = *owned.data->context;
    load::LoadModel const model = load::load_model(context, load::load_grid(context));
    load::LoadedDrive const assembled = load::assembly(context, model.drive);
    contact::ToothPoses const &found = assembled.shape.places,
                              expected = contact::tooth_places(context, model.drive.phase, model.drive.slice_z);
    int const teeth = static_cast<int>(found.pose.size() / found.slices);
    double worst = 0;
    for (int i = found.first; i < found.first + teeth; ++i)
        for (std::size_t k = 0; k < found.slices; ++k)
            worst = std::max(worst, (found.at(i, k).origin - expected.at(i, k).origin).norm());
    return worst;
}

LoadCase loaded(Scene const& scene, ToothSurface surface, bool errors)
{
    LoadOptions options;
    options.curve = false;
    options.errors = errors;
    options.surfaces = {surface};
    return study_load(scene, options).cases.at(0);
}

}  // namespace

TEST_CASE("load puts the teeth of a short cup where contact does, however close slices are", "[load][law]")
{
    // contact asks the wall itself; load has slices only, and what comes from beyond the last one continues them
    for (int const slices : {9, 17, 33, 65}) {
        INFO(slices << " slices");
        CHECK(apart(short_drive(40, slices, 10.6)) < 0.7 * um);
    }
}

TEST_CASE("a short cup settles on close slices, and agrees with fewer", "[load][law]")
{
    LoadCase const few = loaded(short_drive(40, 17, 10.6), ToothSurface::ruled, true);
    LoadedState const &state = few.curve.at(0), error = few.error;
    for (int const slices : {33, 65}) {
        INFO(slices << " slices");
        LoadedState const close = loaded(short_drive(40, slices, 10.6), ToothSurface::ruled, false).curve.at(0);
        CHECK(std::abs(close.twist - state.twist) < error.twist);
        CHECK(std::abs(close.largest_force - state.largest_force) < error.largest_force);
        CHECK(close.iterations < 15);
    }
    Scene fine = short_drive(20, 33, 5.2);
    fine.bearing->circles = 25;
    LoadedState const a = loaded(fine, ToothSurface::per_slice, false).curve.at(0);
    fine.bearing->circles = 21;
    LoadedState const b = loaded(fine, ToothSurface::per_slice, false).curve.at(0);
    CHECK(a.largest_force == Approx(b.largest_force).epsilon(0.02));
}

}  // namespace hdconj::test::short_cup_cases
