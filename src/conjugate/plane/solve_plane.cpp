// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve_plane.hpp"

#include "drive/drive.hpp"
#include "drive/elastic_cup.hpp"
#include "hdconj/base/parallel.hpp"
#include "hdconj/elastic_cup.hpp"
#include "hdconj/error.hpp"
#include "solve_motion.hpp"

namespace hdconj::conjugate {
namespace {

/// The cup on its bearing, and what is known of its error.
void solve_cup(Solution& out, wavegen::AnyWaveShape const& shape, std::optional<double> width_of_error)
{
    Scene const& scene = out.scene;
    out.cup = drive::bent_cup(scene, out.geometry.flexspline_inner_radius, shape, out.threads);
    std::optional<BentCupError> known;
    if (width_of_error) {
        known = drive::cup_error(scene, *out.cup, shape, out.geometry.r_m, *width_of_error, out.threads);
        out.error.cup = known->displacement;
    }
    out.notes.push_back(describe(*out.cup, known));
}

}  // namespace

void solve_plane(SolvedPlane& plane, drive::StageClock& clock, std::optional<double> cup_error)
{
    Solution& out = plane.solution;
    Scene const& scene = out.scene;
    Faults faults;
    out.threads = thread_count(scene.solver.threads);
    clock.run(Stage::profile, [&] {
        plane.tooth = drive::given_tooth(scene, faults);
        plane.shape = drive::wave_shape(scene, plane.tooth, faults);
        out.segment_names = plane.tooth.segment_names;
        out.geometry = drive::pair_geometry(scene, plane.tooth, plane.shape.amplitude());
    });
    if (clock.run(Stage::cup, [&] { solve_cup(out, plane.shape, cup_error); })) {
        solve_elastic(out, plane.tooth, clock);
        return;
    }
    switch (scene.solver.kinematics) {
        case Kinematics::exact:
            solve_exact(plane.shape, out, plane.tooth, clock);
            break;
        case Kinematics::first_order:
            solve_first_order(plane.shape, out, plane.tooth, clock);
            break;
        case Kinematics::material:
            solve_material(plane.shape, out, plane.tooth, clock);
            break;
    }
}

}  // namespace hdconj::conjugate
