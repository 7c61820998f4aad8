// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve_plane.hpp"

#include <algorithm>
#include <limits>

#include "conjugate_solver.hpp"
#include "drive/drive.hpp"
#include "drive/elastic_cup.hpp"
#include "hdconj/base/parallel.hpp"
#include "hdconj/elastic_cup.hpp"
#include "hdconj/envelope/avoid_stationary_centres.hpp"
#include "hdconj/error.hpp"
#include "judgement/judgement.hpp"
#include "plane_motion.hpp"

namespace hdconj::conjugate {
namespace {

/// The cup on its bearing, and what is known of its error.
void solve_cup(Solution& out, wavegen::AnyWaveShape const& shape, std::optional<double> width_of_error)
{
    Scene const& scene = out.scene;
    if (!out.cup)
        out.cup = drive::bent_cup(scene, out.geometry.flexspline_inner_radius, shape, out.threads);
    std::optional<BentCupError> known;
    out.error.cup = std::numeric_limits<double>::quiet_NaN();
    if (width_of_error) {
        known = drive::cup_error(scene, *out.cup, shape, out.geometry.r_m, *width_of_error, out.threads);
        out.error.cup = known->displacement;
    }
    if (std::string const note = describe(*out.cup, known); !note.empty())
        out.notes.push_back(note);
}

/// Solves the pair of @p plane, whose tooth, shape and dimensions are known.
void solve_pair(SolvedPlane& plane, drive::StageClock& clock, std::optional<double> cup_error)
{
    Solution& out = plane.solution;
    bool const elastic = clock.run(Stage::cup, [&] { solve_cup(out, plane.shape, cup_error); });
    motion::AnyMotion const motion = elastic ? elastic_plane_motion(out, clock) : plane_motion(plane.shape, out, clock);
    if (out.scene.is_reverse())
        return solve_reverse(out, plane.tooth, motion, clock);
    profile::Profile const clear = envelope::avoid_stationary_centres(plane.tooth, motion);
    ConjugateSolver(out, clear, motion, clock)(plane.tooth);
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
    judgement::UnsolvedPair const pair{scene, out.geometry, plane.tooth, plane.shape};
    Notes const notes = judgement::notes_on(pair);
    try {
        solve_pair(plane, clock, cup_error);
    } catch (NumericalError const& error) {
        throw judgement::with_likely_cause(error, pair);
    }
    for (Notes const& more : {notes, judgement::notes_on(out)})
        out.judgement.insert(out.judgement.end(), more.begin(), more.end());
    std::ranges::stable_sort(out.judgement, {}, &Note::code);
    judgement::agree_on_tip_circle(pair, out.judgement);
}

}  // namespace hdconj::conjugate
