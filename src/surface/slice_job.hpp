// SPDX-License-Identifier: GPL-3.0-or-later
// One slice on its way to a boundary.
#pragma once

#include <memory>
#include <optional>

#include "conjugate/plane/conjugate_solver.hpp"
#include "drive/stage_clock.hpp"
#include "slice_motion.hpp"

namespace hdconj::surface {

/// What is known of a slice before it is solved: the scene in one plane, with the amplitude of that plane.
[[nodiscard]] inline Solution unsolved_slice(Solution const& base, double amplitude, int threads)
{
    Solution out;
    out.scene = base.scene;
    out.scene.coning.reset();
    out.scene.tilt.reset();
    out.scene.slices.reset();
    out.scene.contact.reset();
    out.plan = make_plan(out.scene);
    out.geometry = base.geometry;
    out.geometry.w0 = amplitude;
    out.segment_names = base.segment_names;
    out.threads = threads;
    return out;
}

/// One slice on its way to a boundary: a drive of its own without axial effects, with all that its solver refers to.
struct SliceJob
{
    SliceJob(Solution const& base, SliceMotion const& slice, int threads)
        : out(unsolved_slice(base, slice.amplitude, threads)), clock(out.plan, {}), motion(slice)
    {
        solve.emplace(out, *motion.tooth, motion.motion, clock);
    }
    SliceJob(SliceJob const&) = delete;
    SliceJob& operator=(SliceJob const&) = delete;

    /// Down to the tip circle @p tip [mm]; the last one is kept for who asks next.
    [[nodiscard]] std::shared_ptr<conjugate::ToothSpaceBoundary const> boundary(double tip)
    {
        if (!found || found->tip_radius() != tip) {
            out.geometry.circular_spline_inner_radius = tip;
            solve->find_boundary();
            found = std::make_shared<conjugate::ToothSpaceBoundary const>(solve->curve(motion.tooth));
        }
        return found;
    }

    Solution out;
    drive::StageClock clock;
    SliceMotion motion;
    std::optional<conjugate::ConjugateSolver> solve;
    double pointed = 0;  ///< ConjugateSolver::pointed_radius() [mm]
    std::shared_ptr<conjugate::ToothSpaceBoundary const> found;
};

}  // namespace hdconj::surface
