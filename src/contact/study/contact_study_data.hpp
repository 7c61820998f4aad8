// SPDX-License-Identifier: GPL-3.0-or-later
// The context of a study with all that it refers to.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "conjugate/plane/solve_plane.hpp"
#include "contact_context.hpp"
#include "drive/drive.hpp"
#include "hdconj/check.hpp"
#include "hdconj/scene/reading.hpp"
#include "place_teeth.hpp"
#include "surface/slice_places.hpp"

namespace hdconj::contact {

/// Refuses a scene with wrong values, and no planes @p z.
inline void require_planes(Scene const& scene, std::vector<double> const& z)
{
    throw_if_any(scene::value_faults(scene));
    if (z.empty())
        throw InputError(Fault{"z", 0, "", "there is no plane", "give the height of a plane in mm, such as 0"});
}

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

/// The pair of @p scene, which has no axial effects, solved. @param cup  on its wave generator, where it is known
[[nodiscard]] inline conjugate::SolvedPlane solved_plane(Scene scene, StageObserver const& on_stage,
                                                         std::optional<double> cup_error,
                                                         std::shared_ptr<elastic::BentCup const> cup = {})
{
    conjugate::SolvedPlane plane;
    Solution& middle = plane.solution;
    middle.scene = std::move(scene);
    middle.cup = std::move(cup);
    throw_if_any(check_scene(middle.scene));
    middle.plan = make_plan(middle.scene);
    drive::StageClock clock(middle.plan, on_stage);
    conjugate::solve_plane(plane, clock, cup_error);
    middle.timing = clock.times();
    return plane;
}

/// The pair at z = 0 with a side clearance and a tip circle [mm], from which outlines with both are made; with the cone
/// of @p scene. @param cup  as solved_plane() has it
[[nodiscard]] inline conjugate::SolvedPlane plane_with_clearance(Scene const& scene, double side_clearance, double tip,
                                                                 std::shared_ptr<elastic::BentCup const> cup)
{
    Scene middle = middle_scene(scene);
    middle.circular_spline.backlash_offset = side_clearance;
    middle.circular_spline.inner_radius = tip;
    conjugate::SolvedPlane plane = solved_plane(std::move(middle), {}, std::nullopt, std::move(cup));
    plane.solution.scene.coning = scene.coning;
    return plane;
}

/// Owns the data shared by all cases of a study.
struct ContactStudyData
{
    /// @param planes  across the face width; absent: the scene's slices
    /// @param errors  false: how well an elastic cup is known is not asked
    ContactStudyData(Scene const& asked, Verb verb, StageObserver const& on_stage, std::optional<int> planes = {},
                     bool errors = true)
        : scene(asked),
          plan(make_plan(scene, verb)),
          clock(plan, on_stage),
          plane(solved_plane(middle_scene(scene), on_stage,
                             errors ? std::optional(drive::width_of_slices(scene)) : std::nullopt)),
          threads(middle.threads)
    {
        middle.scene.coning = scene.coning;
        PairGeometry const& g = middle.geometry;
        double const width = *scene.circular_spline.width;
        int const slices = planes.value_or(scene.slices ? scene.slices->count : 1);
        maker.emplace(middle, tooth, shape, surface::slice_places(slices, width), threads);
        context.emplace(ContactContext{scene,
                                       tooth,
                                       shape,
                                       g,
                                       *maker,
                                       scene.contact.value_or(ContactRequest()),
                                       threads,
                                       width,
                                       {scene.solver.tolerance, g.r_m + g.w0 + tooth.pitch_line + tooth.addendum},
                                       clock,
                                       places,
                                       middle.cup.get()});
        clock.run(Stage::coning, [&] { maker->find_motions(maker->z().size()); });
    }
    ContactStudyData(ContactStudyData const&) = delete;
    ContactStudyData& operator=(ContactStudyData const&) = delete;

    /// The pair at z = 0 with a side clearance and a tip circle [mm]; solved once, and not where it is `middle`.
    /// @throws NumericalError where it cannot be made
    [[nodiscard]] Solution const& plane_with(double side_clearance, double tip)
    {
        if (side_clearance == 0 && tip == middle.geometry.circular_spline_inner_radius)
            return middle;
        auto known = solved.find({side_clearance, tip});
        if (known == solved.end())
            known =
                solved.try_emplace({side_clearance, tip}, plane_with_clearance(scene, side_clearance, tip, middle.cup))
                    .first;
        return known->second.solution;
    }

    Scene scene;
    Plan plan;
    drive::StageClock clock;
    conjugate::SolvedPlane plane;
    Solution& middle = plane.solution;
    profile::Profile const& tooth = plane.tooth;
    wavegen::AnyWaveShape const& shape = plane.shape;
    int threads;
    ToothPoseCache places;
    std::optional<surface::ToothSurfaceBuilder> maker;
    std::optional<ContactContext> context;

  private:
    std::map<std::pair<double, double>, conjugate::SolvedPlane> solved;  // by side clearance and tip circle
};

}  // namespace hdconj::contact
