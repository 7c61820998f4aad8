// SPDX-License-Identifier: GPL-3.0-or-later
// One slice on its way to a boundary.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "base/text.hpp"
#include "conjugate/plane/conjugate_solver.hpp"
#include "drive/stage_clock.hpp"
#include "hdconj/error.hpp"
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

/// A failure in one slice says which.
template <class Body>
void in_slice(double z, Body&& body)
{
    try {
        body();
    } catch (NumericalError const& error) {
        throw error.inside("slices", "slice at z = " + short_number(z) + " mm");
    }
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

    /// The branches of the tooth: those of @p same where that is there, the job of the same plane with another side
    /// clearance.
    void find_branches(SliceJob const* same)
    {
        if (same != nullptr)
            solve->take_branches(*same->solve);
        else
            solve->find_branches_of_tooth();
    }

    /// Down to the tip circle @p tip [mm]. The last few are kept: a part is asked for with the tip circle of the scene,
    /// with the one that it needs and with the one to which moved flanks reach, and then with the first again; a draft
    /// asks for a smaller one with each.
    [[nodiscard]] std::shared_ptr<conjugate::ToothSpaceBoundary const> boundary(double tip)
    {
        auto const known =
            std::find_if(found.begin(), found.end(), [tip](auto const& each) { return each->tip_radius() == tip; });
        if (known != found.end())
            return *known;
        out.geometry.circular_spline_inner_radius = tip;
        solve->find_boundary();
        constexpr std::size_t most = 8;
        if (found.size() == most)
            found.erase(found.begin());
        return found.emplace_back(std::make_shared<conjugate::ToothSpaceBoundary const>(solve->curve(motion.tooth)));
    }

    Solution out;
    drive::StageClock clock;
    SliceMotion motion;
    std::optional<conjugate::ConjugateSolver> solve;
    std::optional<double> pointed;  ///< ConjugateSolver::pointed_radius(), where it was asked for [mm]
    std::vector<std::shared_ptr<conjugate::ToothSpaceBoundary const>> found;  ///< the oldest first
};

}  // namespace hdconj::surface
