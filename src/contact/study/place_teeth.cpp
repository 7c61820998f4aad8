// SPDX-License-Identifier: GPL-3.0-or-later
#include "place_teeth.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "conjugate/plane/plane_motion.hpp"
#include "elastic/bent_cup.hpp"
#include "hdconj/base/parallel.hpp"
#include "hdconj/motion/parameter_at.hpp"
#include "surface/coning.hpp"
#include "surface/section_poses.hpp"

namespace hdconj::contact {
namespace {

/// Heights between which the poses on an elastic cup are interpolated: its wall bends at the edges of the bearing.
constexpr int cup_nodes = 16;

/// Poses in the planes of the slices where the amplitude follows the linear cone.
template <class PhiOf>
void place_on_cone(ContactContext const& context, std::vector<double> const& z, PhiOf const& phi_of, ToothPoses& places)
{
    Scene const& scene = context.scene;
    std::size_t const teeth = places.pose.size() / z.size();
    surface::ConingMode const mode = surface::coning_mode(*scene.coning);
    surface::LinearAxialShift<wavegen::AnyWaveShape> const shift(context.shape, context.geometry.r_m, mode);
    std::vector<surface::AxialDisplacement> moved(teeth);
    double largest = 0;
    for (std::size_t i = 0; i < teeth; ++i) {
        moved[i] = shift(phi_of(i));
        largest = std::max(largest, std::abs(moved[i].u_z));
    }
    std::vector<surface::SliceMotion> motions;
    surface::SectionPoses const sections(
        mode.factor(z.front() - largest), mode.factor(z.back() + largest), conjugate::tooth_ratio(scene),
        [&](double factor) {
            motions.push_back(surface::slice_motion(scene, context.tooth, context.shape, factor, context.geometry.r_m));
            return motions.back().motion;
        });
    constexpr std::size_t grain = 16;
    parallel_for(teeth, context.threads, grain, [&](std::size_t i) {
        for (std::size_t k = 0; k < z.size(); ++k)
            places.pose[i * z.size() + k] =
                sections(phi_of(i), mode.factor(z[k] - moved[i].u_z), -mode.slope() * moved[i].slope);
    });
}

/// The same on the elastic cup, where the height of the wall itself says how far it moves: through the plane at z
/// passes the part that was at h with h + u_z(phi, h) = z.
template <class PhiOf>
void place_on_cup(ContactContext const& context, std::vector<double> const& z, PhiOf const& phi_of, ToothPoses& places)
{
    Scene const& scene = context.scene;
    elastic::BentCup const& cup = *context.cup;
    std::size_t const teeth = places.pose.size() / z.size();
    double const r_m = context.geometry.r_m, middle = cup.bearing().middle;
    struct Height
    {
        double h;
        double by_phi;
    };
    std::vector<Height> height(places.pose.size());
    constexpr std::size_t grain = 16;
    parallel_for(teeth, context.threads, grain, [&](std::size_t i) {
        constexpr int steps = 4;  // of Newton's method: u_z hardly depends on the height
        for (std::size_t k = 0; k < z.size(); ++k) {
            double h = z[k];
            elastic::AxialMove move;
            for (int step = 0; step < steps; ++step) {
                move = cup.axial(middle + h, r_m, phi_of(i));
                h -= (h + move.u_z - z[k]) / (1 + move.by_z);
            }
            height[i * z.size() + k] = {h, -move.by_phi / (1 + move.by_z)};
        }
    });
    auto const lower = [](Height const& a, Height const& b) { return a.h < b.h; };
    double const low = std::min_element(height.begin(), height.end(), lower)->h;
    double const high = std::max_element(height.begin(), height.end(), lower)->h;
    std::vector<surface::SliceMotion> motions;
    surface::SectionPoses const sections(
        low, high, conjugate::tooth_ratio(scene),
        [&](double h) {
            motions.push_back(context.maker.motion_at(h));
            return motions.back().motion;
        },
        cup_nodes);
    parallel_for(teeth, context.threads, grain, [&](std::size_t i) {
        for (std::size_t k = 0; k < z.size(); ++k) {
            Height const& at = height[i * z.size() + k];
            places.pose[i * z.size() + k] = sections(phi_of(i), at.h, at.by_phi);
        }
    });
}

}  // namespace

double phase_of(Scene const& scene, double wave_generator)
{
    double const pitch = 2 * std::numbers::pi / scene.drive.flexspline_teeth;
    double const phase = -wave_generator / conjugate::tooth_ratio(scene);
    return phase - pitch * std::round(phase / pitch);
}

std::vector<Pose> poses_at(ContactContext const& context, std::vector<double> const& phi, std::vector<double> const& z)
{
    Scene const& scene = context.scene;
    ToothPoses places{0, z.size(), std::vector<Pose>(phi.size() * z.size())};
    auto const phi_of = [&](std::size_t tooth) { return phi[tooth]; };
    bool const mapped = scene.maps_axial_shift();
    if (!mapped || context.maker.follows_sections()) {
        std::vector<surface::SliceMotion> const motions =
            scene.coning ? context.maker.motions_at(z) : std::vector<surface::SliceMotion>{context.maker.motion(0)};
        constexpr std::size_t grain = 64;
        parallel_for(phi.size(), context.threads, grain, [&](std::size_t i) {
            for (std::size_t k = 0; k < z.size(); ++k) {
                bool const repeated = k > 0 && !scene.coning;
                motion::AnyMotion const& motion = motions[scene.coning ? k : 0].motion;
                Pose& pose = places.pose[i * z.size() + k];
                pose = repeated ? places.pose[i * z.size()] : motion.pose(motion::parameter_at(motion, phi_of(i)));
            }
        });
    } else if (context.cup != nullptr) {
        place_on_cup(context, z, phi_of, places);
    } else {
        place_on_cone(context, z, phi_of, places);
    }
    return std::move(places.pose);
}

ToothPoses tooth_places(ContactContext const& context, double phase, std::vector<double> const& z)
{
    Scene const& scene = context.scene;
    auto const needed = teeth_needed(scene.drive.flexspline_teeth, scene.drive.circular_spline_teeth, phase);
    std::vector<double> phi;
    for (int tooth = needed[0]; tooth <= needed[1]; ++tooth)
        phi.push_back(2 * std::numbers::pi * tooth / scene.drive.flexspline_teeth + phase);
    return {needed[0], z.size(), poses_at(context, phi, z)};
}

std::shared_ptr<ToothPoses const> ToothPoseCache::operator()(ContactContext const& context, double phase,
                                                             std::vector<double> const& z)
{
    // places between end planes are even: their number tells which they are
    std::pair<double, std::size_t> const key{phase, z.size()};
    auto const known = known_.find(key);
    if (known != known_.end())
        return known->second;
    auto made = std::make_shared<ToothPoses const>(tooth_places(context, phase, z));
    constexpr std::size_t most = 64;
    if (known_.size() < most)
        known_.emplace(key, made);
    return made;
}

}  // namespace hdconj::contact
