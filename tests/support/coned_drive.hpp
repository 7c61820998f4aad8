// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A drive with slices, taken apart: what the verb contact is made of, for tests of single rooms.
#pragma once

#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "contact/clearance/part_flanks.hpp"
#include "contact/flank_deviation.hpp"
#include "contact/gap_field.hpp"
#include "contact/study/contact_case.hpp"
#include "contact/study/place_teeth.hpp"
#include "contact/study/refined_flanks.hpp"
#include "drive/drive.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/solve.hpp"
#include "support/oracle/motion.hpp"
#include "surface/coning.hpp"
#include "surface/slice_places.hpp"

namespace hdconj::test {

/// Keys of the linear coning of type-50 (design 3.4).
inline std::vector<std::string> coned(std::string const& axial_shift = "none", double bottom_to_middle = 9.0)
{
    return {"coning.model=linear", "coning.bottom_to_middle=" + std::to_string(bottom_to_middle),
            "coning.apex_height=0.43", "coning.axial_shift=" + axial_shift};
}

inline std::vector<std::string> with(std::vector<std::string> keys, std::vector<std::string> const& more)
{
    keys.insert(keys.end(), more.begin(), more.end());
    return keys;
}

inline std::string file_of(std::string const& scene_name)
{
    return std::string(HDCONJ_SOURCE_DIR) + "/data/scenes/" + scene_name + ".toml";
}

class ConedDrive
{
  public:
    ConedDrive(Scene const& given, int slices, int threads = 1, double face_width = 7.0)
        : scene(given),
          plan(make_plan(given, Verb::contact)),
          clock(plan, observer),
          middle(solve(without_axial_effects(given)))
    {
        Faults faults;
        tooth = drive::given_tooth(scene, faults);
        shape = drive::wave_shape(scene, tooth, faults);
        if (!faults.empty())
            throw InputError(faults);
        middle.scene.coning = scene.coning;
        maker.emplace(middle, tooth, shape, surface::slice_places(slices, face_width), threads);
        context.emplace(contact::ContactContext{
            scene,
            tooth,
            shape,
            middle.geometry,
            *maker,
            {1e-3, 200, 0, 0},
            threads,
            face_width,
            {scene.solver.tolerance, middle.geometry.r_m + middle.geometry.w0 + tooth.pitch_line + tooth.addendum},
            clock,
            places});
    }
    ConedDrive(ConedDrive const&) = delete;
    ConedDrive& operator=(ConedDrive const&) = delete;

    [[nodiscard]] int z_f() const { return scene.drive.flexspline_teeth; }
    [[nodiscard]] int z_c() const { return scene.drive.circular_spline_teeth; }
    [[nodiscard]] double pitch() const { return 2 * std::numbers::pi / z_c(); }
    [[nodiscard]] std::vector<double> const& z() const { return maker->z(); }
    [[nodiscard]] double factor(std::size_t k) const
    {
        return scene.coning ? surface::coning_mode(*scene.coning).factor(z()[k]) : 1.0;
    }

    [[nodiscard]] conjugate::MatchedOutline surface(ToothSurface kind_of_surface, TiltKind kind = TiltKind::radial,
                                                    double tilt = 0, double chord = 1e-6, int intervals = 200)
    {
        surface::SurfaceSpec const choice{kind_of_surface, kind, tilt};
        return maker->outline(choice, maker->needed_tip(choice).radius, {chord, intervals, true});
    }
    [[nodiscard]] contact::FlankGrid flanks(conjugate::MatchedOutline const& outline, int points = 200) const
    {
        return contact::flank_grid(outline, z(), points);
    }

    /// Flanks that reach the tip circle @p tip when they are moved by @p distance, at about @p points places.
    [[nodiscard]] contact::FlankGrid flanks_to_tip(surface::SurfaceSpec const& choice, double tip, double distance,
                                                   int points)
    {
        contact::ContactContext fine = *context;
        fine.request.flank_points = points;
        contact::CaseSurface const surface(fine, choice);
        return contact::part_flanks(surface, surface.outline(tip), tip, distance).grid;
    }

    /// A slice as a drive of its own, for the oracle, whose motion and tooth are not the program's.
    [[nodiscard]] Scene slice_scene(std::size_t k) const
    {
        Scene slice = without_axial_effects(scene);
        for (auto& [key, given] : slice.wave_generator.shape.given)
            if (key == "radial_deformation")
                given.value = slice.wave_generator.shape.number("radial_deformation").value() * factor(k);
        return slice;
    }

    Scene scene;
    Plan plan;
    StageObserver observer;
    drive::StageClock clock;
    contact::ToothPoseCache places;
    Solution middle;
    profile::Profile tooth;
    wavegen::AnyWaveShape shape;
    std::optional<surface::ToothSurfaceBuilder> maker;
    std::optional<contact::ContactContext> context;

  private:
    static Scene without_axial_effects(Scene scene)
    {
        scene.coning.reset();
        scene.tilt.reset();
        scene.slices.reset();
        scene.contact.reset();
        scene.circular_spline.automatic_backlash = false;
        scene.circular_spline.backlash_offset = 0;
        return scene;
    }
};

/// The oracle's parameter for an undeformed angle, by bisection.
inline double oracle_parameter(oracle::Motion<double> const& motion, double phi)
{
    double low = phi - 0.2, high = phi + 0.2;
    for (int i = 0; i < 80; ++i) {
        double const s = 0.5 * (low + high);
        (motion.phi(s) < phi ? low : high) = s;
    }
    return 0.5 * (low + high);
}

/// A drive with one outline on three slices, and its gaps for any deviation.
struct ConedFlanks
{
    ConedDrive drive{builtin_scene(coned()), 3};
    contact::FlankGrid grid = drive.flanks(drive.surface(ToothSurface::tilted), 60);
    contact::ToothPoses places = contact::tooth_places(*drive.context, 0, drive.context->maker.z());

    [[nodiscard]] contact::GapField field(contact::FlankDeviation const* deviation) const
    {
        return {
            drive.tooth, grid,     places, drive.scene.drive.flexspline_teeth, drive.scene.drive.circular_spline_teeth,
            0,           deviation};
    }
};

}  // namespace hdconj::test
