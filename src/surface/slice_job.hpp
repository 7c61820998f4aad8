// SPDX-License-Identifier: GPL-3.0-or-later
// One slice on its way to a boundary.
#pragma once

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

    Solution out;
    drive::StageClock clock;
    SliceMotion motion;
    std::optional<conjugate::ConjugateSolver> solve;
};

}  // namespace hdconj::surface
