// SPDX-License-Identifier: GPL-3.0-or-later
// Cups so short that their open end moves along the axis by more than slices are apart.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "contact/study/place_teeth.hpp"
#include "hdconj/contact.hpp"
#include "hdconj/design_files.hpp"
#include "hdconj/load.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/units.hpp"
#include "load/grids/assembled_drive.hpp"
#include "load/study/loaded_scene.hpp"
#include "support/catch.hpp"

namespace hdconj::test::short_cup_cases {
namespace {

/// A drive of 1:50 with a cup of a fifth of its @p diameter [mm]. The end of the cup moves by 0.011 of the diameter.
/// @param more  of --set
Scene short_drive(double diameter, std::vector<std::string> more)
{
    DesignWishes wishes;
    wishes.ratio = 50;
    wishes.diameter = diameter;
    wishes.length_ratio = 0.2;
    wishes.clearance = 0.0016 * diameter;
    more.insert(more.begin(), "load.torque=1");
    return parse_scene(scene_text(design_drive(wishes)), "designed", {}, more);
}

/// The same with @p slices and a circular spline as wide as that of a long cup, under @p torque [N m].
Scene wide_drive(double diameter, int slices, double torque)
{
    return short_drive(diameter, {"slices.count=" + std::to_string(slices), "load.torque=" + std::to_string(torque),
                                  "circular_spline.width=" + std::to_string(0.0935 * diameter)});
}

/// Largest distance between the teeth of `load` and those of `contact` on the assembled cup [mm].
double apart(Scene const& scene)
{
    load::LoadedDriveData const owned{load::contact_data(load::checked_scene(scene, {}), false, {})};
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

/// What `load` says of the end of the teeth.
std::optional<Note> end_of_teeth(Scene const& scene)
{
    LoadOptions options;
    options.curve = options.errors = false;
    Notes const notes = study_load(scene, options).solution.judgement;
    auto const found = std::ranges::find(notes, NoteCode::teeth_end, &Note::code);
    return found == notes.end() ? std::nullopt : std::optional(*found);
}

}  // namespace

TEST_CASE("load puts the teeth of a short cup where contact does, however close slices are", "[load][law]")
{
    // contact asks the wall itself; load has slices only, and what comes from beyond the last one continues them
    for (int const slices : {9, 17, 33, 65}) {
        INFO(slices << " slices");
        CHECK(apart(wide_drive(40, slices, 10.6)) < 0.7 * um);
    }
}

TEST_CASE("a short cup settles on close slices, and agrees with fewer", "[load][law]")
{
    LoadCase const few = loaded(wide_drive(40, 17, 10.6), ToothSurface::ruled, true);
    LoadedState const &state = few.curve.at(0), error = few.error;
    for (int const slices : {33, 65}) {
        INFO(slices << " slices");
        LoadedState const close = loaded(wide_drive(40, slices, 10.6), ToothSurface::ruled, false).curve.at(0);
        CHECK(std::abs(close.twist - state.twist) < error.twist);
        CHECK(std::abs(close.largest_force - state.largest_force) < error.largest_force);
        CHECK(close.iterations < 15);
    }
    Scene fine = wide_drive(20, 33, 5.2);
    fine.bearing->circles = 25;
    LoadedState const a = loaded(fine, ToothSurface::per_slice, false).curve.at(0);
    fine.bearing->circles = 21;
    LoadedState const b = loaded(fine, ToothSurface::per_slice, false).curve.at(0);
    CHECK(a.largest_force == Approx(b.largest_force).epsilon(0.02));
}

TEST_CASE("the largest stress of a cup with fillets converges, and is known within its error", "[load][law]")
{
    // under the sharp edge of the bearing it would grow with finer elements: 926, 964, 1003 MPa in the smaller drive
    for (double const diameter : {20.0, 50.0}) {
        LoadOptions options;
        options.curve = false;
        AssembledCup const coarse = study_load(short_drive(diameter, {"slices.count=5"}), options).cup;
        options.errors = false;
        for (char const* const circles : {"bearing.circles=25", "bearing.circles=49"}) {
            INFO(diameter << " mm, " << circles);
            AssembledCup const fine = study_load(short_drive(diameter, {"slices.count=5", circles}), options).cup;
            CHECK(std::abs(fine.largest_stress - coarse.largest_stress) < 0.8 * coarse.largest_stress_error);
            CHECK(fine.largest_stress == Approx(coarse.largest_stress).epsilon(0.06));
        }
    }
}

TEST_CASE("a circular spline beyond the teeth that a short cup pulls back is told, and the advice mends it", "[law]")
{
    std::vector<std::string> const wide{"slices.count=9", "circular_spline.width=3.74"};
    auto const note = end_of_teeth(short_drive(40, wide));
    REQUIRE(note);
    CHECK(note->severity == Severity::warning);
    // an inextensional cup says r w_0/(4 L) = 0.24 mm for the end; teeth are 4.27 mm wide
    CHECK(note->figure > 3.74 / 2 - 4.27 / 2 + 0.24);
    CHECK(note->figure < 3.74 / 2 - 4.27 / 2 + 2 * 0.24);
    REQUIRE(note->set.size() == 1);
    CHECK_FALSE(end_of_teeth(short_drive(40, {"slices.count=9", note->set[0]})));
    Scene coned = short_drive(40, wide);
    Cup const& cup = *coned.flexspline.cup;
    coned.coning = Coning{ConingModel::elastic, cup.length - cup.front_land - cup.tooth_width / 2};
    CHECK(warnings_of(study_contact(coned).solution.judgement) > 0);
    // a designed drive has no such end
    for (double const diameter : {20.0, 40.0, 80.0})
        CHECK_FALSE(end_of_teeth(short_drive(diameter, {"slices.count=9"})));
}

}  // namespace hdconj::test::short_cup_cases
