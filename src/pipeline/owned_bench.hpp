// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A bench with all that it refers to.
#pragma once

#include <optional>
#include <utility>

#include "contact_bench.hpp"
#include "drive.hpp"
#include "hdconj/axial/slice_places.hpp"
#include "place_teeth.hpp"
#include "solve_middle.hpp"

namespace hdconj::detail {

/// What contact is asked for where the scene does not say: flanks a micrometre apart touch.
inline constexpr double standard_gap = 1e-3;  // [mm]
inline constexpr ContactRequest standard_contact{standard_gap, 200, 0, 0};

/// The pair at z = 0 without side clearance: what all surfaces start from.
[[nodiscard]] inline Scene middle_scene(Scene const& scene)
{
    Scene middle = scene;
    // the elastic cup moves z = 0 too
    if (!scene.is_elastic())
        middle.coning.reset();
    middle.tilt.reset();
    middle.slices.reset();
    middle.contact.reset();
    middle.circular_spline.automatic_backlash = false;
    middle.circular_spline.backlash_offset = 0;
    return middle;
}

/// A bench with all that it refers to.
struct OwnedBench
{
    /// @param slices  planes across the face width
    OwnedBench(Scene const& asked, int slices, Plan planned, StageObserver const& on_stage)
        : scene(asked), plan(std::move(planned)), clock(plan, on_stage), middle(solve_middle(middle_scene(scene), on_stage, plan.has(Stage::load) ? std::nullopt : std::optional(width_of_slices(scene)))), threads(middle.threads)
    {
        Faults faults;
        tooth = given_tooth(scene, faults);
        shape = wave_shape(scene, tooth, faults);
        middle.scene.coning = scene.coning;
        PairGeometry const& g = middle.geometry;
        double const width = *scene.circular_spline.width;
        maker.emplace(middle, tooth, shape, slice_places(slices, width), threads);
        bench.emplace(ContactBench{scene, tooth, shape, g, *maker, scene.contact.value_or(standard_contact), threads, width,
                                   {scene.solver.tolerance, g.r_m + g.w0 + tooth.pitch_line + tooth.addendum}, clock, places, middle.cup.get()});
        clock.run(Stage::coning, [&] { maker->find_motions(maker->z().size()); });
    }
    OwnedBench(OwnedBench const&) = delete;
    OwnedBench& operator=(OwnedBench const&) = delete;

    Scene scene;
    Plan plan;
    StageClock clock;
    Solution middle;
    int threads;
    Profile tooth;
    AnyWaveShape shape;
    PlaceCache places;
    std::optional<SurfaceMaker> maker;
    std::optional<ContactBench> bench;
};

}  // namespace hdconj::detail
